#pragma once
// What observers know of the balls and the space that they watch, in the user's units.

#include <array>
#include <cstdint>
#include <vector>

#include "carom/core/clock.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

using Triple = std::array<double, 3>;  ///< a vector; components beyond the dimension are 0

/// A ball *moves freely* if its mass is finite; balls of infinite mass are obstacles, as walls are.
struct Subject {
  int dimension = 2;
  SpaceKind space = SpaceKind::open;
  std::array<double, 3> edge{1, 1, 1};  ///< [length] of the box or the cell; 1 beyond the dimension
  Triple acceleration{};                ///< [length/time^2]
  double magnetic = 0.0;                ///< [rad/time] rate at which velocities turn; 2-D
  double epoch_length = 1.0;            ///< [time]
  Time<double> moment{};                ///< [epoch_length] the time that is looked at
  std::uint32_t walls = 0;              ///< [[wall]]s: the faces of a box have the numbers after them
  bool merging = false;                 ///< two balls that collide are one afterwards
  std::vector<double> mass;             ///< by ball number; 0: has left
  std::vector<double> radius;           ///< [length] by ball number
  std::vector<Triple> position;         ///< [length] by ball number, not wrapped, at the time that is looked at
  std::vector<Triple> velocity;         ///< [length/time] by ball number, then too
  std::int64_t free = 0;                ///< balls that move freely

  [[nodiscard]] bool moves_freely(std::uint32_t ball) const;
  [[nodiscard]] bool accelerated() const { return acceleration != Triple{}; }
  /// Velocities change in flight.
  [[nodiscard]] bool bends() const { return accelerated() || magnetic != 0; }
  [[nodiscard]] bool has_obstacles() const;
  [[nodiscard]] double volume() const { return edge[0] * edge[1] * edge[2]; }
};

/// The time t [time] on the clock of a run whose epochs last `epoch_length`; `never` beyond its end.
[[nodiscard]] Time<double> moment_of(double t, double epoch_length);

/// The balls as they are now. `scene` is that of the simulation.
[[nodiscard]] Subject subject_of(const Scene& scene, const Simulation& simulation);

}  // namespace carom
