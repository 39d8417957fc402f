#pragma once
// A face of the box: a plane across one axis.

#include <cstdint>

#include "carom/core/id.hpp"
#include "carom/core/vec.hpp"

namespace carom {

/// The half space sign * (x_axis - coordinate) >= 0.
template <class Real, int D>
struct Face {
  WallId wall{};
  std::int32_t feature = 0;
  int axis = 0;
  int sign = 1;               ///< +1: a lower face, balls above it; -1: an upper face
  Real coordinate = Real(0);  ///< [length unit]
  Real begin = Real(0);       ///< [length unit] 2-D: on the other axis, where it begins for who walks with the balls to his left

  [[nodiscard]] Real gap(const Vec<Real, D>& x) const { return sign > 0 ? x[axis] - coordinate : coordinate - x[axis]; }
  [[nodiscard]] Vec<Real, D> normal(const Vec<Real, D>&) const {
    Vec<Real, D> n = Vec<Real, D>::Zero();
    n[axis] = Real(sign);
    return n;
  }
  [[nodiscard]] Real curvature(const Vec<Real, D>&, std::int8_t) const { return Real(0); }
  /// [length unit] in 2-D, from the corner that it begins at; 0 in other dimensions.
  [[nodiscard]] Real arclength(const Vec<Real, D>& x) const {
    if constexpr (D != 2) return Real(0);
    const Real along = x[1 - axis] - begin;
    return (axis == 1) == (sign > 0) ? along : Real(-along);
  }
};

}  // namespace carom
