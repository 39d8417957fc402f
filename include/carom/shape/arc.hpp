#pragma once
// A part of a circle in the plane; balls may be on either side. Its ends are points of their own.

#include <cstdint>

#include "carom/core/angle.hpp"
#include "carom/core/id.hpp"
#include "carom/core/vec.hpp"

namespace carom {

template <class Real>
struct Arc {
  WallId wall{};
  std::int32_t feature = 0;
  Vec<Real, 2> centre;    ///< [length unit] at the world's start
  Real radius = Real(1);  ///< [length unit]
  Vec<Real, 2> from, to;  ///< [length unit] its ends, anticlockwise; where another piece begins, that piece's end
  Vec<Real, 2> velocity;  ///< [length unit / L]
  Real turn = Real(0);    ///< [rad] it extends over; 2 pi: a circle, without ends
  bool whole = false;     ///< a circle
  bool wide = false;      ///< over more than half of a circle
  bool smooth_from = false, smooth_to = false;  ///< goes on there without a corner

  /// Distance to the left of the circle, which is its inside.
  [[nodiscard]] Real height(const Vec<Real, 2>& x) const {
    using std::sqrt;
    const Vec<Real, 2> r = x - centre;
    return radius - sqrt(dot<Real, 2>(r, r));
  }
  /// Whether the direction of r = x - centre lies between those of the ends, or within `doubt` [length unit] of that.
  [[nodiscard]] bool spans(const Vec<Real, 2>& r, const Real& doubt) const {
    if (whole) return true;
    const Vec<Real, 2> a = from - centre, b = to - centre;
    const Real margin = -doubt * radius, after = cross2<Real>(a, r), before = cross2<Real>(r, b);
    if (wide) return after >= margin || before >= margin;
    return after >= margin && before >= margin && dot<Real, 2>(r, middle()) >= margin;
  }
  /// Distance to the arc.
  [[nodiscard]] Real gap(const Vec<Real, 2>& x) const {
    using std::abs;
    using std::min;
    using std::sqrt;
    if (spans(Vec<Real, 2>(x - centre), Real(0))) return abs(height(x));
    const Vec<Real, 2> r = x - from, s = x - to;
    return sqrt(Real(min(dot<Real, 2>(r, r), dot<Real, 2>(s, s))));
  }
  /// Towards the left, the centre; the side that a ball is on is part of its contact. Of any length.
  [[nodiscard]] Vec<Real, 2> normal(const Vec<Real, 2>& x) const { return centre - x; }
  [[nodiscard]] Real curvature(const Vec<Real, 2>&, std::int8_t side) const { return Real(-side) / radius; }
  /// [length unit] from `from`.
  [[nodiscard]] Real arclength(const Vec<Real, 2>& x) const {
    const Real angle = angle_of<Real>(Vec<Real, 2>(x - centre)) - angle_of<Real>(Vec<Real, 2>(from - centre));
    const Real along = radius * (angle < 0 ? Real(angle + 2 * pi<Real>()) : angle);
    // A rounding before its beginning is the beginning.
    return along > radius * (turn + pi<Real>()) ? Real(0) : along;
  }
  /// A direction from the centre that runs through the arc.
  [[nodiscard]] Vec<Real, 2> middle() const {
    const Vec<Real, 2> chord = to - from;
    return Vec<Real, 2>(chord[1], -chord[0]);
  }
};

}  // namespace carom
