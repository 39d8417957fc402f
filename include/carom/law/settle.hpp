#pragma once
// Rounding a wide result once, so that its own small error does not show.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "carom/core/double_double.hpp"

namespace carom {

/// The real nearest to x, where x is known to +-error: 0 if that cannot be told from 0, and the even neighbour if it cannot
/// be told from the middle between two. So two evaluations of one quantity in different orders settle on the same bits,
/// and of opposite quantities on opposite ones, unless the exact value lies within the error of such a point but not on it.
[[nodiscard]] inline double settle(const DoubleDouble& x, double error) {
  if (!(std::abs(x.hi) > error)) return 0.0;
  if (x.lo == 0.0) return x.hi;
  const double infinity = std::numeric_limits<double>::infinity();
  const double other = std::nextafter(x.hi, x.lo > 0.0 ? infinity : -infinity);
  const double middle = 0.5 * std::abs(other - x.hi);
  if (middle - std::abs(x.lo) > error) return x.hi;
  return (std::bit_cast<std::uint64_t>(x.hi) & 1u) == 0 ? x.hi : other;
}
template <Real T>
[[nodiscard]] T settle(const T& x, const T& error) {
  using std::abs;
  return abs(x) > error ? x : T(0);
}

}  // namespace carom
