#pragma once
// Frames as extended XYZ, which OVITO, ASE and QUIP read.

#include <map>
#include <string>
#include <utility>

#include "carom/write/output_file.hpp"
#include "carom/write/trajectory.hpp"

namespace carom {

/// A frame: the number of balls; a line of KEY=VALUE with Lattice and Origin (of a box or periodic space), pbc, Properties,
/// Time and dimension; then a line a ball: species, position, velocity, radius, mass, number and, in a periodic space,
/// images (map_shift); what is not known is left out. The format has three dimensions: components beyond the scene's are 0, and the cell is as thick there
/// as the largest ball.
///
/// Readers insist on chemical symbols. The species is the number of the ball's (radius, mass), in order of appearance, as a
/// chemical element: H, He, Li, ... and X beyond the last. It says nothing else. A ball that grows keeps its species.
///
/// The format has no end mark: that a file has its name says that it is whole.
class ExtendedXyz final : public Trajectory {
 public:
  /// Throws OutputError.
  ExtendedXyz(std::string path, TrajectoryHead head);

  void write(const TrajectoryFrame& frame) override;
  [[nodiscard]] bool failed() const noexcept override { return file_.failed(); }
  void finish(const Ending& ending) override;

 private:
  void append_space(const TrajectoryFrame& frame);
  void append_ball(const BallState& ball);
  [[nodiscard]] std::string_view species(const BallState& ball);

  OutputFile file_;
  TrajectoryHead head_;
  double thickness_ = 0.0;  // of the cell beyond the scene's dimensions; 0: not chosen yet
  std::map<std::pair<double, double>, std::size_t> species_;
  std::map<std::uint32_t, double> first_radius_;  // by ball number, where balls grow
};

}  // namespace carom
