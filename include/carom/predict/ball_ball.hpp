#pragma once
// When two balls meet: a pure function of their stored states and an image, the same whichever ball asks.

#include "carom/motion/motion.hpp"
#include "carom/predict/contact.hpp"
#include "carom/predict/event.hpp"
#include "carom/solve/polynomial.hpp"
#include "carom/solve/quadratic.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Ball b relative to ball a at the later of their stored times.
template <class Real, int D>
struct Relative {
  Vec<Real, D> r;        ///< x_b - x_a + image * edge
  Vec<Real, D> v;        ///< v_b - v_a
  const Time<Real>* since;
};

/// Both are advanced to the later of their stored times; exchanging the balls changes signs only.
template <Motion M>
[[nodiscard]] inline Relative<typename M::Real, M::dimension> relative_state(const M& motion,
    const World<typename M::Real, M::dimension>& world, const Ball<typename M::Real, M::dimension>& a,
    const Ball<typename M::Real, M::dimension>& b, const Image<M::dimension>& image) {
  using Real = typename M::Real;
  Relative<Real, M::dimension> relative;
  const Real lag = elapsed(a.time, b.time);
  if (lag == 0) {
    relative = {b.position - a.position, b.velocity - a.velocity, &b.time};
  } else if (lag > 0) {
    relative = {b.position - motion.position(a.position, a.velocity, a.fixed, lag),
                b.velocity - motion.velocity(a.velocity, a.fixed, lag), &b.time};
  } else {
    const Real back = -lag;
    relative = {motion.position(b.position, b.velocity, b.fixed, back) - a.position,
                motion.velocity(b.velocity, b.fixed, back) - a.velocity, &a.time};
  }
  if (world.space.periodic())
    for (int k = 0; k < M::dimension; ++k) relative.r[k] += Real(image[k]) * world.space.edge[k];
  return relative;
}

/// 1-D: +1 if the image of ball j lies to the right of ball i, else -1. Balls on a line never change their order, so the
/// order at the start decides, not the rounded positions.
template <class Real>
[[nodiscard]] inline int side_on_line(const World<Real, 1>& world, std::uint32_t i, std::uint32_t j, const Image<1>& image) {
  const BallDetail<Real, 1>& a = world.details[i];
  const BallDetail<Real, 1>& b = world.details[j];
  const std::int64_t turns = image[0] + b.image[0] - a.image[0];
  if (turns != 0) return turns > 0 ? 1 : -1;
  return b.rank > a.rank ? 1 : -1;
}

/// Flight time from the later stored time to the meeting of balls i and j (its image), or `never`.
template <Motion M>
[[nodiscard]] inline typename M::Real flight_to_meeting(const M& motion, const World<typename M::Real, M::dimension>& world,
                                                        std::uint32_t i, std::uint32_t j, const Image<M::dimension>& image,
                                                        const Time<typename M::Real>** since) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  const Ball<Real, D>& a = world.balls[i];
  const Ball<Real, D>& b = world.balls[j];
  const auto [r, v, later] = relative_state(motion, world, a, b, image);
  *since = later;
  const Real sigma = a.radius + b.radius;

  const bool free = !M::accelerated || a.fixed == b.fixed;  // no relative acceleration
  if (free) {
    const Real closing = dot<Real, D>(r, v);
    if constexpr (D == 1) {
      const Real s = Real(side_on_line(world, i, j, image));
      if (!(s * v[0] < 0)) return never<Real>();
      if (a.in_contact && b.in_contact) {
        const Touch touch = touch_of_pair(world, i, j, image);
        if (touch != Touch::none) return touch == Touch::live ? Real(0) : never<Real>();
      }
      return gap_time<Real>(s * r[0] - sigma, s * v[0]);
    } else {
      if (!(closing < 0) || sigma == 0) return never<Real>();  // two points never meet
      if (a.in_contact && b.in_contact) {
        const Touch touch = touch_of_pair(world, i, j, image);
        if (touch != Touch::none) return touch == Touch::live ? Real(0) : never<Real>();
      }
      return meet_time<Real, D>(r, v, sigma);
    }
  }
  return never<Real>();
}

/// The meeting of balls i and j as an event. `image` is that of j relative to i.
template <Motion M>
[[nodiscard]] inline Event<typename M::Real, M::dimension> predict_meeting(const M& motion,
    const World<typename M::Real, M::dimension>& world, std::uint32_t i, std::uint32_t j, const Image<M::dimension>& image) {
  using Real = typename M::Real;
  Event<Real, M::dimension> event;
  const Time<Real>* since = nullptr;
  const Real flight = flight_to_meeting(motion, world, i, j, image, &since);
  if (flight == never<Real>()) return event;
  event.time = after(*since, flight);
  if (event.time.is_never()) return event;
  event.kind = EventKind::ball_ball;
  event.unresolved = flight > 0 && event.time == *since;
  event.ball = i;
  event.partner = j;
  event.image = image;
  if (j < i) {
    event.ball = j;
    event.partner = i;
    event.image = -image;
  }
  event.stamp = world.balls[event.ball].stamp;
  event.partner_stamp = world.balls[event.partner].stamp;
  return event;
}

}  // namespace carom
