#pragma once
// How far a run has come, in one line that is written over and over and erased at the end.

#include <chrono>
#include <ostream>
#include <string>

#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom::app {

/// `text` behind a bar for the share that is done, and the time left where that is known, cut to fit `columns`. A share of 0
/// is not known.
[[nodiscard]] std::string progress_line(const std::string& text, double share, double seconds, int columns);

class Progress {
 public:
  /// Writes to `screen`, once the run has lasted over a second; nullptr: nothing is shown.
  Progress(std::ostream* screen, const RunSpec& run);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const Simulation& simulation);
  /// `share` of `what` is done, 0..1.
  void show(const std::string& what, double share);

  [[nodiscard]] double seconds() const;  ///< [s] since construction

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool due();
  void write(const std::string& text, double done) const;
  [[nodiscard]] double fraction_done(const Simulation& simulation) const;

  std::ostream* screen_;
  const RunSpec& run_;
  Clock::time_point begin_ = Clock::now();
  double shown_at_ = 0.0;  // [s]
};

}  // namespace carom::app
