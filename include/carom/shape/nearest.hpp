#pragma once
// The place on a traced curve that is nearest to a point.

#include <algorithm>
#include <cmath>

#include "carom/shape/traced.hpp"

namespace carom {

namespace detail {

/// A place on a curve, and how far it is from a point.
template <class Real>
struct PlaceOnCurve {
  Real distance;
  Real parameter;
};

/// The place where r = x - y(u) stands square on the curve, near u: Newton's method, as long as it comes nearer. Ends stay.
template <class Real, Traced<Real> Curve>
[[nodiscard]] inline Real squared_up(const Curve& curve, const Vec<Real, 2>& x, Real u) {
  using std::abs;
  Real last = infinity<Real>();
  for (int i = 0; i < 40; ++i) {
    const TracedFrame<Real> at = curve.frame(u);
    const Vec<Real, 2> r = x - at.place;
    const Real slant = dot<Real, 2>(r, at.along), slope = dot<Real, 2>(r, at.bend) - dot<Real, 2>(at.along, at.along);
    if (!(slope < 0)) return u;
    const Real step = slant / slope;
    if (!(2 * abs(step) < last)) return u;
    last = abs(step);
    Real next = u - step;
    if (!curve.closed()) next = std::clamp<Real>(next, curve.begin(), curve.end());
    if (next == u) return u;
    u = next;
  }
  return u;
}

/// Whether (x - y).y', the slope of distance^2 / 2 but for its sign, falls all along a piece of the curve about `middle`, half
/// as wide as `half` says: then at most one place on it stands square to x, and that is the nearest.
template <class Real, Traced<Real> Curve>
[[nodiscard]] inline bool one_foot(const Curve& curve, const Vec<Real, 2>& x, const TracedFrame<Real>& middle, const Real& half) {
  const Real bend = curve.bend_bound(), fastest = length_of<Real>(middle.along) + half * bend;
  const Vec<Real, 2> r = x - middle.place;
  const Real slope = dot<Real, 2>(r, middle.bend) - dot<Real, 2>(middle.along, middle.along);
  const Real change = (length_of<Real>(r) + half * fastest) * curve.twist_bound() + 3 * fastest * bend;
  return slope + half * change < 0;
}

}  // namespace detail

/// The parameter of the place on the curve that is nearest to x (relative to the curve's centre). Pieces are put aside that are
/// further than a place known, or on which no other place than that stands square to x.
template <class Real, Traced<Real> Curve>
[[nodiscard]] Real nearest_on(const Curve& curve, const Vec<Real, 2>& x) {
  using std::abs;
  const Real doubt = traced_doubt<Real>(curve, x), bend = curve.bend_bound();
  TracedPieces<Real> pieces(curve, Real(0));
  detail::PlaceOnCurve<Real> best{infinity<Real>(), curve.begin()};
  const auto offer = [&](const Real& u, const Vec<Real, 2>& place) {
    const Real distance = length_of<Real>(Vec<Real, 2>(x - place));
    if (distance < best.distance) best = {distance, u};
  };
  while (!pieces.empty()) {
    TracedPiece<Real> p = pieces.pop();
    if (!(p.bound < best.distance)) break;
    const Real bulge = p.bulge(bend);
    const Real bound = length_of<Real>(Vec<Real, 2>(x - nearest_on_chord(x, p.first, p.last))) - bulge;
    if (bound > p.bound) {  // not looked at so far
      p.bound = bound;
      pieces.push(p);
      continue;
    }
    const Real middle = (p.from + p.to) / 2, half = (p.to - p.from) / 2;
    const TracedFrame<Real> at = curve.frame(middle);
    if (bulge <= doubt) {
      const Real u = detail::squared_up<Real>(curve, x, middle);
      offer(u, curve.place(u));
      continue;
    }
    if (detail::one_foot<Real>(curve, x, at, half)) {
      const Real u = detail::squared_up<Real>(curve, x, middle), away = abs(u - middle);
      offer(u, curve.place(u));
      offer(p.from, p.first);
      offer(p.to, p.last);
      if (away <= half || detail::one_foot<Real>(curve, x, at, away)) continue;
    }
    pieces.push_halves(curve, p);
  }
  const Real u = best.parameter, round = curve.end() - curve.begin();
  if (!curve.closed()) return u;
  return u < curve.begin() ? Real(u + round) : u > curve.end() ? Real(u - round) : u;
}

}  // namespace carom
