#pragma once
// The value of a polynomial of degree <= 4 with an error bound, at any power of two that its argument lives at.

#include <array>
#include <bit>
#include <cstdint>

#include "carom/core/double_double.hpp"
#include "carom/core/real.hpp"

namespace carom {

/// c[0] + c[1] t + ... + c[degree] t^degree; c[degree] != 0 unless the polynomial is 0 (degree 0).
/// The coefficients are wide, so that those of derivatives are exact.
template <Real T>
struct Polynomial {
  static constexpr int max_degree = 4;
  std::array<Wide<T>, max_degree + 1> c{};
  int degree = 0;
};

/// |value - p(s)| <= bound.
template <Real T>
struct Enclosed {
  T value;
  T bound;

  /// +1, -1, or 0: cannot be told from zero.
  [[nodiscard]] int sign() const { return value > bound ? 1 : value < -bound ? -1 : 0; }
};

namespace detail {

/// x 2^n, the exponent out of the double range allowed.
template <Real T>
[[nodiscard]] inline T times_power_of_two(const T& x, long n) {
  if constexpr (std::is_same_v<T, double>) {
    if (n >= -1022 && n <= 1023) return x * std::bit_cast<double>(std::uint64_t(1023 + n) << 52);
    return std::ldexp(x, int(n < -5000 ? -5000 : n > 5000 ? 5000 : n));
  } else {
    return T(ldexp(x, int(n)));
  }
}
[[nodiscard]] inline DoubleDouble times_power_of_two(const DoubleDouble& x, long n) {
  return {times_power_of_two(x.hi, n), times_power_of_two(x.lo, n)};
}

/// e with 2^(e-1) <= |x| < 2^e; x != 0.
template <Real T>
[[nodiscard]] inline long exponent_of(const T& x) {
  int e = 0;
  (void)T(frexp(x, &e));
  return e;
}

/// Bound of the error of `enclose` as a multiple of sum |c_i s^i|: (2 n u)^2 for the compensated scheme in degree n = 4
/// [Graillat2005], 2 n u for the plain one, both doubled.
template <Real T>
[[nodiscard]] inline T horner_error() {
  const T u = unit_roundoff<T>();
  if constexpr (std::is_same_v<T, double>) {
    return 128 * u * u;
  } else {
    return T(16 * u);
  }
}

}  // namespace detail

/// The same polynomial in s = t 2^-k, times a power of two that makes its largest term at s = 1 about 1. What is 2^-1000
/// times smaller than that may vanish; it is below the error bound.
template <Real T>
class Window {
 public:
  Window(const Polynomial<T>& p, long k) : degree_(p.degree) {
    long top = 0;
    bool found = false;
    std::array<long, Polynomial<T>::max_degree + 1> e{};
    for (int i = 0; i <= degree_; ++i) {
      const T c = narrow(p.c[i]);
      if (c == 0) continue;
      e[i] = detail::exponent_of(c) + i * k;
      if (!found || e[i] > top) top = e[i];
      found = true;
    }
    for (int i = 0; i <= degree_; ++i) {
      c_[i] = detail::times_power_of_two(p.c[i], i * k - top);
      high_[i] = narrow(c_[i]);
    }
  }

  /// p(s), s > 0 and not far from 1. For double by Horner's scheme with its rounding errors carried along: as if evaluated
  /// in twice the precision, then rounded [Graillat2005].
  [[nodiscard]] Enclosed<T> enclose(const T& s) const {
    using std::abs;
    T value = high_[degree_];
    T size = abs(value);
    T lost(0);
    if constexpr (std::is_same_v<T, double>) lost = c_[degree_].lo;
    for (int i = degree_ - 1; i >= 0; --i) {
      if constexpr (std::is_same_v<T, double>) {
        const DoubleDouble product = two_prod(value, s);
        const DoubleDouble sum = two_sum(product.hi, high_[i]);
        lost = lost * s + (product.lo + sum.lo + c_[i].lo);
        value = sum.hi;
      } else {
        value = value * s + high_[i];
      }
      size = size * s + abs(high_[i]);
    }
    return {T(value + lost), T(detail::horner_error<T>() * size)};
  }

  /// dp/ds in plain arithmetic: for Newton's step.
  [[nodiscard]] T slope(const T& s) const {
    T value = degree_ * high_[degree_];
    for (int i = degree_ - 1; i >= 1; --i) value = value * s + i * high_[i];
    return value;
  }

 private:
  std::array<Wide<T>, Polynomial<T>::max_degree + 1> c_{};
  std::array<T, Polynomial<T>::max_degree + 1> high_{};
  int degree_;
};

/// p(t), t > 0, up to a power of two.
template <Real T>
[[nodiscard]] inline Enclosed<T> enclose(const Polynomial<T>& p, const T& t) {
  const long k = detail::exponent_of(t);
  return Window<T>(p, k).enclose(detail::times_power_of_two(t, -k));
}

}  // namespace carom
