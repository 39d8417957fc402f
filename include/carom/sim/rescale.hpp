#pragma once
// Velocities scaled back to the kinetic energy of the start, where growth heats.

#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/sim/growth_books.hpp"
#include "carom/sim/measures.hpp"
#include "carom/world/state.hpp"

namespace carom {

/// At the moment t every velocity of a ball of finite mass is multiplied by sqrt(K_start / K), each component rounded once;
/// what that adds to the kinetic energy K, and it may be negative, is booked as injected. A scheduled event: contacts
/// stay, and act again if the surfaces now approach. Returns the balls that were written.
template <Motion M, class Collider>
std::vector<std::uint32_t> rescale(World<typename M::Real, M::dimension>& world, const M& motion, Collider& collider,
                                   const Time<typename M::Real>& t) {
  using Real = typename M::Real;
  using std::sqrt;
  constexpr int D = M::dimension;
  std::vector<std::uint32_t> written;
  const Wide<Real> before = totals_at(motion, world, t).kinetic;
  if (!(narrow(before) > 0)) return written;
  const Real factor = sqrt(narrow(Wide<Real>(collider.growth.kinetic / before)));
  for (std::uint32_t i = 0; i < world.balls.size(); ++i) {
    if (!world.balls[i].alive || detail::infinite(world.details[i].mass)) continue;
    const Vec<Real, D> v = velocity_at(motion, world, i, t) * factor;
    write_motion(world, motion, i, position_at(motion, world, i, t), v, t, written);
  }
  inject(collider.books, Wide<Real>(totals_at(motion, world, t).kinetic - before));
  ++collider.counts.other;
  return written;
}

}  // namespace carom
