#pragma once
// A collision written down for a sink.

#include <cmath>

#include "carom/law/impact.hpp"
#include "carom/sim/record.hpp"
#include "carom/sim/wall_touch.hpp"
#include "carom/world/world.hpp"

namespace carom {

template <class Real, int D>
[[nodiscard]] Record<Real, D> record_of(const Event<Real, D>& event, const Impact<Real, D>& impact,
                                        const Outcome<Real, D>& outcome, const Real& gap, bool tie) {
  using std::sqrt;
  Record<Real, D> record;
  record.time = event.time;
  record.kind = event.kind;
  record.feature = event.feature;
  record.ball.velocity_before = impact.va;
  record.ball.velocity_after = outcome.va;
  Vec<Real, D> n;
  for (int k = 0; k < D; ++k) n[k] = -narrow(impact.r[k]);
  const Real length = sqrt(dot<Real, D>(n, n));
  record.normal = length > 0 ? Vec<Real, D>(n / length) : n;
  record.impulse = outcome.impulse;
  record.gap = gap;
  record.restitution = impact.e;
  record.dissipated = narrow(outcome.dissipated);
  record.injected = narrow(outcome.injected);
  record.tie = tie;
  return record;
}

/// `before`: the previous collision of ball i, which has just been written.
template <class Real, int D>
void fill_party(RecordParty<Real, D>& party, const World<Real, D>& world, std::uint32_t i, const Time<Real>& before) {
  party.number = i;
  party.position = world.balls[i].position;
  party.image = world.details[i].image;
  party.previous_hit = before;
}

/// Where on the wall it was: `at` is the centre of the ball in the frame of the wall, `side` the side that it came from.
template <class Real, int D, class Shape>
void fill_place(Record<Real, D>& record, const Shape& shape, const Vec<Real, D>& at, const Real& radius, std::int8_t side) {
  if constexpr (requires { shape.length; }) {
    const Real u = touched_parameter<Real>(shape, Vec<Real, D>(at - shape.centre), radius);
    record.curvature = traced_curvature<Real>(shape, u, side);
    record.arclength = shape.length.to(shape, u);
  } else {
    record.curvature = shape.curvature(at, side);
    record.arclength = shape.arclength(at);
  }
}

}  // namespace carom
