#pragma once
// When a ball on a circular path meets a wall at rest: lines and circles, each the root of one parabola.

#include <cmath>

#include "carom/predict/arc_fall.hpp"
#include "carom/predict/sided.hpp"
#include "carom/shape/arc.hpp"
#include "carom/shape/place_doubt.hpp"
#include "carom/world/world.hpp"

namespace carom {

template <class M>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_on_arc(const M& motion, const Ball<typename M::Real, 2>& ball,
                                                                 const Face<typename M::Real, 2>& face,
                                                                 const Contact<2>* contact) {
  using Real = typename M::Real;
  const Vec<Real, 2> n = face.normal(ball.position);
  const auto gap = motion.line_gap(Real(face.gap(ball.position) - ball.radius), dot<Real, 2>(n, ball.velocity),
                                   dot<Real, 2>(n, motion.turned(ball.velocity)));
  return {fall_on_arc(gap, touch_of_wall(contact, ball)), 0};
}

template <class M>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_on_arc(const M& motion, const Ball<typename M::Real, 2>& ball,
                                                                 const Plane<typename M::Real, 2>& plane,
                                                                 const Contact<2>* contact) {
  using Real = typename M::Real;
  const auto gap =
      motion.line_gap(Real(plane.gap(ball.position) - ball.radius), dot<Real, 2>(plane.direction, ball.velocity),
                      dot<Real, 2>(plane.direction, motion.turned(ball.velocity)));
  return {fall_on_arc(gap, touch_of_wall(contact, ball)), 0};
}

/// Two points never meet: a point passes a vertex on either side, and what the vertex joins is met as far as rounding can
/// tell where it ends.
template <class M>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_on_arc(const M& motion, const Ball<typename M::Real, 2>& ball,
                                                                 const Sphere<typename M::Real, 2>& sphere,
                                                                 const Contact<2>* contact) {
  using Real = typename M::Real;
  const Vec<Real, 2> r = ball.position - sphere.centre;
  const Touch touch = touch_of_wall(contact, ball);
  if (sphere.inside)
    return {fall_on_arc(-motion.circle_gap(r, ball.velocity, Real(sphere.radius - ball.radius)), touch), 0};
  const Real sigma = sphere.radius + ball.radius;
  if (sigma == 0) return {never<Real>(), 0};
  return {fall_on_arc(motion.circle_gap(r, ball.velocity, sigma), touch), 0};
}

/// A circle crosses the height of a contact twice a turn, once falling: so at most one meeting a turn from either side. A ball
/// that comes round the end of the segment meets it from the other side. The path of a point is searched for the segment and
/// as far beyond its ends as rounding can have moved it: it cannot slip through a joint.
template <class M>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_on_arc(const M& motion, const Ball<typename M::Real, 2>& ball,
                                                                 const Segment<typename M::Real>& segment,
                                                                 const Contact<2>* contact) {
  using Real = typename M::Real;
  using std::abs;
  const Touch touch = touch_of_wall(contact, ball);
  const Vec<Real, 2>&x = ball.position, &v = ball.velocity;
  const Vec<Real, 2> turned = motion.turned(v);
  const Real height = segment.height(x), rate = dot<Real, 2>(segment.direction, v),
             turned_rate = dot<Real, 2>(segment.direction, turned);
  int home = height > 0 ? 1 : -1;  // on the line itself: the side that it leaves to
  if (height == 0) home = rate > 0 || (rate == 0 && turned_rate > 0) ? 1 : -1;
  if (touch != Touch::none) home = contact->side;

  const auto within = [&](const Real& t) {
    const Vec<Real, 2> at = motion.position(x, v, false, t);
    const Real before = dot<Real, 2>(segment.along, at - segment.from),
               beyond = dot<Real, 2>(segment.along, at - segment.to);
    if (ball.radius > 0) return before >= 0 && beyond <= 0;  // beside the span the ends are met first
    const Real doubt = 16 * unit_roundoff<Real>() *
                       (abs(x[0]) + abs(x[1]) + abs(at[0]) + abs(at[1]) + abs(segment.from[0]) + abs(segment.from[1]) +
                        abs(segment.to[0]) + abs(segment.to[1]));
    return before >= -doubt && beyond <= doubt;
  };

  SidedFlight<Real> first{never<Real>(), 0};
  for (const int side : {home, -home}) {
    const Real gap_now = side * height - ball.radius;
    const ArcGap<Real> gap = motion.line_gap(gap_now, Real(side * rate), Real(side * turned_rate));
    Real t;
    if (side == home) {
      t = touch == Touch::none ? first_fall(gap) : fall_on_arc(gap, touch);
      if (touch == Touch::live && t == 0) return {Real(0), static_cast<std::int8_t>(side)};
    } else if (touch != Touch::none && ball.radius == 0) {
      t = gap.turn();  // it left from here, and is back after a turn
    } else {
      t = gap_now > 0 ? first_fall(gap) : fall_from_above(gap);
    }
    if (t != never<Real>() && t < first.flight && within(t)) first = {t, static_cast<std::int8_t>(side)};
  }
  return first;
}

/// The centre of a ball crosses the circle about the arc inwards, and the one within it outwards, once a turn each.
template <class M>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_on_arc(const M& motion, const Ball<typename M::Real, 2>& ball,
                                                                 const Arc<typename M::Real>& arc, const Contact<2>* contact) {
  using Real = typename M::Real;
  const Touch touch = touch_of_wall(contact, ball);
  const Vec<Real, 2>&x = ball.position, &v = ball.velocity;
  const Vec<Real, 2> r = x - arc.centre;
  const Real height = arc.height(x);
  int home = height > 0 ? 1 : -1;  // on the arc itself: the side that it leaves to
  if (height == 0) home = dot<Real, 2>(r, v) > 0 ? -1 : 1;
  if (touch != Touch::none) home = contact->side;
  const auto within = [&](const Real& t) {
    const Vec<Real, 2> at = motion.position(x, v, false, t);
    const Real doubt = place_doubt<Real>(at, arc.from, arc.to) + place_doubt<Real>(x, arc.centre, arc.centre) +
                       16 * unit_roundoff<Real>() * arc.radius;
    return arc.spans(Vec<Real, 2>(at - arc.centre), ball.radius > 0 ? Real(0) : doubt);
  };

  SidedFlight<Real> first{never<Real>(), 0};
  for (const int side : {home, -home}) {
    const Real rho = side > 0 ? Real(arc.radius - ball.radius) : Real(arc.radius + ball.radius);
    if (!(rho > 0)) continue;
    const ArcGap<Real> outside = motion.circle_gap(r, v, rho), gap = side > 0 ? -outside : outside;
    Real t;
    if (side == home) {
      t = fall_on_arc(gap, touch);
      if (touch == Touch::live && t == 0) return {Real(0), static_cast<std::int8_t>(side)};
    } else if (touch != Touch::none && ball.radius == 0) {
      t = gap.turn();  // it left from here, and is back after a turn
    } else {
      t = narrow(gap.c0) > 0 ? first_fall(gap) : fall_from_above(gap);
    }
    if (t != never<Real>() && t < first.flight && within(t)) first = {t, static_cast<std::int8_t>(side)};
  }
  return first;
}

}  // namespace carom
