#pragma once
// Radii that grow: r0 + gamma (t - t0), with t0 the world's start.

#include <cstdint>
#include <vector>

#include "carom/core/clock.hpp"

namespace carom {

/// How the balls of a world grow, and what the scene asks of it. A world whose balls keep their sizes has no rates.
template <class Real>
struct Growth {
  std::vector<Real> rates;                  ///< gamma [length unit / L] by ball number, >= 0; empty: none grows
  Time<Real> packed = Time<Real>::never();  ///< when the packing fraction is the one to stop at
  Time<Real> full = Time<Real>::never();    ///< when a ball would touch its own image in a periodic space
  Real pressure = Real(0);                  ///< reduced pressure to stop at [-]; 0: none
  std::int64_t rescale_every = 0;           ///< collisions between two rescalings of the velocities; 0: none

  [[nodiscard]] bool any() const noexcept { return !rates.empty(); }
};

/// Radius of ball i at t. WorldLike: World, or a view with its members.
template <class WorldLike, class Real>
[[nodiscard]] inline Real radius_at(const WorldLike& world, std::uint32_t i, const Time<Real>& t) {
  const Real start = world.balls[i].radius;
  if constexpr (requires { world.growth; })
    if (world.growth.any()) return start + world.growth.rates[i] * elapsed(world.start, t);
  return start;
}

/// gamma of ball i.
template <class WorldLike>
[[nodiscard]] inline auto growth_of(const WorldLike& world, std::uint32_t i) {
  using Real = std::remove_cvref_t<decltype(world.balls[i].radius)>;
  if constexpr (requires { world.growth; })
    if (world.growth.any()) return Real(world.growth.rates[i]);
  return Real(0);
}

}  // namespace carom
