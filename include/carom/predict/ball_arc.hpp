#pragma once
// When a ball meets an arc, from inside or from outside.
//
// The centre of a ball of radius s crosses the circle of radius R + s inwards, or that of R - s outwards; the first crossing
// between the ends counts [papers/curved_walls.md, eq. 1]. A point's straight path crosses the circle twice at most, and
// which of the two crossings lies on the arc follows from the sides of the path on which its ends lie [eq. 2]: a joint is on
// one side, the same for both pieces that share it, so a point cannot slip through between them.

#include "carom/predict/contact.hpp"
#include "carom/predict/sided.hpp"
#include "carom/shape/arc.hpp"
#include "carom/solve/accelerated.hpp"
#include "carom/solve/quadratic.hpp"

namespace carom {

namespace detail {

/// The two crossings of a line with the circle, in the direction of flight: which of them lie on the arc.
struct OnArc {
  bool in = false, out = false;
};

/// r, v: the point relative to the centre; `ends`: on which sides of its path the ends lie.
template <class Real>
[[nodiscard]] inline OnArc crossings_on(const Arc<Real>& arc, const Vec<Real, 2>& r, const Vec<Real, 2>& v, int from, int to,
                                        const Real& doubt) {
  if (arc.whole) return {true, true};
  if (from > 0 && to < 0) return {false, true};
  if (from < 0 && to > 0) return {true, false};
  // Both or none: the path's point nearest to the centre lies beyond the chord of the arc, or does not.
  const Vec<Real, 2> nearest = r - v * (dot<Real, 2>(r, v) / dot<Real, 2>(v, v));
  const Vec<Real, 2> chord = arc.to - arc.from;
  const bool both = cross2<Real>(chord, Vec<Real, 2>(nearest + arc.centre - arc.from)) <= doubt * arc.radius;
  return {both, both};
}

template <class Real>
[[nodiscard]] inline SidedFlight<Real> straight_to_arc(const Arc<Real>& arc, const Vec<Real, 2>& x, const Vec<Real, 2>& v,
                                                       const Real& radius, Touch touch, std::int8_t side, const Real& doubt) {
  const Vec<Real, 2> r = x - arc.centre;
  const Real b = dot<Real, 2>(r, v);
  if (touch == Touch::live && (side > 0 ? b > 0 : b < 0)) return {Real(0), side};
  const SidedFlight<Real> none{never<Real>(), 0};
  if (dot<Real, 2>(v, v) == 0 || (touch != Touch::none && side < 0)) return none;
  OnArc on{true, true};
  if (radius == 0)
    on = crossings_on(arc, r, v, side_of_path(x, v, arc.from, arc.smooth_from), side_of_path(x, v, arc.to, arc.smooth_to),
                      doubt);
  // Beside the arc a ball meets its ends first; a point is placed by the sides of its path.
  const auto meets = [&](const Real& t) {
    return radius == 0 || arc.spans(Vec<Real, 2>(r + v * t), Real(0));
  };
  const Real outer = arc.radius + radius, inner = arc.radius - radius;
  if (touch == Touch::none && on.in && narrow(Wide<Real>(wide_dot<Real, 2>(r, r) - wide_product<Real>(outer, outer))) > 0) {
    const Real t = meet_time<Real, 2>(r, v, outer);
    if (t != never<Real>() && meets(t)) return {t, -1};
  }
  if (!(inner > 0) || !on.out) return none;
  const bool beyond = narrow(Wide<Real>(wide_dot<Real, 2>(r, r) - wide_product<Real>(inner, inner))) >= 0;
  Real t;
  if (touch != Touch::none) {
    t = b < 0 ? leave_time<Real, 2>(r, v, inner) : chord_time<Real, 2>(r, v);
  } else if (!beyond) {
    t = leave_time<Real, 2>(r, v, inner);
  } else if (b < 0) {
    if (meet_time<Real, 2>(r, v, inner) == never<Real>()) return none;
    t = leave_time<Real, 2>(r, v, inner);
  } else {  // a ball that overlaps it by a rounding
    if (radius == 0 || !(b > 0) || !(arc.height(x) > 0)) return none;
    t = Real(0);
  }
  return t != never<Real>() && meets(t) ? SidedFlight<Real>{t, 1} : none;
}

template <class Real>
[[nodiscard]] inline SidedFlight<Real> accelerated_to_arc(const Arc<Real>& arc, const Vec<Real, 2>& x, const Vec<Real, 2>& v,
                                                          const Vec<Real, 2>& a, const Real& radius, Touch touch,
                                                          std::int8_t side, const Real& doubt) {
  const Vec<Real, 2> r = x - arc.centre;
  const Real b = dot<Real, 2>(r, v), outer = arc.radius + radius, inner = arc.radius - radius;
  if (touch == Touch::live && (side > 0 ? b > 0 : b < 0)) return {Real(0), side};
  const Real margin = radius > 0 ? Real(0) : doubt;
  const auto spans = [&](const Real& t) { return arc.spans(Vec<Real, 2>(r + (v + a * (t / 2)) * t), margin); };
  const auto depth_in = [&](const Real& rho) {  // positive inside
    auto c = pair_polynomial<Real, 2>(r, v, a, rho);
    for (auto& x_i : c) x_i = -x_i;
    return c;
  };
  if (!(radius > 0)) return first_sided_crossing<Real>(depth_in(arc.radius), touch != Touch::none ? side : 0, 0, spans);
  if (touch == Touch::none && inner > 0 && b > 0 && arc.height(x) > 0 && arc.height(x) <= radius && spans(Real(0)))
    return {Real(0), 1};  // overlaps it by a rounding
  SidedFlight<Real> first{never<Real>(), 0};
  if (inner > 0) first = first_sided_crossing<Real>(depth_in(inner), touch != Touch::none && side > 0 ? 1 : 0, 1, spans);
  const SidedFlight<Real> from_outside =
      first_sided_crossing<Real>(depth_in(outer), touch != Touch::none && side < 0 ? -1 : 0, -1, spans);
  return from_outside.flight < first.flight ? from_outside : first;
}

}  // namespace detail

/// First time at which a ball of the given radius at x, with velocity v and acceleration a relative to the arc, meets it
/// between its ends (the ends themselves are vertices), and the side: +1 inside. `side`: that of a contact it is in.
template <bool accelerated, class Real>
[[nodiscard]] inline SidedFlight<Real> flight_to_arc(const Arc<Real>& arc, const Vec<Real, 2>& x, const Vec<Real, 2>& v,
                                                     const Vec<Real, 2>& a, const Real& radius, Touch touch,
                                                     std::int8_t side) {
  const Real doubt = place_doubt<Real>(x, arc.from, arc.to) + 16 * unit_roundoff<Real>() * arc.radius;
  if constexpr (accelerated) return detail::accelerated_to_arc(arc, x, v, a, radius, touch, side, doubt);
  return detail::straight_to_arc(arc, x, v, radius, touch, side, doubt);
}

}  // namespace carom
