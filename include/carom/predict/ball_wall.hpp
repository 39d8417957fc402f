#pragma once
// When a ball meets a wall: a function of the ball's stored state and the shape.

#include "carom/motion/motion.hpp"
#include "carom/predict/arc_wall.hpp"
#include "carom/predict/ball_arc.hpp"
#include "carom/predict/ball_curve.hpp"
#include "carom/predict/contact.hpp"
#include "carom/predict/curve_on_arc.hpp"
#include "carom/predict/event.hpp"
#include "carom/predict/leaving.hpp"
#include "carom/predict/swinging_wall.hpp"
#include "carom/solve/accelerated.hpp"
#include "carom/solve/quadratic.hpp"
#include "carom/world/wall_images.hpp"
#include "carom/world/wall_motion.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Flight time to the moment at which gap + rate s + half_acceleration s^2 falls through 0, by the overlap rule; touching:
/// gap is 0 by state.
template <Motion M>
[[nodiscard]] inline typename M::Real flight_to_plane(Touch touch, const typename M::Real& gap,
                                                      const typename M::Real& rate,
                                                      const typename M::Real& half_acceleration) {
  using Real = typename M::Real;
  if constexpr (M::accelerated) {
    if (touch == Touch::none) return first_fall(gap, rate, half_acceleration);
    if (touch == Touch::live && rate < 0) return Real(0);
    return return_to_contact(gap, rate, half_acceleration);
  } else {
    if (!(rate < 0)) return never<Real>();
    if (touch != Touch::none) return touch == Touch::live ? Real(0) : never<Real>();
    return gap_time<Real>(gap, rate);
  }
}

/// A point at x meets a vertex only if its path runs straight through it.
template <class Real, int D>
[[nodiscard]] inline Real flight_to_vertex(const Vec<Real, D>& x, const Vec<Real, D>& v, const Vec<Real, D>& vertex) {
  const Vec<Real, D> r = x - vertex;
  const Real b = dot<Real, D>(r, v);
  if (!(b < 0)) return never<Real>();
  if constexpr (D == 2) {
    if (side_of_path<Real>(x, v, vertex) != 0) return never<Real>();
  } else {
    if (cross_squared<Real, D>(r, v) != 0) return never<Real>();
  }
  return -b / dot<Real, D>(v, v);
}

template <Motion M>
[[nodiscard]] inline typename M::Real flight_to_wall(const M& motion, const World<typename M::Real, M::dimension>&,
                                                     const Ball<typename M::Real, M::dimension>& ball,
                                                     const Face<typename M::Real, M::dimension>& face, Touch touch) {
  using Real = typename M::Real;
  const Real rate = face.sign > 0 ? ball.velocity[face.axis] : -ball.velocity[face.axis];
  Real half(0);
  if constexpr (M::accelerated) half = Real(face.sign) * motion.acceleration(motion.phase(ball))[face.axis] / 2;
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
  if constexpr (M::accelerated) half = dot<Real, D>(plane.direction, motion.acceleration(motion.phase(ball))) / 2;
  return flight_to_plane<M>(touch, Real(plane.gap(x) - ball.radius), rate, half);
}

template <Motion M>
[[nodiscard]] inline typename M::Real flight_to_wall(const M& motion, const World<typename M::Real, M::dimension>& world,
                                                     const Ball<typename M::Real, M::dimension>& ball,
                                                     const Sphere<typename M::Real, M::dimension>& sphere, Touch touch) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  const Vec<Real, D> x = ball.position - drift(world, sphere, ball.time);
  const Vec<Real, D> r = x - sphere.centre;
  const Vec<Real, D> v = ball.velocity - sphere.velocity;
  const Real outward = dot<Real, D>(r, v);
  if (touch == Touch::live && (sphere.inside ? outward > 0 : outward < 0)) return Real(0);
  const Vec<Real, D> a = motion.acceleration(motion.phase(ball));
  if (sphere.inside) {
    const Real rho = sphere.radius - ball.radius;
    if constexpr (M::accelerated)
      return touch == Touch::none ? leave_time<Real, D>(r, v, a, rho) : chord_time<Real, D>(r, v, a);
    // Inward bound the later root is the one wanted, touching or not; taken with the gap as it is, it keeps |r| from
    // wandering.
    return touch == Touch::none || outward < 0 ? leave_time<Real, D>(r, v, rho) : chord_time<Real, D>(r, v);
  }
  const Real sigma = sphere.radius + ball.radius;
  if (sigma == 0)
    return sphere.smooth || M::accelerated || touch != Touch::none ? never<Real>() : flight_to_vertex<Real, D>(x, v, sphere.centre);
  if constexpr (M::accelerated)
    return touch == Touch::none ? meet_time<Real, D>(r, v, a, sigma) : next_meet_time<Real, D>(r, v, a);
  return touch == Touch::none ? meet_time<Real, D>(r, v, sigma) : never<Real>();
}

/// Height over a line, its rate and half its acceleration, counted positive on one side of it.
template <class Real>
struct Approach {
  Real height, rate, half;
};

/// First time at which a ball of the given radius comes down to the line from that side. A ball that is beyond the line is
/// not overlapping it from here: it must first come over to this side.
template <class Real>
[[nodiscard]] inline Real descent(const Approach<Real>& a, const Real& radius, bool on_this_side) {
  const Real gap = a.height - radius;
  if (on_this_side || gap > 0) return first_fall(gap, a.rate, a.half);
  if (!(a.rate > 0) || !(a.half < 0)) return never<Real>();  // never rises to fall again
  return discriminant(Real(4 * a.half), a.rate, gap) > 0 ? first_fall(gap, a.rate, a.half) : never<Real>();
}

/// A ball meets the open segment where it comes down to its line between the ends. The ends themselves are vertices:
/// whether a point's straight path runs to the left or to the right of a vertex is one sign, the same for both segments
/// that share it, so a point cannot slip through a joint.
template <Motion M>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_to_segment(const M& motion,
                                                                     const World<typename M::Real, 2>& world,
                                                                     const Ball<typename M::Real, 2>& ball,
                                                                     const Segment<typename M::Real>& segment,
                                                                     const Contact<2>* contact) {
  using Real = typename M::Real;
  using std::abs;
  const Touch touch = touch_of_wall(contact, ball);
  const Vec<Real, 2> x = ball.position - drift(world, segment, ball.time);
  const Vec<Real, 2> v = ball.velocity - segment.velocity;
  const Vec<Real, 2> a = motion.acceleration(motion.phase(ball));
  const Real height = segment.height(x), rate = dot<Real, 2>(segment.direction, v),
             half = M::accelerated ? Real(dot<Real, 2>(segment.direction, a) / 2) : Real(0);
  int home = height > 0 ? 1 : -1;  // on the line itself: the side that the velocity points to
  if (height == 0) home = rate > 0 || (rate == 0 && half > 0) ? 1 : -1;
  if (touch != Touch::none) home = contact->side;

  const auto within = [&](const Real& t) {
    const Vec<Real, 2> at = M::accelerated ? Vec<Real, 2>(x + (v + a * (t / 2)) * t) : Vec<Real, 2>(x + v * t);
    const Real before = dot<Real, 2>(segment.along, at - segment.from),
               beyond = dot<Real, 2>(segment.along, at - segment.to);
    if (ball.radius > 0) return before >= 0 && beyond <= 0;  // beside the span the ends are met first
    if constexpr (!M::accelerated) {
      const int left = side_of_path(x, v, segment.from, segment.smooth_from),
                right = side_of_path(x, v, segment.to, segment.smooth_to);
      return left * right < 0;
    }
    const Real doubt =
        8 * unit_roundoff<Real>() *
        (abs(at[0]) + abs(at[1]) + abs(segment.from[0]) + abs(segment.from[1]) + abs(segment.to[0]) + abs(segment.to[1]));
    return before >= -doubt && beyond <= doubt;
  };

  SidedFlight<Real> first{never<Real>(), 0};
  for (const int side : {home, -home}) {
    const Approach<Real> approach{side * height, side * rate, side * half};
    Real t = never<Real>();
    if (touch != Touch::none && side != home) break;  // one parabola from the wall does not come back to its other side
    if (touch != Touch::none) {
      if (touch == Touch::live && approach.rate < 0) return {Real(0), static_cast<std::int8_t>(side)};
      t = return_to_contact(Real(approach.height - ball.radius), approach.rate, approach.half);
    } else {
      t = descent(approach, ball.radius, side == home);
    }
    if (t != never<Real>() && t < first.flight && within(t)) first = {t, static_cast<std::int8_t>(side)};
  }
  return first;
}

/// A curved wall, which the ball may touch.
template <Motion M, class Shape>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_to_curved(const M& motion,
                                                                    const World<typename M::Real, 2>& world,
                                                                    const Ball<typename M::Real, 2>& ball,
                                                                    const Shape& shape, const Contact<2>* contact) {
  using Real = typename M::Real;
  const Touch touch = touch_of_wall(contact, ball);
  const Vec<Real, 2> x = ball.position - drift(world, shape, ball.time), v = ball.velocity - shape.velocity,
                     a = motion.acceleration(motion.phase(ball));
  const std::int8_t side = contact != nullptr ? contact->side : std::int8_t(0);
  if constexpr (std::is_same_v<Shape, Arc<Real>>) {
    return flight_to_arc<M::accelerated, Real>(shape, x, v, a, ball.radius, touch, side);
  } else {
    return flight_to_curve<M::accelerated, Real>(shape, x, v, a, ball.radius, touch, side);
  }
}

/// When a ball meets one piece of a wall, at rest or in motion, and from which side where it has two.
template <Motion M, class Shape>
[[nodiscard]] inline SidedFlight<typename M::Real> flight_to(const M& motion,
                                                             const World<typename M::Real, M::dimension>& world,
                                                             const Ball<typename M::Real, M::dimension>& ball,
                                                             const Shape& shape, const Contact<M::dimension>* contact) {
  using Real = typename M::Real;
  if constexpr (M::circular) {
    if (moves(world.walls, shape))
      return flight_to_swinging(motion, world, ball, shape, swing_or_none(world.walls, shape), contact);
    return flight_on_arc(motion, ball, shape, contact);
  } else {
    if (const Swing<Real, M::dimension>* swing = swing_of(world.walls, shape))
      return flight_to_swinging(motion, world, ball, shape, *swing, contact);
    if constexpr (std::is_same_v<Shape, Segment<Real>>) {
      return flight_to_segment(motion, world, ball, shape, contact);
    } else if constexpr (is_curved<Shape>) {
      return flight_to_curved(motion, world, ball, shape, contact);
    } else {
      return {flight_to_wall(motion, world, ball, shape, touch_of_wall(contact, ball)), 0};
    }
  }
}

/// The moment at which the centre of ball i comes to an opening: it leaves.
template <Motion M, class Shape>
[[nodiscard]] inline Event<typename M::Real, M::dimension> predict_exit(const M& motion,
                                                                        const World<typename M::Real, M::dimension>& world,
                                                                        std::uint32_t i, const Shape& placed,
                                                                        const Image<M::dimension>& image) {
  using Real = typename M::Real;
  Event<Real, M::dimension> event;
  Ball<Real, M::dimension> centre = world.balls[i];
  centre.radius = Real(0);
  const auto* contact = wall_contact(world, i, index(placed.wall), placed.feature, image);
  const Real flight = flight_to(motion, world, centre, placed, contact).flight;
  if (flight == never<Real>()) return event;
  event.time = after(centre.time, flight);
  if (event.time.is_never()) return event;
  event.kind = EventKind::motion_change;
  event.ball = i;
  event.partner = index(placed.wall);
  event.feature = placed.feature;
  event.image = image;
  event.stamp = centre.stamp;
  return event;
}

/// The meeting of ball i with one piece of a wall, which stands at `placed`, as an event.
template <Motion M, class Shape>
[[nodiscard]] inline Event<typename M::Real, M::dimension> meet_wall(const M& motion,
                                                                     const World<typename M::Real, M::dimension>& world,
                                                                     std::uint32_t i, const Shape& shape, const Shape& placed,
                                                                     const Image<M::dimension>& image) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  const Ball<Real, D>& ball = world.balls[i];
  Event<Real, D> event;
  if (ball.fixed) return event;
  if (world.walls.opens(index(shape.wall))) return predict_exit(motion, world, i, placed, image);
  if constexpr (M::can_rest) {
    if (ball.held != 0 && ball.held == flat_number(world.walls, shape)) return predict_leaving(motion, world, i, shape);
    if (ball.held != 0 && is_end_of_rest(world, ball, shape)) return event;
  }
  const Contact<D>* contact = wall_contact(world, i, index(shape.wall), shape.feature, image);
  if constexpr (M::can_rest)
    if (contact != nullptr && contact->left) return event;
  const auto [flight, side] = flight_to(motion, world, ball, placed, contact);
  event.side = side;
  if (flight == never<Real>()) return event;
  event.time = after(ball.time, flight);
  if (event.time.is_never()) return event;
  event.kind = EventKind::ball_wall;
  event.unresolved = flight > 0 && event.time == ball.time;
  event.ball = i;
  event.partner = index(shape.wall);
  event.feature = shape.feature;
  event.image = image;
  event.stamp = ball.stamp;
  return event;
}

/// The same for the piece in period `image` of a periodic space, relative to the ball as stored.
template <Motion M, class Shape>
[[nodiscard]] inline Event<typename M::Real, M::dimension> predict_wall(const M& motion,
                                                                        const World<typename M::Real, M::dimension>& world,
                                                                        std::uint32_t i, const Shape& shape,
                                                                        const Image<M::dimension>& image = {}) {
  if (image == Image<M::dimension>{}) return meet_wall(motion, world, i, shape, shape, image);
  return meet_wall(motion, world, i, shape, moved_by(world.space, shape, image), image);
}

}  // namespace carom
