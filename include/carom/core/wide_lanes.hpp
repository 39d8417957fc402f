#pragma once
// Four DoubleDouble at a time: the operations of core/double_double.hpp lane by lane, with the same bits.

#include "carom/core/double_double.hpp"
#include "carom/core/lanes.hpp"

namespace carom {

struct WideLanes {
  Lanes hi = {}, lo = {};

  [[nodiscard]] CAROM_INLINE DoubleDouble operator[](int k) const { return {hi[k], lo[k]}; }
};

CAROM_INLINE WideLanes fast_two_sum(const Lanes& a, const Lanes& b) {
  const Lanes s = a + b;
  return {s, b - (s - a)};
}
CAROM_INLINE WideLanes two_sum(const Lanes& a, const Lanes& b) {
  const Lanes s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}
CAROM_INLINE WideLanes two_diff(const Lanes& a, const Lanes& b) { return two_sum(a, -b); }

CAROM_INLINE WideLanes two_prod(const Lanes& a, const Lanes& b) {
  const Lanes p = a * b;
#if defined(__FMA__)
  return {p, static_cast<Lanes>(_mm256_fmsub_pd(static_cast<__m256d>(a), static_cast<__m256d>(b), static_cast<__m256d>(p)))};
#else
  const auto high = [](const Lanes& x) {
    const Lanes c = 134217729.0 * x;
    return c - (c - x);
  };
  const Lanes ah = high(a), al = a - ah, bh = high(b), bl = b - bh;
  return {p, (al * bl - (((p - ah * bh) - al * bh) - ah * bl)) + 0.0};
#endif
}

CAROM_INLINE WideLanes operator-(const WideLanes& x) { return {-x.hi, -x.lo}; }
CAROM_INLINE WideLanes operator+(const WideLanes& x, const WideLanes& y) {
  const WideLanes s = two_sum(x.hi, y.hi), t = two_sum(x.lo, y.lo), v = fast_two_sum(s.hi, s.lo + t.hi);
  return fast_two_sum(v.hi, t.lo + v.lo);
}
CAROM_INLINE WideLanes operator*(const WideLanes& x, const WideLanes& y) {
  const WideLanes c = two_prod(x.hi, y.hi);
  return fast_two_sum(c.hi, c.lo + (x.hi * y.lo + x.lo * y.hi));
}

CAROM_INLINE WideLanes spread(const DoubleDouble& x) { return {spread(x.hi), spread(x.lo)}; }

/// narrow(DoubleDouble(v) + x): what that sum comes to where one is a double, and only the nearest double is wanted.
CAROM_INLINE Lanes rounded_sum(const Lanes& v, const WideLanes& x) {
  const WideLanes s = two_sum(v, x.hi);
  return s.hi + (s.lo + x.lo);
}

/// (sum of x0 .. x_{D-1}, sum of y0 .. y_{D-1}), each in that order.
template <int D>
CAROM_INLINE WideLanes sums_in_order(const WideLanes& x, const WideLanes& y) {
  const WideLanes even = {__builtin_shufflevector(x.hi, y.hi, 0, 4, 2, 6), __builtin_shufflevector(x.lo, y.lo, 0, 4, 2, 6)};
  const WideLanes odd = {__builtin_shufflevector(x.hi, y.hi, 1, 5, 3, 7), __builtin_shufflevector(x.lo, y.lo, 1, 5, 3, 7)};
  const WideLanes two = even + odd;
  if constexpr (D == 2) return two;
  return two + WideLanes{__builtin_shufflevector(even.hi, even.hi, 2, 3, 0, 1), __builtin_shufflevector(even.lo, even.lo, 2, 3, 0, 1)};
}

}  // namespace carom
