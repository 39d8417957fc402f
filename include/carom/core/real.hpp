#pragma once
// The real type that everything from `solve` to `sim` is a template on: double, or a number of Boost.Multiprecision.

#include <cmath>
#include <concepts>
#include <limits>

namespace carom {

namespace detail {
using std::abs;
using std::floor;
using std::frexp;
using std::ldexp;
using std::sqrt;

// The standard functions for double and, by argument-dependent look-up, those of the number's own namespace.
template <class T>
concept HasElementaryFunctions = requires(const T x, int n) {
  T(sqrt(x));
  T(abs(x));
  T(floor(x));
  T(ldexp(x, n));
  T(frexp(x, &n));
};
}  // namespace detail

/// A floating-point number with the four operations, an order, an infinity, and sqrt, abs, floor, ldexp, frexp.
template <class T>
concept Real = std::copyable<T> && std::numeric_limits<T>::is_specialized && !std::numeric_limits<T>::is_integer &&
               std::numeric_limits<T>::has_infinity && std::constructible_from<T, int> &&
               detail::HasElementaryFunctions<T> && requires(const T x) {
                 T(-x);
                 T(x + x);
                 T(x - x);
                 T(x * x);
                 T(x / x);
                 bool(x < x);
                 bool(x == x);
               };

/// The time of an event that does not happen: +infinity. Ordered after every time.
template <Real T>
[[nodiscard]] constexpr T never() {
  return std::numeric_limits<T>::infinity();
}

/// Bits of the significand (the digits that are sure, for a decimal number).
template <Real T>
inline constexpr int significand_bits = std::numeric_limits<T>::radix == 10
                                            ? int(std::numeric_limits<T>::digits10 * 3.3219280948873626)
                                            : std::numeric_limits<T>::digits;

/// Largest relative error of one rounding to nearest, u: 2^-53 for double.
template <Real T>
[[nodiscard]] inline T unit_roundoff() {
  if constexpr (std::same_as<T, double>) {
    return 0x1p-53;
  } else {
    using detail::ldexp;
    return T(ldexp(T(1), -significand_bits<T>));
  }
}

}  // namespace carom
