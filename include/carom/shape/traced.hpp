#pragma once
// Curves that are traced by a parameter, and what is known of a piece of one.
//
// Between u0 and u1 a curve y(u) with |y''| <= M is nowhere further than M (u1 - u0)^2 / 8 from its chord
// [papers/curved_walls.md, eq. 4]. So a piece lies in a capsule about its chord, and four times nearer to it after each
// halving: bounds that hold, by which pieces are put aside that cannot count.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <vector>

#include "carom/core/vec.hpp"

namespace carom {

/// y, y' and y'' at one value of the parameter.
template <class Real>
struct TracedFrame {
  Vec<Real, 2> place, along, bend;

  [[nodiscard]] Vec<Real, 2> left() const { return Vec<Real, 2>(-along[1], along[0]); }
};

/// y(u), begin() <= u <= end(), relative to a centre; along(u) = y'(u); |y''| <= bend_bound(), |y'''| <= twist_bound().
/// size(): no place on it is further from the centre. A curve goes on beyond its ends with the same bounds.
template <class C, class Real>
concept Traced = requires(const C& c, const Real& u) {
  { c.place(u) } -> std::convertible_to<Vec<Real, 2>>;
  { c.along(u) } -> std::convertible_to<Vec<Real, 2>>;
  { c.frame(u) } -> std::convertible_to<TracedFrame<Real>>;
  { c.begin() } -> std::convertible_to<Real>;
  { c.end() } -> std::convertible_to<Real>;
  { c.bend_bound() } -> std::convertible_to<Real>;
  { c.twist_bound() } -> std::convertible_to<Real>;
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
    order_.reserve(64);
    const Real width = (curve.end() - curve.begin()) / Real(pieces_at_first);
    Real from = curve.begin();
    const Vec<Real, 2> begin = curve.place(from);
    Vec<Real, 2> first = begin;
    for (int i = 0; i < pieces_at_first; ++i) {
      const Real to = i + 1 == pieces_at_first ? Real(curve.end()) : Real(curve.begin() + Real(i + 1) * width);
      const Vec<Real, 2> last = curve.closed() && i + 1 == pieces_at_first ? begin : curve.place(to);
      push({bound, from, to, first, last});
      from = to;
      first = last;
    }
  }

  [[nodiscard]] bool empty() const { return order_.empty(); }
  /// No piece has a smaller bound.
  [[nodiscard]] const Real& least_bound() const { return order_.front().bound; }
  void push(const TracedPiece<Real>& p) {
    order_.push_back({p.bound, p.from, static_cast<std::uint32_t>(pieces_.size())});
    pieces_.push_back(p);
    std::push_heap(order_.begin(), order_.end(), later);
  }
  [[nodiscard]] TracedPiece<Real> pop() {
    std::pop_heap(order_.begin(), order_.end(), later);
    const TracedPiece<Real> p = pieces_[order_.back().place];
    order_.pop_back();
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
  struct Place {
    Real bound, from;
    std::uint32_t place;
  };
  [[nodiscard]] static bool later(const Place& a, const Place& b) {
    return a.bound > b.bound || (a.bound == b.bound && a.from > b.from);
  }
  std::vector<TracedPiece<Real>> pieces_;
  std::vector<Place> order_;
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

}  // namespace carom
