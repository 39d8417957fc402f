#pragma once
// When a ball meets a wall that swings, or one that moves past a ball's circles: the first root of its distance along the path,
// by a rigorous bracket.
//
// Seen from the wall the ball has at most the acceleration |a| + |A| omega^2 (in a field |w v| too), and a distance to a convex
// wall bends downwards no faster than that; solve/bracket.hpp needs no more. How long the wall is out of reach at all is known
// in closed form: as long as the middle of the path does not meet a wall that is larger by |A| (and by the radius of the
// circles) and does not swing.

#include <cmath>

#include "carom/motion/motion.hpp"
#include "carom/predict/arc_wall.hpp"
#include "carom/predict/contact.hpp"
#include "carom/predict/swinging_path.hpp"
#include "carom/solve/accelerated.hpp"
#include "carom/solve/bracket.hpp"
#include "carom/solve/gap.hpp"
#include "carom/solve/quadratic.hpp"

namespace carom {

namespace detail {

/// Where a search begins after a contact that holds by state: f(0) = 0, with the first three derivatives there, the first < 0
/// only by rounding, and bounds of the second to the fourth. Before it f has no root but the one at 0. 0: pressed together now.
template <class Real>
[[nodiscard]] inline Real clear_of_contact(const Real& rate, const Real& second, const Real& third, const Real& bend,
                                           const Real& jerk, const Real& snap) {
  if (rate > 0) return rate / bend;
  if (second > 0) return second / jerk;
  if (second < 0 || !(third > 0)) return Real(0);
  return third / snap;
}

}  // namespace detail

/// A flat wall: nothing matters but the distance.
template <Motion M>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_to_swinging(const SwingingPath<M>& path,
                                                                      const Ball<typename M::Real, M::dimension>& ball,
                                                                      const Plane<typename M::Real, M::dimension>& plane,
                                                                      const Contact<M::dimension>* contact) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  const auto along = [&](const Vec<Real, D>& x) { return dot<Real, D>(plane.direction, x); };
  const auto f = [&](const Real& s) {
    return Overlap<Real>{Real(plane.gap(path.position(s)) - ball.radius), along(path.velocity(s))};
  };
  const Real reach = path.reach_along(plane.direction), bend = path.bend_along(plane.direction);
  const Real half = along(path.acceleration()) / 2;
  const auto wait = [&](const Real& s) {
    const Real gap = plane.gap(path.middle(s)) - ball.radius - reach;
    return gap > 0 ? first_fall(gap, along(path.middle_velocity(s)), half) : Real(0);
  };
  const bool rests = along(path.middle_velocity(Real(0))) == 0 && half == 0;
  const Real span = rests ? path.period() : never<Real>();
  const Touch touch = touch_of_wall(contact, ball);
  if (touch == Touch::none) return {bracketed_fall(f, wait, Real(0), span, bend), 0};
  const Real rate = along(path.velocity(Real(0)));
  if (touch == Touch::live && rate < 0) return {Real(0), 0};
  if (!(bend > 0)) return {never<Real>(), 0};
  const Real clear = detail::clear_of_contact(rate, along(path.acceleration_now()), along(path.jerk_now()), bend, path.jerk(),
                                              path.snap());
  return {clear > 0 ? bracketed_fall(f, wait, clear, Real(clear + span), bend) : Real(0), 0};
}

/// A circle or sphere, and a vertex. Outside, f = |r| - rho, whose second derivative is at least that of the acceleration along
/// r. Inside, f = (rho^2 - |r|^2) / (2 rho), whose second derivative is at least -(v^2 / rho + acceleration) while |r| <= rho.
template <Motion M>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_to_swinging(const SwingingPath<M>& path,
                                                                      const Ball<typename M::Real, M::dimension>& ball,
                                                                      const Sphere<typename M::Real, M::dimension>& sphere,
                                                                      const Contact<M::dimension>* contact) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  using std::sqrt;
  const Real rho = sphere.inside ? Real(sphere.radius - ball.radius) : Real(sphere.radius + ball.radius);
  if (rho == 0) return {never<Real>(), 0};  // two points
  const auto length = [](const Vec<Real, D>& x) { return Real(sqrt(dot<Real, D>(x, x))); };
  const Vec<Real, D> zero = Vec<Real, D>::Zero(), a = path.acceleration(), v0 = path.middle_velocity(Real(0));

  const auto f = [&](const Real& s) {
    const Vec<Real, D> r = path.position(s) - sphere.centre, v = path.velocity(s);
    const Real rr = dot<Real, D>(r, r), rv = dot<Real, D>(r, v);
    if (sphere.inside) return Overlap<Real>{Real((rho * rho - rr) / (2 * rho)), Real(-rv / rho)};
    const Real distance = sqrt(rr);
    return Overlap<Real>{Real((rr - rho * rho) / (distance + rho)), distance > 0 ? Real(rv / distance) : Real(0)};
  };
  const auto wait = [&](const Real& s) {
    const Vec<Real, D> r = path.middle(s) - sphere.centre, v = path.middle_velocity(s);
    const Real rr = dot<Real, D>(r, r);
    if (sphere.inside) {
      const Real room = rho - path.reach();
      if (!(room > 0) || !(rr < room * room)) return Real(0);
      if constexpr (M::accelerated) return leave_time<Real, D>(r, v, a, room);
      return leave_time<Real, D>(r, v, room);
    }
    const Real near = rho + path.reach();
    if (!(rr > near * near)) return Real(0);
    if constexpr (M::accelerated) return meet_time<Real, D>(r, v, a, near);
    return meet_time<Real, D>(r, v, near);
  };

  // Seen from the wall while it is near: v^2 of the middle grows by at most 2 |a| times the way through the reach.
  const Real fastest = length(v0) + sqrt(Real(4 * length(a) * (rho + path.reach()))) + path.shaking();
  const Real bend = sphere.inside ? Real(path.bend() + fastest * fastest / rho) : path.bend();
  Real start(0);
  const Touch touch = touch_of_wall(contact, ball);
  if (touch != Touch::none) {
    const Overlap<Real> now = f(Real(0));
    if (touch == Touch::live && now.rate < 0) return {Real(0), 0};
    const Vec<Real, D> r = path.position(Real(0)) - sphere.centre, v = path.velocity(Real(0));
    const Real pull = dot<Real, D>(r, path.acceleration_now()), vv = dot<Real, D>(v, v);
    const Real second = sphere.inside ? Real(-(vv + pull) / rho) : Real((vv - now.rate * now.rate + pull) / rho);
    const Real jerk = (3 * fastest * path.bend() + (rho + path.reach()) * path.jerk()) / rho +
                      3 * fastest * fastest * fastest / (rho * rho);
    start = detail::clear_of_contact(now.rate, second, Real(0), bend, jerk, Real(1));
    if (!(start > 0)) return {Real(0), 0};
  }
  const bool rests = v0 == zero && a == zero;
  return {bracketed_fall(f, wait, start, rests ? Real(start + path.period()) : never<Real>(), bend), 0};
}

/// A ball can meet the flat part only where its centre is over it: beside it, it must come over it first, and comes no nearer
/// than to the ends. A point keeps the side that it is on until it goes round an end.
template <Motion M>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_to_swinging(const SwingingPath<M>& path,
                                                                      const Ball<typename M::Real, 2>& ball,
                                                                      const Segment<typename M::Real>& segment,
                                                                      const Contact<2>* contact) {
  using Real = typename M::Real;
  using Vector = Vec<Real, 2>;
  using std::abs;
  using std::sqrt;
  const Touch touch = touch_of_wall(contact, ball);
  const Vector x0 = path.position(Real(0)), v0 = path.velocity(Real(0)), middle = (segment.from + segment.to) / 2;
  const Vector a = path.acceleration(), v_middle = path.middle_velocity(Real(0));
  const Real length = sqrt(dot<Real, 2>(segment.to - segment.from, segment.to - segment.from));
  const auto doubt = [&](const Vector& at) {
    return 16 * unit_roundoff<Real>() *
           (abs(x0[0]) + abs(x0[1]) + abs(at[0]) + abs(at[1]) + abs(segment.from[0]) + abs(segment.from[1]) +
            abs(segment.to[0]) + abs(segment.to[1]) + path.reach());
  };
  const Real height = segment.height(x0), rate = dot<Real, 2>(segment.direction, v0);
  int side = height > 0 ? 1 : -1;
  if (height == 0) side = rate >= 0 ? 1 : -1;
  if (touch != Touch::none) side = contact->side;

  const auto f = [&](const Real& s) {
    const Vector x = path.position(s), v = path.velocity(s);
    const Real before = dot<Real, 2>(segment.along, x - segment.from), beyond = dot<Real, 2>(segment.along, x - segment.to);
    const Real h = segment.height(x), margin = doubt(x);
    if (before >= -margin && beyond <= margin)
      return Overlap<Real>{Real(side * h - ball.radius), Real(side * dot<Real, 2>(segment.direction, v))};
    side = h > 0 ? 1 : -1;
    const Vector r = before < 0 ? Vector(x - segment.from) : Vector(x - segment.to);
    const Real distance = sqrt(dot<Real, 2>(r, r)), beside = before < 0 ? Real(-before) : beyond;
    if (distance - ball.radius > beside) return Overlap<Real>{Real(distance - ball.radius), Real(dot<Real, 2>(r, v) / distance)};
    const Real outward = dot<Real, 2>(segment.along, v);
    return Overlap<Real>{beside, before < 0 ? Real(-outward) : outward};
  };
  const Real reach = length / 2 + ball.radius + path.reach();
  const Real lift = path.reach_along(segment.direction) + ball.radius;
  const auto wait = [&](const Real& s) {
    const Vector x = path.middle(s), v = path.middle_velocity(s), r = x - middle;
    Real idle(0);
    if (dot<Real, 2>(r, r) > reach * reach) {
      if constexpr (M::accelerated) {
        idle = meet_time<Real, 2>(r, v, a, reach);
      } else {
        idle = meet_time<Real, 2>(r, v, reach);
      }
    }
    const Real h = segment.height(x), up = h > 0 ? Real(1) : Real(-1), gap = up * h - lift;
    if (!(gap > 0)) return idle;
    const Real down = first_fall(gap, Real(up * dot<Real, 2>(segment.direction, v)),
                                 Real(up * dot<Real, 2>(segment.direction, a) / 2));
    return down > idle ? down : idle;
  };

  Real start(0);
  if (touch != Touch::none) {
    const Vector n = segment.direction * Real(side);
    const Real leaving = side * rate, bend = path.bend();
    if (touch == Touch::live && leaving < 0) return {Real(0), static_cast<std::int8_t>(side)};
    if (!(leaving > 0) && dot<Real, 2>(n, path.acceleration_now()) == 0 && dot<Real, 2>(n, path.jerk_now()) == 0)
      return {never<Real>(), 0};  // slides along it, both at rest across
    start = detail::clear_of_contact(leaving, dot<Real, 2>(n, path.acceleration_now()), dot<Real, 2>(n, path.jerk_now()), bend,
                                     path.jerk(), path.snap());
    if (!(start > 0)) return {Real(0), static_cast<std::int8_t>(side)};
  }
  const bool rests = v_middle == Vector::Zero() && a == Vector::Zero();
  const Real flight = bracketed_fall(f, wait, start, rests ? Real(start + path.period()) : never<Real>(), path.bend());
  return {flight, static_cast<std::int8_t>(side)};
}

/// Faces and what else does not swing is not asked.
template <Motion M, class Shape>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_to_swinging(const M& motion,
                                                                      const World<typename M::Real, M::dimension>& world,
                                                                      const Ball<typename M::Real, M::dimension>& ball,
                                                                      const Shape& shape,
                                                                      const Swing<typename M::Real, M::dimension>& swing,
                                                                      const Contact<M::dimension>* contact) {
  if constexpr (requires { shape.swing; }) {
    const SwingingPath<M> path(motion, world, ball, shape.velocity, swing);
    return flight_to_swinging(path, ball, shape, contact);
  } else {
    return {never<typename M::Real>(), 0};
  }
}

}  // namespace carom
