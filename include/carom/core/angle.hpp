#pragma once
// Angles in the plane. They tell users where something is; nothing that happens is decided by them.

#include <cmath>

#include "carom/core/vec.hpp"

namespace carom {

/// pi as the arithmetic of T knows it.
template <Real T>
[[nodiscard]] inline T pi() {
  using std::atan2;
  return T(atan2(T(0), T(-1)));
}

/// Direction of r, anticlockwise from the x axis [rad], 0 <= angle < 2 pi.
template <Real T>
[[nodiscard]] inline T angle_of(const Vec<T, 2>& r) {
  using std::atan2;
  const T angle = T(atan2(T(r[1]), T(r[0])));
  return angle < 0 ? T(angle + 2 * pi<T>()) : angle;
}

}  // namespace carom
