#pragma once
// The checkpoints that a run leaves behind: as often as the scene asks, at the end, and on Ctrl-C.

#include <string>

#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom::app {

class Checkpoints {
 public:
  /// `file` of the command line goes before that of the scene; `folder` is that of --out. Neither named: no checkpoints.
  Checkpoints(const Scene& scene, const std::string& file, const std::string& folder, const Simulation& simulation);

  /// A pause in the run: writes one if it is due. What fails is told at the end.
  void look(const Simulation& simulation);
  /// Writes the last one. What could not be written; empty: nothing.
  [[nodiscard]] std::string finish(const Simulation& simulation);

 private:
  void write(const Simulation& simulation);

  std::string path_;
  double every_time_ = 0, next_time_ = 0;
  std::int64_t every_events_ = 0, next_events_ = 0;
  std::string failure_;
};

}  // namespace carom::app
