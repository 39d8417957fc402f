#pragma once
// When two balls meet: a pure function of their stored states and an image, the same whichever ball asks.

#include "carom/motion/motion.hpp"
#include "carom/predict/arc_fall.hpp"
#include "carom/predict/contact.hpp"
#include "carom/predict/event.hpp"
#include "carom/solve/accelerated.hpp"
#include "carom/solve/quadratic.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Ball b relative to ball a at the later of their stored times.
template <class Real, int D>
struct Relative {
  Vec<Real, D> r;  ///< x_b - x_a + image * edge
  Vec<Real, D> v;  ///< v_b - v_a
  const Time<Real>* since;
};

/// Both are advanced to the later of their stored times; exchanging the balls changes signs only.
template <Motion M>
[[nodiscard]] inline Relative<typename M::Real, M::dimension> relative_state(
    const M& motion, const World<typename M::Real, M::dimension>& world, const Ball<typename M::Real, M::dimension>& a,
    const Ball<typename M::Real, M::dimension>& b, const Image<M::dimension>& image) {
  using Real = typename M::Real;
  Relative<Real, M::dimension> relative;
  const Real lag = elapsed(a.time, b.time);
  if (lag == 0) {
    relative = {b.position - a.position, b.velocity - a.velocity, &b.time};
  } else if (lag > 0) {
    relative = {b.position - motion.position(a.position, a.velocity, motion.phase(a), lag),
                b.velocity - motion.velocity(a.velocity, motion.phase(a), lag), &b.time};
  } else {
    const Real back = -lag;
    relative = {motion.position(b.position, b.velocity, motion.phase(b), back) - a.position,
                motion.velocity(b.velocity, motion.phase(b), back) - a.velocity, &a.time};
  }
  if (world.space.periodic())
    for (int k = 0; k < M::dimension; ++k) relative.r[k] += Real(image[k]) * world.space.edge[k];
  return relative;
}

/// 1-D: places from ball i to the image of ball j along the line, positive to the right. Balls on a line never change their
/// order, so the order at the start decides, not the rounded positions; in a periodic space it repeats after as many places
/// as there are balls.
template <class Real>
[[nodiscard]] inline std::int64_t places_on_line(const World<Real, 1>& world, std::uint32_t i, std::uint32_t j,
                                                 const Image<1>& image) {
  const BallDetail<Real, 1>& a = world.details[i];
  const BallDetail<Real, 1>& b = world.details[j];
  const std::int64_t turns = image[0] + a.image[0] - b.image[0];
  return b.rank - a.rank + turns * static_cast<std::int64_t>(world.balls.size());
}

/// 1-D: +1 if the image of ball j lies to the right of ball i, else -1.
template <class Real>
[[nodiscard]] inline int side_on_line(const World<Real, 1>& world, std::uint32_t i, std::uint32_t j,
                                      const Image<1>& image) {
  return places_on_line(world, i, j, image) > 0 ? 1 : -1;
}

/// Law "merge": what a ball that has just grown overlaps merges with it at the same instant, whichever way it moves.
template <class Real, int D>
[[nodiscard]] inline bool overlap_merges(const World<Real, D>& world, const Vec<Real, D>& r, const Real& sigma) {
  return world.law == LawKind::merge && dot<Real, D>(r, r) < sigma * sigma;
}

/// A meeting seen from the later of the two stored times.
template <class Real>
struct Meeting {
  Real flight;              ///< [L], or `never`
  const Time<Real>* since;  ///< the later stored time
};

/// When balls i and j (its image) meet next.
template <Motion M>
[[nodiscard]] inline Meeting<typename M::Real> next_meeting(const M& motion,
                                                            const World<typename M::Real, M::dimension>& world,
                                                            std::uint32_t i, std::uint32_t j,
                                                            const Image<M::dimension>& image) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  const Ball<Real, D>& a = world.balls[i];
  const Ball<Real, D>& b = world.balls[j];
  const auto [r, v, since] = relative_state(motion, world, a, b, image);
  const Real sigma = a.radius + b.radius;
  const bool may_touch = a.in_contact && b.in_contact;

  if constexpr (D == 1) {
    // Nobody meets anybody through a third, not even where points lie at one place. (Merging takes balls out of the row.)
    const std::int64_t places = places_on_line(world, i, j, image);
    if (places != 1 && places != -1 && world.law != LawKind::merge) return {never<Real>(), since};
    const Real s = Real(places > 0 ? 1 : -1);
    const Real gap = s * r[0] - sigma, rate = s * v[0];
    const Touch touch = may_touch ? touch_of_pair(world, i, j, image) : Touch::none;
    if (M::accelerated && motion.phase(a) != motion.phase(b)) {
      const Real half = s * (motion.acceleration(motion.phase(b))[0] - motion.acceleration(motion.phase(a))[0]) / 2;
      if (touch == Touch::none && world.law == LawKind::merge && gap < 0) return {Real(0), since};
      if (touch == Touch::none) return {first_fall(gap, rate, half), since};
      return {touch == Touch::live && rate < 0 ? Real(0) : return_to_contact(gap, rate, half), since};
    }
    if (touch != Touch::none) return {touch == Touch::live && rate < 0 ? Real(0) : never<Real>(), since};
    if (world.law == LawKind::merge && gap < 0) return {Real(0), since};
    return {gap_time<Real>(gap, rate), since};
  } else if constexpr (M::circular) {
    const Touch touch = may_touch ? touch_of_pair(world, i, j, image) : Touch::none;
    if (sigma == 0) return {never<Real>(), since};
    if (touch == Touch::none && overlap_merges<Real, D>(world, r, sigma)) return {Real(0), since};
    return {fall_on_arc(motion.circle_gap(r, v, sigma), touch), since};
  } else {
    if (M::accelerated && motion.phase(a) != motion.phase(b)) {
      if (sigma == 0) return {never<Real>(), since};
      const Vec<Real, D> acceleration = motion.acceleration(motion.phase(b)) - motion.acceleration(motion.phase(a));
      const Touch touch = may_touch ? touch_of_pair(world, i, j, image) : Touch::none;
      if (touch == Touch::none && overlap_merges<Real, D>(world, r, sigma)) return {Real(0), since};
      if (touch == Touch::none) return {meet_time<Real, D>(r, v, acceleration, sigma), since};
      if (touch == Touch::live && dot<Real, D>(r, v) < 0) return {Real(0), since};
      return {next_meet_time<Real, D>(r, v, acceleration), since};
    }
    if (may_touch) {
      const Touch touch = touch_of_pair(world, i, j, image);
      if (touch != Touch::none) return {touch == Touch::live && dot<Real, D>(r, v) < 0 ? Real(0) : never<Real>(), since};
    }
    if (sigma == 0) return {never<Real>(), since};  // two points never meet
    if (overlap_merges<Real, D>(world, r, sigma)) return {Real(0), since};
    return {meet_time<Real, D>(r, v, sigma), since};
  }
}

/// Makes the meeting of balls i and j the event `first` if it comes before it. `image` is that of j relative to i.
template <Motion M>
inline void consider_meeting(const M& motion, const World<typename M::Real, M::dimension>& world, std::uint32_t i,
                             std::uint32_t j, const Image<M::dimension>& image,
                             Event<typename M::Real, M::dimension>& first) {
  using Real = typename M::Real;
  const Meeting<Real> meeting = next_meeting(motion, world, i, j, image);
  if (meeting.flight == never<Real>()) return;
  Event<Real, M::dimension> event;
  event.time = after(*meeting.since, meeting.flight);
  if (event.time.is_never() || event.time > first.time) return;
  event.kind = EventKind::ball_ball;
  event.unresolved = meeting.flight > 0 && event.time == *meeting.since;
  event.ball = i < j ? i : j;
  event.partner = i < j ? j : i;
  event.image = i < j ? image : -image;
  event.stamp = world.balls[event.ball].stamp;
  event.partner_stamp = world.balls[event.partner].stamp;
  if (precedes(event, first)) first = event;
}

}  // namespace carom
