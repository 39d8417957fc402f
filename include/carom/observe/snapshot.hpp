#pragma once
// All balls at one moment, for measures that look at all of them at once.

#include <cstdint>
#include <vector>

#include "carom/observe/subject.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// The balls of finite mass that have not left, in the order of their numbers.
struct Snapshot {
  double time = 0.0;              ///< [time]
  std::int64_t ball_ball = 0;     ///< collisions of two balls so far
  std::vector<Triple> position;   ///< [length] not wrapped
  std::vector<Triple> velocity;   ///< [length/time]
  double kinetic = 0.0;           ///< [energy] sum of m v^2 / 2

  [[nodiscard]] std::size_t size() const noexcept { return position.size(); }
};

/// The balls at the simulation's time. `balls` lends its memory.
void look_at(const Simulation& simulation, Snapshot& balls);

}  // namespace carom
