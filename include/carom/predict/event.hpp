#pragma once
// A predicted event, and the one total order in which events happen.

#include <cstdint>

#include "carom/core/clock.hpp"
#include "carom/core/id.hpp"

namespace carom {

/// In the order in which events at one moment happen.
enum class EventKind : std::uint8_t { scheduled, motion_change, ball_wall, ball_ball, bookkeeping, none };

/// What will happen next to `ball`, valid while the stamps are those of the parties.
template <class Real, int D>
struct Event {
  Time<Real> time = Time<Real>::never();
  std::uint32_t ball = 0;           ///< ball_ball: the smaller number
  std::uint32_t partner = 0;        ///< ball number, wall number, or what bookkeeping needs
  std::uint32_t stamp = 0;          ///< of `ball` when predicted
  std::uint32_t partner_stamp = 0;  ///< of `partner` when predicted (ball_ball)
  std::int32_t feature = 0;         ///< of the wall
  EventKind kind = EventKind::none;
  std::int8_t side = 0;     ///< of a two-sided wall: the side of approach
  bool unresolved = false;  ///< a positive flight time that rounded to no tick of the clock
  Image<D> image{};         ///< of `partner` relative to `ball`, both as stored
};

/// Time; then scheduled < motion_change < ball_wall < ball_ball < bookkeeping; then ball, partner, feature, image.
template <class Real, int D>
[[nodiscard]] inline bool precedes(const Event<Real, D>& a, const Event<Real, D>& b) {
  if (a.time != b.time) return a.time < b.time;
  if (a.kind != b.kind) return a.kind < b.kind;
  if (a.ball != b.ball) return a.ball < b.ball;
  if (a.partner != b.partner) return a.partner < b.partner;
  if (a.feature != b.feature) return a.feature < b.feature;
  return a.image < b.image;
}

}  // namespace carom
