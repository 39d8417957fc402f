#pragma once
// Laws stick and merge: the bodies of two balls that meet go on together.

#include "carom/law/impact.hpp"
#include "carom/predict/event.hpp"
#include "carom/sim/join.hpp"
#include "carom/sim/totals.hpp"
#include "carom/sim/wall_party.hpp"

namespace carom {

/// A finite mass m that an infinite one absorbs leaves all sums, with its whole energy.
template <class Real, int D>
inline void absorb(const World<Real, D>& world, Outcome<Real, D>& outcome, const Real& m, std::uint32_t i,
                   const Vec<Real, D>& v, const Vec<Real, D>& x) {
  using W = Wide<Real>;
  const auto far = unwrapped(world, i, x);
  W energy(Real(0));
  for (int k = 0; k < D; ++k)
    energy = energy + wide_product<Real>(v[k], v[k]) * W(Real(1) / 2) - far[k] * W(world.acceleration[k]);
  outcome.dissipated = W(m) * energy;
  outcome.injected = W(Real(0));
}

/// In a periodic space under acceleration the mass m of ball j is counted from now on in the periods of ball i. What that
/// changes in its potential, which is defined up to whole periods only, is booked with what the impact dissipates.
template <Motion M>
inline void recount(const World<typename M::Real, M::dimension>& world, Outcome<typename M::Real, M::dimension>& outcome,
                    const Event<typename M::Real, M::dimension>& event, const typename M::Real& m) {
  using Real = typename M::Real;
  using W = Wide<Real>;
  if (!world.space.periodic() || !M::accelerated) return;
  for (int k = 0; k < M::dimension; ++k) {
    const std::int64_t turns = event.image[k] + world.details[event.ball].image[k] - world.details[event.partner].image[k];
    outcome.dissipated =
        outcome.dissipated + W(m) * W(world.acceleration[k]) * wide_product<Real>(Real(turns), world.space.edge[k]);
  }
}

/// The bodies of balls event.ball, at xa, and event.partner, at xb, become one.
template <Motion M>
Outcome<typename M::Real, M::dimension> unite(World<typename M::Real, M::dimension>& world, const M& motion,
                                              const Event<typename M::Real, M::dimension>& event,
                                              const Impact<typename M::Real, M::dimension>& impact,
                                              const typename M::Vector& xa, const typename M::Vector& xb,
                                              std::vector<std::uint32_t>& written) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  const std::uint32_t i = event.ball, j = event.partner;
  const Common<Real, D> common = common_velocity(impact.ma, impact.va, impact.mb, impact.vb);
  Outcome<Real, D> outcome{common.velocity, common.velocity, common.impulse, common.dissipated, common.injected};
  Vec<Real, D> beside = xb;
  if (world.space.periodic())
    for (int k = 0; k < D; ++k) beside[k] += Real(event.image[k]) * world.space.edge[k];
  if (world.law == LawKind::stick) {
    join_bodies(world, motion, i, xa, j, beside, event.image, common.velocity, event.time, written);
  } else {
    if (detail::infinite(impact.ma)) absorb(world, outcome, impact.mb, j, impact.vb, xb);
    if (detail::infinite(impact.mb)) absorb(world, outcome, impact.ma, i, impact.va, xa);
    if (!detail::infinite(impact.ma) && !detail::infinite(impact.mb)) recount<M>(world, outcome, event, impact.mb);
    merge_balls(world, motion, i, xa, j, beside, common.velocity, event.time, written);
  }
  return outcome;
}

/// Whether ball i, which has just grown, still has room between the walls.
template <class Real, int D>
[[nodiscard]] bool has_room(const World<Real, D>& world, std::uint32_t i, const Time<Real>& now) {
  bool fits = true;
  world.walls.for_each([&](const auto& shape) {
    const Vec<Real, D> at = world.balls[i].position - wall_drift(world, shape, now);
    if (shape.gap(at) < world.balls[i].radius && !world.balls[i].fixed) fits = false;
  });
  return fits;
}

}  // namespace carom
