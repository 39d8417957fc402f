#pragma once
// Curves that are traced by a parameter: what is known of a piece of one, and the place on one that is nearest to a point.
//
// Between u0 and u1 a curve y(u) with |y''| <= M is nowhere further than M (u1 - u0)^2 / 8 from its chord
// [papers/curved_walls.md, eq. 4]. So a piece lies in a capsule about its chord, and four times nearer to it after each
// halving: bounds that hold, by which pieces are put aside that cannot count.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <vector>

#include "carom/core/vec.hpp"

namespace carom {

/// y(u), begin() <= u <= end(), relative to a centre; along(u) = y'(u), bend(u) = y''(u), |y''| <= bend_bound().
/// size(): no place on it is further from the centre.
template <class C, class Real>
concept Traced = requires(const C& c, const Real& u) {
  { c.place(u) } -> std::convertible_to<Vec<Real, 2>>;
  { c.along(u) } -> std::convertible_to<Vec<Real, 2>>;
  { c.bend(u) } -> std::convertible_to<Vec<Real, 2>>;
  { c.begin() } -> std::convertible_to<Real>;
  { c.end() } -> std::convertible_to<Real>;
  { c.bend_bound() } -> std::convertible_to<Real>;
  { c.size() } -> std::convertible_to<Real>;
  { c.closed() } -> std::convertible_to<bool>;
};

/// A piece of a curve, and a number that nothing on it falls below.
template <class Real>
struct TracedPiece {
  Real bound;
  Real from, to;          ///< values of the parameter
  Vec<Real, 2> first, last;  ///< its ends

  /// Distance from the chord that no place on the piece exceeds.
  [[nodiscard]] Real bulge(const Real& bend_bound) const { return bend_bound * (to - from) * (to - from) / 8; }
};

/// Pieces by their bounds; the smallest comes first, of equal ones the one that begins first.
template <class Real>
class TracedPieces {
 public:
  static constexpr int pieces_at_first = 8;

  template <class Curve>
  TracedPieces(const Curve& curve, const Real& bound) {
    pieces_.reserve(64);
    const Real width = (curve.end() - curve.begin()) / Real(pieces_at_first);
    Real from = curve.begin();
    Vec<Real, 2> first = curve.place(from);
    for (int i = 0; i < pieces_at_first; ++i) {
      const Real to = i + 1 == pieces_at_first ? Real(curve.end()) : Real(curve.begin() + Real(i + 1) * width);
      const Vec<Real, 2> last = curve.closed() && i + 1 == pieces_at_first ? curve.place(curve.begin()) : curve.place(to);
      push({bound, from, to, first, last});
      from = to;
      first = last;
    }
  }

  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  void push(const TracedPiece<Real>& p) {
    pieces_.push_back(p);
    std::push_heap(pieces_.begin(), pieces_.end(), later);
  }
  [[nodiscard]] TracedPiece<Real> pop() {
    std::pop_heap(pieces_.begin(), pieces_.end(), later);
    const TracedPiece<Real> p = pieces_.back();
    pieces_.pop_back();
    return p;
  }
  template <class Curve>
  void push_halves(const Curve& curve, const TracedPiece<Real>& p) {
    const Real middle = (p.from + p.to) / 2;
    const Vec<Real, 2> place = curve.place(middle);
    push({p.bound, p.from, middle, p.first, place});
    push({p.bound, middle, p.to, place, p.last});
  }

 private:
  [[nodiscard]] static bool later(const TracedPiece<Real>& a, const TracedPiece<Real>& b) {
    return a.bound > b.bound || (a.bound == b.bound && a.from > b.from);
  }
  std::vector<TracedPiece<Real>> pieces_;
};

/// The place on the chord a-b that is nearest to x.
template <class Real>
[[nodiscard]] inline Vec<Real, 2> nearest_on_chord(const Vec<Real, 2>& x, const Vec<Real, 2>& a, const Vec<Real, 2>& b) {
  const Vec<Real, 2> chord = b - a;
  const Real length = dot<Real, 2>(chord, chord), along = dot<Real, 2>(chord, Vec<Real, 2>(x - a));
  if (!(along > 0)) return a;
  if (along >= length) return b;
  return a + chord * (along / length);
}

template <class Real>
[[nodiscard]] inline Real length_of(const Vec<Real, 2>& r) {
  using std::sqrt;
  return sqrt(dot<Real, 2>(r, r));
}

/// Below it rounding moves places on the curve, and what is near it: 16 u of the coordinates in play.
template <class Real, Traced<Real> Curve>
[[nodiscard]] inline Real traced_doubt(const Curve& curve, const Vec<Real, 2>& x) {
  using std::abs;
  return 16 * unit_roundoff<Real>() * (curve.size() + abs(x[0]) + abs(x[1]));
}

/// The place where r = x - y(u) stands square on the curve, near u: Newton's method, as long as it comes nearer. Ends stay.
template <class Real, Traced<Real> Curve>
[[nodiscard]] inline Real squared_up(const Curve& curve, const Vec<Real, 2>& x, Real u) {
  using std::abs;
  Real last = infinity<Real>();
  for (int i = 0; i < 8; ++i) {
    const Vec<Real, 2> r = x - curve.place(u), along = curve.along(u);
    const Real slant = dot<Real, 2>(r, along), slope = dot<Real, 2>(r, curve.bend(u)) - dot<Real, 2>(along, along);
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

/// The parameter of the place on the curve that is nearest to x (relative to the curve's centre).
template <class Real, Traced<Real> Curve>
[[nodiscard]] Real nearest_on(const Curve& curve, const Vec<Real, 2>& x) {
  const Real doubt = traced_doubt<Real>(curve, x), bend = curve.bend_bound();
  TracedPieces<Real> pieces(curve, Real(0));
  while (true) {
    TracedPiece<Real> p = pieces.pop();
    const Real bulge = p.bulge(bend);
    const Real bound = length_of<Real>(Vec<Real, 2>(x - nearest_on_chord(x, p.first, p.last))) - bulge;
    if (bound > p.bound) {  // not looked at so far
      p.bound = bound;
      pieces.push(p);
    } else if (bulge <= doubt) {
      return squared_up<Real>(curve, x, Real((p.from + p.to) / 2));
    } else {
      pieces.push_halves(curve, p);
    }
  }
}

}  // namespace carom
