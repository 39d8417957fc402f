#pragma once
// Frames as a table: where every ball is at some moments.

#include <cstdint>
#include <string>

#include "carom/sim/simulation.hpp"
#include "carom/write/output_file.hpp"

namespace carom {

/// Columns: time, ball, position (x, y, z), image (ix, ..), velocity (vx, ..); one line a ball and frame. In a periodic
/// space positions are wrapped and images count the wraps. Comments as in EventsCsv.
class TrajectoryCsv {
 public:
  /// Throws OutputError.
  TrajectoryCsv(std::string path, const Simulation& simulation, const std::string& title);

  /// The balls that are left, at the time that the simulation has reached.
  void write_frame(const Simulation& simulation);

  [[nodiscard]] bool failed() const noexcept { return file_.failed(); }

  /// Ends the table. Throws OutputError if anything of it could not be written.
  void finish(Stop stopped_by);

 private:
  OutputFile file_;
  std::int64_t frames_ = 0;
};

}  // namespace carom
