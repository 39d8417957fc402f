#pragma once
// A circle in 2-D, a sphere in 3-D, with the balls inside or outside of it. Radius 0 is a point: a vertex or an end.

#include <cstdint>

#include "carom/core/angle.hpp"
#include "carom/core/id.hpp"
#include "carom/core/vec.hpp"

namespace carom {

template <class Real, int D>
struct Sphere {
  WallId wall{};
  std::int32_t feature = 0;
  Vec<Real, D> centre;    ///< [length unit] at the world's start
  Vec<Real, D> velocity;  ///< [length unit / L]
  std::int32_t swing = -1;  ///< row of Walls::swings; -1: none
  Real radius = Real(0);  ///< [length unit]
  bool inside = true;     ///< the balls are inside (a concave wall)
  bool smooth = false;    ///< radius 0: a joint without a corner, which points do not meet

  [[nodiscard]] Real gap(const Vec<Real, D>& x) const {
    using std::sqrt;
    const Vec<Real, D> r = x - centre;
    const Real distance = sqrt(dot<Real, D>(r, r));
    return inside ? radius - distance : distance - radius;
  }
  /// Towards the balls; not normalised at the centre itself.
  [[nodiscard]] Vec<Real, D> normal(const Vec<Real, D>& x) const {
    const Vec<Real, D> r = x - centre;
    return inside ? Vec<Real, D>(-r) : r;
  }
  /// [1/length unit] < 0 inside; infinite at a vertex.
  [[nodiscard]] Real curvature(const Vec<Real, D>&, std::int8_t) const {
    if (!(radius > 0)) return infinity<Real>();
    return inside ? Real(-1 / radius) : Real(1 / radius);
  }
  /// [length unit] in 2-D, from angle 0, anticlockwise; 0 in other dimensions. Not among what decides events.
  [[nodiscard]] Real arclength(const Vec<Real, D>& x) const {
    if constexpr (D != 2) return Real(0);
    else return radius * angle_of<Real>(Vec<Real, D>(x - centre));
  }
};

}  // namespace carom
