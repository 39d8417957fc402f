#pragma once
// A plane (a line in 2-D, a point in 1-D); balls stay on the side that its normal points to.

#include <cstdint>

#include "carom/core/id.hpp"
#include "carom/core/vec.hpp"

namespace carom {

/// The half space n.(x - p) >= 0, moving with a constant velocity.
template <class Real, int D>
struct Plane {
  WallId wall{};
  std::int32_t feature = 0;
  Vec<Real, D> point;      ///< [length unit] at the world's start
  Vec<Real, D> direction;  ///< unit normal
  Vec<Real, D> velocity;   ///< [length unit / L]
  std::int32_t swing = -1;  ///< row of Walls::swings; -1: none

  [[nodiscard]] Real gap(const Vec<Real, D>& x) const { return dot<Real, D>(direction, x - point); }
  [[nodiscard]] Vec<Real, D> normal(const Vec<Real, D>&) const { return direction; }
  [[nodiscard]] Real curvature(const Vec<Real, D>&, std::int8_t) const { return Real(0); }
  /// [length unit] in 2-D, from `point`, for who walks with the balls to his left; 0 in other dimensions.
  [[nodiscard]] Real arclength(const Vec<Real, D>& x) const {
    if constexpr (D != 2) return Real(0);
    else return direction[1] * (x[0] - point[0]) - direction[0] * (x[1] - point[1]);
  }
};

}  // namespace carom
