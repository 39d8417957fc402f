#pragma once
// Intervals of doubles whose ends are rounded outwards: they hold the exact result, whatever was rounded on the way.

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::certify {

/// The next double below and above x. A result of + - * that was rounded to nearest lies within half an ulp of the exact
/// one, so its neighbours enclose that (underflow included: the spacing there is that of the subnormals).
[[nodiscard]] inline double below(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }
[[nodiscard]] inline double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

/// All reals from `lower` to `upper`. What has no value (inf - inf, 0 inf) becomes the whole line.
struct Outward {
  double lower = 0.0, upper = 0.0;

  Outward() = default;
  Outward(double x) : lower(x), upper(x) {}  // NOLINT(google-explicit-constructor): a double is one, exactly
  Outward(double from, double to) : lower(from), upper(to) {}

  [[nodiscard]] static Outward line() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  /// The interval one double wider at each end.
  [[nodiscard]] static Outward rounded(double from, double to) {
    return from <= to ? Outward{below(from), above(to)} : line();
  }
};

[[nodiscard]] inline bool is_positive(const Outward& x) { return x.lower > 0; }
[[nodiscard]] inline bool is_negative(const Outward& x) { return x.upper < 0; }

[[nodiscard]] inline Outward operator-(const Outward& x) { return {-x.upper, -x.lower}; }
[[nodiscard]] inline Outward operator+(const Outward& x, const Outward& y) {
  return Outward::rounded(x.lower + y.lower, x.upper + y.upper);
}
[[nodiscard]] inline Outward operator-(const Outward& x, const Outward& y) {
  return Outward::rounded(x.lower - y.upper, x.upper - y.lower);
}
[[nodiscard]] inline Outward operator*(const Outward& x, const Outward& y) {
  const double a = x.lower * y.lower, b = x.lower * y.upper, c = x.upper * y.lower, d = x.upper * y.upper;
  if (std::isnan(a + b) || std::isnan(c + d)) return Outward::line();
  return Outward::rounded(std::min({a, b, c, d}), std::max({a, b, c, d}));
}

[[nodiscard]] inline Outward square(const Outward& x) {
  if (x.lower >= 0) return x * x;
  if (x.upper <= 0) return (-x) * (-x);
  const double most = std::max(-x.lower, x.upper);
  return {0.0, above(most * most)};
}
[[nodiscard]] inline Outward half(const Outward& x) { return x * Outward(0.5); }

/// p / q for whole numbers, q > 0.
template <class I>
[[nodiscard]] I ratio(int p, int q);
template <>
[[nodiscard]] inline Outward ratio<Outward>(int p, int q) {
  const double x = static_cast<double>(p) / q;
  return p % q == 0 ? Outward(x) : Outward::rounded(x, x);
}

}  // namespace carom::certify
