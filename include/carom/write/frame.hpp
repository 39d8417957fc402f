#pragma once
// A frame: where every ball is at one moment, as trajectories hold it and as it is read back.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// The books of a run at one moment.
struct FrameBooks {
  std::int64_t collisions = 0;          ///< so far
  double energy = 0.0;                  ///< kinetic + potential
  double dissipated = 0.0;              ///< so far, by impacts
  double injected = 0.0;                ///< so far, by moving walls, balls of infinite mass, growth and rescaling
  double imbalance = 0.0;               ///< energy + dissipated - initial - injected, rounded once
  double imbalance_ulp = 0.0;           ///< the same in units in the last place of the initial energy; nan if that is 0
  std::vector<Number> momentum;
};

struct TrajectoryFrame {
  Number time = 0.0;
  std::vector<BallState> balls;     ///< those that are left, smaller numbers first
  std::optional<FrameBooks> books;  ///< none: not known
};

/// What all frames of a trajectory have in common.
struct TrajectoryHead {
  std::string title;
  int dimension = 2;
  SpaceKind space = SpaceKind::open;
  std::array<double, 3> lower{}, upper{};  ///< [length] of a box or periodic space
  double epoch_length = 0.0;               ///< [time]; 0: not known
  std::uint32_t balls = 0;                 ///< their numbers are below this
  bool varying = false;                    ///< balls leave, or masses and radii change
  bool growing = false;                    ///< radii grow: a ball stays of the kind that it was in its first frame
  bool velocities = true;                  ///< known; else they are left out of what is written
  bool radii = true;                       ///< known; else 0
};

enum class Books { left_out, kept };

/// At the time that the simulation has reached.
[[nodiscard]] TrajectoryFrame frame_of(const Simulation& simulation, Books books = Books::left_out);

/// `scene` is that of the simulation.
[[nodiscard]] TrajectoryHead head_of(const Scene& scene, const Simulation& simulation);

}  // namespace carom
