#pragma once
// Frames as a table: where every ball is at some moments.

#include <cstdint>
#include <string>

#include "carom/write/output_file.hpp"
#include "carom/write/trajectory.hpp"

namespace carom {

/// Columns: time, ball, position (x, y, z), image (ix, ..), velocity (vx, ..), radius, mass; one line a ball and frame. In a
/// periodic space positions are wrapped and images count the wraps. What is not known is left out. Comments as in EventsCsv,
/// and the space.
class TrajectoryCsv final : public Trajectory {
 public:
  /// Throws OutputError.
  TrajectoryCsv(std::string path, const TrajectoryHead& head);

  void write(const TrajectoryFrame& frame) override;
  [[nodiscard]] bool failed() const noexcept override { return file_.failed(); }
  void finish(const Ending& ending) override;

 private:
  OutputFile file_;
  bool velocities_, radii_;
  std::int64_t frames_ = 0;
};

}  // namespace carom
