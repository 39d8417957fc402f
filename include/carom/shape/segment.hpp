#pragma once
// A straight wall between two points in the plane; balls may be on either side. Its ends are points of their own.

#include <cstdint>

#include "carom/core/id.hpp"
#include "carom/core/vec.hpp"

namespace carom {

template <class Real>
struct Segment {
  WallId wall{};
  std::int32_t feature = 0;
  Vec<Real, 2> from, to;   ///< [length unit] at the world's start
  Vec<Real, 2> along;      ///< unit vector from -> to
  Vec<Real, 2> direction;  ///< unit normal, to the left of `along`
  Vec<Real, 2> velocity;   ///< [length unit / L]
  std::int32_t swing = -1;  ///< row of Walls::swings; -1: none
  bool smooth_from = false, smooth_to = false;  ///< the next piece goes on there without a corner

  /// Distance to the left of the line through the segment.
  [[nodiscard]] Real height(const Vec<Real, 2>& x) const { return dot<Real, 2>(direction, x - from); }
  /// Distance to the segment.
  [[nodiscard]] Real gap(const Vec<Real, 2>& x) const {
    using std::abs;
    using std::sqrt;
    const Real before = dot<Real, 2>(along, x - from), beyond = dot<Real, 2>(along, x - to);
    if (before >= 0 && beyond <= 0) return abs(height(x));
    const Vec<Real, 2> r = before < 0 ? Vec<Real, 2>(x - from) : Vec<Real, 2>(x - to);
    return sqrt(dot<Real, 2>(r, r));
  }
  /// Towards the left; the side that a ball is on is part of its contact.
  [[nodiscard]] Vec<Real, 2> normal(const Vec<Real, 2>&) const { return direction; }
  [[nodiscard]] Real curvature(const Vec<Real, 2>&, std::int8_t) const { return Real(0); }
  /// [length unit] from `from`.
  [[nodiscard]] Real arclength(const Vec<Real, 2>& x) const { return dot<Real, 2>(along, x - from); }
};

}  // namespace carom
