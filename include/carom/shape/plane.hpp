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

  [[nodiscard]] Real gap(const Vec<Real, D>& x) const { return dot<Real, D>(direction, x - point); }
  [[nodiscard]] Vec<Real, D> normal(const Vec<Real, D>&) const { return direction; }
};

}  // namespace carom
