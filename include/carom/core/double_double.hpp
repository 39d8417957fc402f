#pragma once
// Error-free sums and products of doubles, and the unevaluated sum of two doubles built from them.
//
// Everything here is round-to-nearest arithmetic without contraction; u = 2^-53. Error bounds hold barring overflow and
// underflow (products below 2^-968 lose their low part) and are those of [Joldes2017], sharpened by [Muller2022] where
// named.

#include <cmath>
#include <compare>
#include <type_traits>

#include "carom/core/real.hpp"

namespace carom {

/// hi + lo, not evaluated. Normalised: hi is the double nearest to hi + lo, so |lo| <= u |hi|.
struct DoubleDouble {
  double hi = 0.0;
  double lo = 0.0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double x) : hi(x) {}  // NOLINT(google-explicit-constructor): a double is one, exactly
  /// Requires a normalised pair.
  constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}

  /// The double nearest to the value.
  [[nodiscard]] explicit constexpr operator double() const { return hi; }

  // Of normalised pairs the order of the values is the lexicographic one.
  friend constexpr bool operator==(const DoubleDouble&, const DoubleDouble&) = default;
  friend constexpr auto operator<=>(const DoubleDouble&, const DoubleDouble&) = default;
};

/// a + b exactly, |a| >= |b| or a = 0. [Dekker1971]
[[nodiscard]] constexpr DoubleDouble fast_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// a + b exactly. [Knuth1997, section 4.2.2]
[[nodiscard]] constexpr DoubleDouble two_sum(double a, double b) {
  const double s = a + b;
  const double t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// a - b exactly.
[[nodiscard]] constexpr DoubleDouble two_diff(double a, double b) { return two_sum(a, -b); }

namespace detail {
/// x = hi + lo, 26 bits each. |x| < 2^996. [Dekker1971, after Veltkamp]
[[nodiscard]] constexpr DoubleDouble split(double x) {
  const double c = 134217729.0 * x;  // 2^27 + 1
  const double hi = c - (c - x);
  return {hi, x - hi};
}

/// a b exactly, without a fused operation. [Dekker1971]
[[nodiscard]] constexpr DoubleDouble two_prod_dekker(double a, double b) {
  const double p = a * b;
  const DoubleDouble x = split(a);
  const DoubleDouble y = split(b);
  const double e = x.lo * y.lo - (((p - x.hi * y.hi) - x.lo * y.hi) - x.hi * y.lo);
  return {p, e + 0.0};  // + 0.0: a zero comes out positive, as from fma
}
}  // namespace detail

/// a b exactly. The same bits with and without a fused operation, where the split does not overflow.
[[nodiscard]] constexpr DoubleDouble two_prod(double a, double b) {
#ifdef __FMA__
  if (!std::is_constant_evaluated()) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
  }
#endif
  return detail::two_prod_dekker(a, b);
}

[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& x) { return {-x.hi, -x.lo}; }

/// Relative error <= 2 u^2. [Joldes2017, algorithm 4]
[[nodiscard]] constexpr DoubleDouble operator+(const DoubleDouble& x, double y) {
  const DoubleDouble s = two_sum(x.hi, y);
  return fast_two_sum(s.hi, x.lo + s.lo);
}
[[nodiscard]] constexpr DoubleDouble operator+(double x, const DoubleDouble& y) { return y + x; }
[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& x, double y) { return x + (-y); }
[[nodiscard]] constexpr DoubleDouble operator-(double x, const DoubleDouble& y) { return (-y) + x; }

/// Relative error <= 3 u^2 / (1 - 4 u), whatever the signs. [Joldes2017, algorithm 6]
[[nodiscard]] constexpr DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble s = two_sum(x.hi, y.hi);
  const DoubleDouble t = two_sum(x.lo, y.lo);
  const DoubleDouble v = fast_two_sum(s.hi, s.lo + t.hi);
  return fast_two_sum(v.hi, t.lo + v.lo);
}
[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + (-y); }

/// Relative error <= 3/2 u^2 + 4 u^3. [Joldes2017, algorithm 7]
[[nodiscard]] constexpr DoubleDouble operator*(const DoubleDouble& x, double y) {
  const DoubleDouble c = two_prod(x.hi, y);
  const DoubleDouble t = fast_two_sum(c.hi, x.lo * y);
  return fast_two_sum(t.hi, t.lo + c.lo);
}
[[nodiscard]] constexpr DoubleDouble operator*(double x, const DoubleDouble& y) { return y * x; }

/// Relative error <= 5 u^2. [Joldes2017, algorithm 10; bound: Muller2022]
[[nodiscard]] constexpr DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble c = two_prod(x.hi, y.hi);
  return fast_two_sum(c.hi, c.lo + (x.hi * y.lo + x.lo * y.hi));
}

/// Relative error <= 3 u^2. [Joldes2017, algorithm 15]
[[nodiscard]] constexpr DoubleDouble operator/(const DoubleDouble& x, double y) {
  const double q = x.hi / y;
  const DoubleDouble p = two_prod(q, y);
  return fast_two_sum(q, (((x.hi - p.hi) - p.lo) + x.lo) / y);
}

/// Relative error <= 15 u^2 + 56 u^3. [Joldes2017, algorithm 17]
[[nodiscard]] constexpr DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
  const double q = x.hi / y.hi;
  const DoubleDouble p = y * q;
  return fast_two_sum(q, ((x.hi - p.hi) + (x.lo - p.lo)) / y.hi);
}
[[nodiscard]] constexpr DoubleDouble operator/(double x, const DoubleDouble& y) { return DoubleDouble(x) / y; }

/// Relative error <= 25/8 u^2; x >= 0. [Lefevre2023, SQRTDWtoDW]
[[nodiscard]] inline DoubleDouble sqrt(const DoubleDouble& x) {
  if (!(x.hi > 0.0)) return DoubleDouble(std::sqrt(x.hi));
  const double s = std::sqrt(x.hi);
  const DoubleDouble p = two_prod(s, s);
  return fast_two_sum(s, (((x.hi - p.hi) - p.lo) + x.lo) / (2.0 * s));
}

[[nodiscard]] constexpr DoubleDouble abs(const DoubleDouble& x) { return x.hi < 0.0 ? -x : x; }

/// The type that impulses are evaluated in: about twice the precision of double; any other real type as it is.
template <Real T>
struct wide {
  using type = T;
};
template <>
struct wide<double> {
  using type = DoubleDouble;
};
template <Real T>
using Wide = typename wide<T>::type;

/// a b, a + b and a - b of two reals as a wide one: exact for double, rounded once for any other type.
template <Real T>
[[nodiscard]] constexpr Wide<T> wide_product(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, double>) {
    return two_prod(a, b);
  } else {
    return T(a * b);
  }
}
template <Real T>
[[nodiscard]] constexpr Wide<T> wide_sum(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, double>) {
    return two_sum(a, b);
  } else {
    return T(a + b);
  }
}
template <Real T>
[[nodiscard]] constexpr Wide<T> wide_difference(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, double>) {
    return two_diff(a, b);
  } else {
    return T(a - b);
  }
}

/// The real nearest to a wide one: the single rounding at the end of a wide evaluation.
[[nodiscard]] constexpr double narrow(const DoubleDouble& x) { return x.hi; }
template <Real T>
[[nodiscard]] constexpr T narrow(const T& x) {
  return x;
}

}  // namespace carom
