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
concept Real = std::copyable<T> && !std::numeric_limits<T>::is_integer && std::numeric_limits<T>::has_infinity &&
               std::constructible_from<T, double> &&
               detail::HasElementaryFunctions<T> && requires(const T x) {
                 T(-x);
                 T(x + x);
                 T(x - x);
                 T(x * x);
                 T(x / x);
                 bool(x < x);
                 bool(x == x);
               };

/// +infinity, in the precision that holds here.
template <Real T>
[[nodiscard]] constexpr T infinity() {
  return T(std::numeric_limits<double>::infinity());
}

/// The time of an event that does not happen: +infinity. Ordered after every time.
template <Real T>
[[nodiscard]] constexpr T never() {
  return infinity<T>();
}

/// Bits of the significand: at most as many as the number has, for one whose precision is set in decimal digits.
template <Real T>
[[nodiscard]] inline int significand_bits() {
  constexpr bool is_variable = std::numeric_limits<T>::digits == std::numeric_limits<int>::max();
  if constexpr (is_variable) {
    return static_cast<int>(T::default_precision() * 1000L / 302);  // log2(10) = 3.3219 > 1000 / 302
  } else if constexpr (std::numeric_limits<T>::radix == 10) {
    return static_cast<int>(std::numeric_limits<T>::digits10 * 1000L / 302);
  } else {
    return std::numeric_limits<T>::digits;
  }
}

/// Largest relative error of one rounding to nearest, u: 2^-53 for double.
template <Real T>
[[nodiscard]] inline T unit_roundoff() {
  if constexpr (std::same_as<T, double>) {
    return 0x1p-53;
  } else {
    using detail::ldexp;
    return T(ldexp(T(1), -significand_bits<T>()));
  }
}

}  // namespace carom
