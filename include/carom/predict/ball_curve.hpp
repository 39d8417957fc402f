#pragma once
// When a ball meets an ellipse, a parabola or a curve r(theta): a point in closed form where there is one, else by bounds.

#include "carom/predict/contact.hpp"
#include "carom/predict/sided.hpp"
#include "carom/predict/traced_flight.hpp"
#include "carom/shape/ellipse.hpp"
#include "carom/shape/parabola.hpp"
#include "carom/shape/polar_curve.hpp"
#include "carom/solve/accelerated.hpp"
#include "carom/solve/quadratic.hpp"

namespace carom {

namespace detail {

/// Whether a ball that is at the curve from the outset, at u, meets it now. n: towards the ball; `resolved`: their contact
/// has just been resolved, so that closing by no more than rounding counts as 0.
template <class Real, Traced<Real> Curve, class Path>
[[nodiscard]] inline bool closes_now(const Curve& curve, const Path& path, const Vec<Real, 2>& n, const Real& u, bool resolved) {
  const Real rate = dot<Real, 2>(n, path.v), pull = dot<Real, 2>(n, path.acceleration());
  if (!resolved) return rate < 0 || (rate == 0 && pull < 0);
  if (rate > 0) return false;
  const Real doubt = 16 * unit_roundoff<Real>() * length_of<Real>(n) * length_of<Real>(path.v);
  if (rate < -doubt) return true;
  // Pressed: to second order the curve comes to meet the ball, or the ball the curve.
  const TracedFrame<Real> at = curve.frame(u);
  const Real ahead = dot<Real, 2>(at.along, path.v), stretch = dot<Real, 2>(at.along, at.along);
  return pull * stretch * stretch < dot<Real, 2>(n, at.bend) * ahead * ahead;
}

/// By bounds [papers/curved_walls.md]. `side`: the one that the ball is on, +1 to the left of the curve; 0: not known, the
/// one that its velocity points to.
template <class Real, Traced<Real> Curve, class Path>
[[nodiscard]] SidedFlight<Real> traced_flight(const Curve& curve, const Path& path, const Real& radius, Touch touch,
                                              std::int8_t side) {
  const auto left_of = [&curve](const Real& u) {
    const Vec<Real, 2> along = curve.along(u);
    return Vec<Real, 2>(-along[1], along[0]);
  };
  const auto starts = [&](const Real& near) {
    const Real u = squared_up<Real>(curve, path.x, near);
    if (radius > 0)
      return closes_now<Real>(curve, path, Vec<Real, 2>(path.x - curve.place(u)), u, touch == Touch::spent);
    if (side == 0) return false;
    return closes_now<Real>(curve, path, Vec<Real, 2>(left_of(u) * Real(side)), u, touch == Touch::spent);
  };
  const TracedMeeting<Real> found =
      FirstMeeting<Real, Curve, Path, decltype(starts)>(curve, path, radius, side, starts).find();
  if (found.time == never<Real>()) return {never<Real>(), 0};
  const Vec<Real, 2> left = left_of(found.parameter);
  const Real from_left = radius > 0
                             ? dot<Real, 2>(left, Vec<Real, 2>(path.at(found.time) - curve.place(found.parameter)))
                             : Real(-dot<Real, 2>(left, path.velocity(found.time)));
  const std::int8_t met = from_left > 0 ? std::int8_t(1) : std::int8_t(-1);
  return {found.time, found.time > 0 || side == 0 ? met : side};
}

/// A ball inside a circle or sphere about the origin; rho: its radius less that of the ball.
template <bool accelerated, class Real, int D>
[[nodiscard]] inline Real flight_inside(const Vec<Real, D>& r, const Vec<Real, D>& v, const Vec<Real, D>& a, const Real& rho,
                                        Touch touch) {
  const Real outward = dot<Real, D>(r, v);
  if (touch == Touch::live && outward > 0) return Real(0);
  if constexpr (accelerated)
    return touch == Touch::none ? leave_time<Real, D>(r, v, a, rho) : chord_time<Real, D>(r, v, a);
  // Inward bound the later root is the one wanted, touching or not; taken with the gap as it is, it keeps |r| from
  // wandering.
  return touch == Touch::none || outward < 0 ? leave_time<Real, D>(r, v, rho) : chord_time<Real, D>(r, v);
}
/// A ball outside of it; sigma: the sum of the radii.
template <bool accelerated, class Real, int D>
[[nodiscard]] inline Real flight_outside(const Vec<Real, D>& r, const Vec<Real, D>& v, const Vec<Real, D>& a,
                                         const Real& sigma, Touch touch) {
  if (touch == Touch::live && dot<Real, D>(r, v) < 0) return Real(0);
  if constexpr (accelerated)
    return touch == Touch::none ? meet_time<Real, D>(r, v, a, sigma) : next_meet_time<Real, D>(r, v, a);
  return touch == Touch::none ? meet_time<Real, D>(r, v, sigma) : never<Real>();
}

}  // namespace detail

/// A point meets an ellipse where, in the frame in which that is a circle of radius 1, it meets the circle
/// [papers/curved_walls.md, eq. 3]; a ball, by bounds. Here and below x, v, a are relative to the wall at its place.
template <bool accelerated, class Real>
[[nodiscard]] inline SidedFlight<Real> flight_to_curve(const Ellipse<Real>& ellipse, const Vec<Real, 2>& x,
                                                       const Vec<Real, 2>& v, const Vec<Real, 2>& a, const Real& radius,
                                                       Touch touch, std::int8_t) {
  const Vec<Real, 2> r = x - ellipse.centre;
  if (radius > 0)
    return detail::traced_flight<Real>(ellipse, ParabolicPath<Real>{r, v, a}, radius, touch, ellipse.home());
  const Vec<Real, 2> c = ellipse.rounded(r), w = ellipse.rounded(v), g = ellipse.rounded(a);
  return {ellipse.inside ? detail::flight_inside<accelerated, Real, 2>(c, w, g, Real(1), touch)
                         : detail::flight_outside<accelerated, Real, 2>(c, w, g, Real(1), touch),
          ellipse.home()};
}

template <bool accelerated, class Real>
[[nodiscard]] inline SidedFlight<Real> flight_to_curve(const PolarCurve<Real>& curve, const Vec<Real, 2>& x,
                                                       const Vec<Real, 2>& v, const Vec<Real, 2>& a, const Real& radius,
                                                       Touch touch, std::int8_t) {
  SidedFlight<Real> found = detail::traced_flight<Real>(
      curve, ParabolicPath<Real>{Vec<Real, 2>(x - curve.centre), v, a}, radius, touch, curve.home());
  found.side = curve.home();
  return found;
}

/// A point meets a parabola where 4 f p - q^2, a polynomial in time, changes its sign; a ball, by bounds. `side`: that of a
/// contact it is in.
template <bool accelerated, class Real>
[[nodiscard]] inline SidedFlight<Real> flight_to_curve(const Parabola<Real>& parabola, const Vec<Real, 2>& x,
                                                       const Vec<Real, 2>& v, const Vec<Real, 2>& a, const Real& radius,
                                                       Touch touch, std::int8_t side) {
  using std::abs;
  const Vec<Real, 2> r = x - parabola.centre;
  const ParabolicPath<Real> path{r, v, a};
  if (radius > 0) return detail::traced_flight<Real>(parabola, path, radius, touch, side);
  const Vec<Real, 2> x0 = parabola.framed(r), x1 = parabola.framed(v), x2 = parabola.framed(Vec<Real, 2>(a / 2));
  const Real f = 4 * parabola.focal_length, rate = f * x1[0] - 2 * x0[1] * x1[1];
  if (touch == Touch::live && (side > 0 ? rate < 0 : rate > 0)) return {Real(0), side};
  const auto product = [](const Real& s, const Real& t) { return wide_product<Real>(s, t); };
  using W = Wide<Real>;
  const Real two(2);
  const std::array<W, 5> form{W(product(f, x0[0]) - product(x0[1], x0[1])),
                              W(product(f, x1[0]) - product(Real(two * x0[1]), x1[1])),
                              W(product(f, x2[0]) - product(x1[1], x1[1]) - product(Real(two * x0[1]), x2[1])),
                              W(-product(Real(two * x1[1]), x2[1])), W(-product(x2[1], x2[1]))};
  // Past its ends by no more than rounding is still on it: a point does not slip through a joint.
  const Real width = parabola.half_width + traced_doubt<Real>(parabola, r);
  const auto spans = [&](const Real& t) { return abs(parabola.framed(path.at(t))[1]) <= width; };
  return first_sided_crossing<Real>(form, touch != Touch::none ? side : 0, 0, spans);
}

}  // namespace carom
