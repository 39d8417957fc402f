#pragma once
// When balls that grow meet each other and walls. Overloads for growing motions of what ball_ball.hpp and ball_wall.hpp do.

#include "carom/motion/growing_flight.hpp"
#include "carom/predict/ball_ball.hpp"
#include "carom/predict/ball_wall.hpp"
#include "carom/solve/growing.hpp"
#include "carom/world/growth.hpp"

namespace carom {

/// When balls i and j (its image) meet next: the sum of the radii counts from the later of the two stored times.
template <GrowingMotion M>
[[nodiscard]] inline Meeting<typename M::Real> next_meeting(const M& motion,
                                                            const World<typename M::Real, M::dimension>& world,
                                                            std::uint32_t i, std::uint32_t j,
                                                            const Image<M::dimension>& image) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  const Ball<Real, D>& a = world.balls[i];
  const Ball<Real, D>& b = world.balls[j];
  const auto [r, v, since] = relative_state(motion, world, a, b, image);
  const Real growth = world.growth.rates[i] + world.growth.rates[j];
  const Real sigma = a.radius + b.radius + growth * elapsed(world.start, *since);
  const Touch touch = a.in_contact && b.in_contact ? touch_of_pair(world, i, j, image) : Touch::none;
  if constexpr (D == 1) {
    const std::int64_t places = places_on_line(world, i, j, image);
    if (places != 1 && places != -1) return {never<Real>(), since};
    const Real s = Real(places > 0 ? 1 : -1);
    const Real rate = s * v[0] - growth;
    if (touch != Touch::none) return {touch == Touch::live && rate < 0 ? Real(0) : never<Real>(), since};
    return {gap_time<Real>(s * r[0] - sigma, rate), since};
  } else {
    if (touch == Touch::spent) return {never<Real>(), since};  // [papers/contact_times.md, eq. 20]
    if (touch == Touch::live) return {dot<Real, D>(r, v) - sigma * growth < 0 ? Real(0) : never<Real>(), since};
    if (growth == 0) return {sigma == 0 ? never<Real>() : meet_time<Real, D>(r, v, sigma), since};
    return {growing_meet_time<Real, D>(r, v, sigma, growth), since};
  }
}

namespace detail {

/// `ball` is as stored, but with the radius that it has at its stored time; it grows at the rate `growth`.
template <class Real, int D>
[[nodiscard]] inline Real growing_flight(const World<Real, D>&, const Ball<Real, D>& ball, const Real& growth,
                                         const Face<Real, D>& face, Touch touch) {
  const Real rate = (face.sign > 0 ? ball.velocity[face.axis] : -ball.velocity[face.axis]) - growth;
  return flight_to_plane<GrowingFlight<Real, D>>(touch, Real(face.gap(ball.position) - ball.radius), rate, Real(0));
}

template <class Real, int D>
[[nodiscard]] inline Real growing_flight(const World<Real, D>& world, const Ball<Real, D>& ball, const Real& growth,
                                         const Plane<Real, D>& plane, Touch touch) {
  const Vec<Real, D> x = ball.position - drift(world, plane, ball.time);
  const Real rate = dot<Real, D>(plane.direction, ball.velocity - plane.velocity) - growth;
  return flight_to_plane<GrowingFlight<Real, D>>(touch, Real(plane.gap(x) - ball.radius), rate, Real(0));
}

template <class Real, int D>
[[nodiscard]] inline Real growing_flight(const World<Real, D>& world, const Ball<Real, D>& ball, const Real& growth,
                                         const Sphere<Real, D>& sphere, Touch touch) {
  const Vec<Real, D> r = ball.position - drift(world, sphere, ball.time) - sphere.centre;
  const Vec<Real, D> v = ball.velocity - sphere.velocity;
  if (!sphere.inside) {
    const Real sigma = sphere.radius + ball.radius;
    if (touch == Touch::spent) return never<Real>();
    if (touch == Touch::live) return dot<Real, D>(r, v) - sigma * growth < 0 ? Real(0) : never<Real>();
    return growing_meet_time<Real, D>(r, v, sigma, growth);
  }
  const Real rho = sphere.radius - ball.radius;
  const Real outward = dot<Real, D>(r, v) + rho * growth;
  if (touch == Touch::live && outward > 0) return Real(0);
  // Inward bound the later root is taken with the gap as it is, so that rounding does not add up.
  return touch == Touch::none || outward < 0 ? growing_leave_time<Real, D>(r, v, rho, growth)
                                             : growing_chord_time<Real, D>(r, v, rho, growth);
}

/// Either side of a segment: where the ball comes down to its line between the ends, which are vertices of their own.
template <class Real>
[[nodiscard]] inline SidedFlight<Real> growing_flight_to_segment(const World<Real, 2>& world, const Ball<Real, 2>& ball,
                                                                 const Real& growth, const Segment<Real>& segment,
                                                                 const Contact<2>* contact) {
  const Touch touch = touch_of_wall(contact, ball);
  const Vec<Real, 2> x = ball.position - drift(world, segment, ball.time);
  const Vec<Real, 2> v = ball.velocity - segment.velocity;
  const Real height = segment.height(x), rate = dot<Real, 2>(segment.direction, v);
  int side = height > 0 || (height == 0 && rate > 0) ? 1 : -1;
  if (touch != Touch::none) side = contact->side;
  const Real falls = Real(side) * rate - growth;
  const Real t = flight_to_plane<GrowingFlight<Real, 2>>(touch, Real(Real(side) * height - ball.radius), falls, Real(0));
  if (t == never<Real>()) return {t, 0};
  const Vec<Real, 2> at = x + v * t;
  const bool within =
      dot<Real, 2>(segment.along, at - segment.from) >= 0 && dot<Real, 2>(segment.along, at - segment.to) <= 0;
  if (touch == Touch::none && !within) return {never<Real>(), 0};
  return {t, static_cast<std::int8_t>(side)};
}

}  // namespace detail

/// The meeting of ball i with one piece of a wall, which stands at `placed`, as an event: a face, a plane, a segment, a
/// circle or sphere. Scenes with other walls are refused.
template <GrowingMotion M, class Shape>
[[nodiscard]] inline Event<typename M::Real, M::dimension> meet_wall(const M& motion,
                                                                     const World<typename M::Real, M::dimension>& world,
                                                                     std::uint32_t i, const Shape& shape,
                                                                     const Shape& placed,
                                                                     const Image<M::dimension>& image) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  const Real growth = world.growth.rates[i];
  if (growth == 0) {
    const FreeFlight<Real, D>& same_size = motion;
    return meet_wall(same_size, world, i, shape, placed, image);
  }
  Event<Real, D> event;
  if constexpr (!is_curved<Shape>) {
    Ball<Real, D> ball = world.balls[i];
    if (ball.fixed) return event;
    ball.radius = radius_at(world, i, ball.time);
    const Contact<D>* contact = wall_contact(world, i, index(shape.wall), shape.feature, image);
    Real flight;
    if constexpr (std::is_same_v<Shape, Segment<Real>>) {
      const SidedFlight<Real> sided = detail::growing_flight_to_segment(world, ball, growth, placed, contact);
      flight = sided.flight;
      event.side = sided.side;
    } else {
      flight = detail::growing_flight(world, ball, growth, placed, touch_of_wall(contact, ball));
    }
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
  }
  return event;
}

}  // namespace carom
