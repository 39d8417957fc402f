#pragma once
// Two balls become one: mass, momentum and volume (area in 2-D, length in 1-D) are kept.

#include <cmath>

#include "carom/core/vec.hpp"

namespace carom {

/// Radius of a ball of the summed volume. In 3-D the cube root is taken by Newton's iteration from above, which ends when
/// it no longer falls: the same bits on every machine.
template <int D, class Real>
[[nodiscard]] inline Real merged_radius(const Real& a, const Real& b) {
  using std::sqrt;
  if constexpr (D == 1) {
    return a + b;
  } else if constexpr (D == 2) {
    return sqrt(a * a + b * b);
  } else {
    const Real large = a > b ? a : b;
    if (!(large > 0)) return Real(0);
    const Real p = a / large, q = b / large;
    const Real volume = p * p * p + q * q * q;  // 1..2
    Real x(2);
    while (true) {
      const Real next = (2 * x + volume / (x * x)) / 3;
      if (!(next < x)) return x * large;
      x = next;
    }
  }
}

}  // namespace carom
