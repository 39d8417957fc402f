#pragma once
// What a collision was: handed to the sink of a run as it happens.

#include <cstdint>

#include "carom/core/clock.hpp"
#include "carom/core/vec.hpp"
#include "carom/predict/event.hpp"

namespace carom {

/// One party of a collision. For a wall only `number` and the velocity of the wall are set.
template <class Real, int D>
struct RecordParty {
  std::uint32_t number = 0;
  Vec<Real, D> position = Vec<Real, D>::Zero();  ///< [length unit] wrapped
  std::array<std::int64_t, D> image{};           ///< periods counted out of `position`
  Vec<Real, D> velocity_before = Vec<Real, D>::Zero();
  Vec<Real, D> velocity_after = Vec<Real, D>::Zero();
  Time<Real> previous_hit = Time<Real>::never();  ///< its previous collision; never: none
};

/// A collision, in the world's units.
template <class Real, int D>
struct Record {
  Time<Real> time;
  EventKind kind = EventKind::none;            ///< ball_ball or ball_wall
  RecordParty<Real, D> ball, partner;          ///< ball_ball: ball has the smaller number
  std::int32_t feature = 0;                    ///< of the wall
  Vec<Real, D> normal = Vec<Real, D>::Zero();  ///< unit, from the partner towards the ball
  Vec<Real, D> point = Vec<Real, D>::Zero();   ///< of contact, on the ball's surface
  Real impulse = Real(0);                      ///< size
  Real gap = Real(0);                          ///< distance left between the surfaces: an error of rounding
  Real restitution = Real(1);
  Real curvature = Real(0);  ///< [1/length unit] of the wall where it was hit; > 0: convex towards the ball, < 0: concave, 0: flat
  Real arclength = Real(0);  ///< [length unit] along the wall's feature from its beginning to where it was hit
  Real dissipated = Real(0);
  Real injected = Real(0);
  bool tie = false;  ///< a party's previous collision was at the same moment with another partner
};

/// A sink that wants nothing: no record is made.
struct NoSink {
  static constexpr bool wants_records = false;
  template <class R>
  void operator()(const R&) const {}
};

}  // namespace carom
