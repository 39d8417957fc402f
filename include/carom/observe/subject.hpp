#pragma once
// What observers know of the balls and the space that they watch, in the user's units.

#include <array>
#include <cstdint>
#include <vector>

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
  double epoch_length = 1.0;            ///< [time]
  std::uint32_t walls = 0;              ///< [[wall]]s: the faces of a box have the numbers after them
  bool merging = false;                 ///< two balls that collide are one afterwards
  std::vector<double> mass;             ///< by ball number; 0: has left
  std::vector<double> radius;           ///< [length] by ball number
  std::vector<Triple> velocity;         ///< [length/time] by ball number, at the time that is looked at
  std::int64_t free = 0;                ///< balls that move freely

  [[nodiscard]] bool moves_freely(std::uint32_t ball) const;
  [[nodiscard]] bool accelerated() const { return acceleration != Triple{}; }
  [[nodiscard]] bool has_obstacles() const;
  [[nodiscard]] double volume() const { return edge[0] * edge[1] * edge[2]; }
};

/// The balls as they are now. `scene` is that of the simulation.
[[nodiscard]] Subject subject_of(const Scene& scene, const Simulation& simulation);

}  // namespace carom
