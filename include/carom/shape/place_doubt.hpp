#pragma once
// How far rounding can put a place off the truth.

#include <cmath>

#include "carom/core/vec.hpp"

namespace carom {

/// Of a place that is computed, where the coordinates in play are those of `at` and of the ends of a piece: 8 u of their sum
/// [length unit].
template <class Real>
[[nodiscard]] inline Real place_doubt(const Vec<Real, 2>& at, const Vec<Real, 2>& from, const Vec<Real, 2>& to) {
  using std::abs;
  return 8 * unit_roundoff<Real>() *
         (abs(at[0]) + abs(at[1]) + abs(from[0]) + abs(from[1]) + abs(to[0]) + abs(to[1]));
}

}  // namespace carom
