#pragma once
// When a ball meets a wall: a function of the ball's stored state and the shape.

#include "carom/motion/motion.hpp"
#include "carom/predict/contact.hpp"
#include "carom/predict/event.hpp"
#include "carom/solve/polynomial.hpp"
#include "carom/solve/quadratic.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Where a shape that moves with a constant velocity is at time t, relative to where it was at the world's start.
template <class Real, int D, class Shape>
[[nodiscard]] inline Vec<Real, D> drift(const World<Real, D>& world, const Shape& shape, const Time<Real>& t) {
  return shape.velocity * elapsed(world.start, t);
}

/// Flight time to the moment at which gap + rate s + half_acceleration s^2 falls through 0, by the overlap rule; touching:
/// gap is 0 by state.
template <Motion M>
[[nodiscard]] inline typename M::Real flight_to_plane(Touch touch, const typename M::Real& gap, const typename M::Real& rate,
                                                      const typename M::Real& half_acceleration) {
  using Real = typename M::Real;
  if constexpr (M::accelerated) {
    if (touch == Touch::none) return first_fall(gap, rate, half_acceleration);
    if (touch == Touch::live && rate < 0) return Real(0);
    return next_fall(rate, half_acceleration);
  } else {
    if (!(rate < 0)) return never<Real>();
    if (touch != Touch::none) return touch == Touch::live ? Real(0) : never<Real>();
    return gap_time<Real>(gap, rate);
  }
}

template <Motion M>
[[nodiscard]] inline typename M::Real flight_to_wall(const M& motion, const World<typename M::Real, M::dimension>&,
                                                     const Ball<typename M::Real, M::dimension>& ball,
                                                     const Face<typename M::Real, M::dimension>& face, Touch touch) {
  using Real = typename M::Real;
  const Real rate = face.sign > 0 ? ball.velocity[face.axis] : -ball.velocity[face.axis];
  Real half(0);
  if constexpr (M::accelerated) half = Real(face.sign) * motion.acceleration(ball.fixed)[face.axis] / 2;
  return flight_to_plane<M>(touch, Real(face.gap(ball.position) - ball.radius), rate, half);
}

template <Motion M>
[[nodiscard]] inline typename M::Real flight_to_wall(const M& motion, const World<typename M::Real, M::dimension>& world,
                                                     const Ball<typename M::Real, M::dimension>& ball,
                                                     const Plane<typename M::Real, M::dimension>& plane, Touch touch) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  const Vec<Real, D> x = ball.position - drift(world, plane, ball.time);
  const Real rate = dot<Real, D>(plane.direction, ball.velocity - plane.velocity);
  Real half(0);
  if constexpr (M::accelerated) half = dot<Real, D>(plane.direction, motion.acceleration(ball.fixed)) / 2;
  return flight_to_plane<M>(touch, Real(plane.gap(x) - ball.radius), rate, half);
}

template <Motion M>
[[nodiscard]] inline typename M::Real flight_to_wall(const M&, const World<typename M::Real, M::dimension>& world,
                                                     const Ball<typename M::Real, M::dimension>& ball,
                                                     const Sphere<typename M::Real, M::dimension>& sphere, Touch touch) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  const Vec<Real, D> r = ball.position - (sphere.centre + drift(world, sphere, ball.time));
  const Vec<Real, D> v = ball.velocity - sphere.velocity;
  const Real outward = dot<Real, D>(r, v);
  if (sphere.inside) {
    if (touch == Touch::live && outward > 0) return Real(0);
    if (touch != Touch::none) return chord_time<Real, D>(r, v);
    return leave_time<Real, D>(r, v, sphere.radius - ball.radius);
  }
  if (!(outward < 0)) return never<Real>();
  if (touch != Touch::none) return touch == Touch::live ? Real(0) : never<Real>();
  return meet_time<Real, D>(r, v, sphere.radius + ball.radius);
}

/// The meeting of ball i with one piece of a wall as an event.
template <Motion M, class Shape>
[[nodiscard]] inline Event<typename M::Real, M::dimension> predict_wall(const M& motion,
    const World<typename M::Real, M::dimension>& world, std::uint32_t i, const Shape& shape) {
  using Real = typename M::Real;
  const Ball<Real, M::dimension>& ball = world.balls[i];
  Event<Real, M::dimension> event;
  if (ball.fixed) return event;
  const Touch touch = touch_of_wall(wall_contact(world, i, index(shape.wall), shape.feature), ball);
  const Real flight = flight_to_wall(motion, world, ball, shape, touch);
  if (flight == never<Real>()) return event;
  event.time = after(ball.time, flight);
  if (event.time.is_never()) return event;
  event.kind = EventKind::ball_wall;
  event.unresolved = flight > 0 && event.time == ball.time;
  event.ball = i;
  event.partner = index(shape.wall);
  event.feature = shape.feature;
  event.stamp = ball.stamp;
  return event;
}

}  // namespace carom
