#pragma once
// The coefficients of |r + v t|^2 = sigma^2 with certain signs: what the fast forms in quadratic.hpp fall back on.

#include "carom/core/vec.hpp"

namespace carom {

/// value = mantissa 2^exponent; mantissa 0 or of size 1/4..4 or so. No overflow, no underflow.
struct Scaled {
  double mantissa = 0.0;
  long exponent = 0;
};

namespace detail {

/// |r x v|^2.
template <int D>
[[nodiscard]] inline DoubleDouble wide_cross_squared(const Vec<double, D>& r, const Vec<double, D>& v) {
  const auto minor = [&](int i, int j) { return two_prod(r[i], v[j]) - two_prod(r[j], v[i]); };
  const DoubleDouble z = minor(0, 1);
  if constexpr (D == 2) {
    return z * z;
  } else {
    const DoubleDouble x = minor(1, 2);
    const DoubleDouble y = minor(2, 0);
    return x * x + y * y + z * z;
  }
}

/// The double-double values are within 2^-96 of the sizes that they are differences of [papers/contact_times.md, eq. 9].
/// Kept if that is at most 2^-54 of the value.
inline constexpr double settled = 0x1p-42;

}  // namespace detail

/// a = v.v, b = r.v, c = r.r - sigma^2, d = b^2 - a c = a sigma^2 - |r x v|^2 [papers/contact_times.md, eq. 3-5].
/// The signs are exact and each value has a relative error of at most 2 u.
struct PairTerms {
  Scaled a, b, c, d;
};

/// By exact integer arithmetic: any finite input. Some microseconds.
[[nodiscard]] PairTerms exact_pair_terms(const double* r, const double* v, double sigma, int dimension);

/// By double-double arithmetic where that settles it, else exactly.
template <int D>
[[nodiscard]] PairTerms pair_terms(const Vec<double, D>& r, const Vec<double, D>& v, double sigma);

/// c / (-b + sqrt(d)), for c, d >= 0, b < 0.
[[nodiscard]] double smaller_root(const PairTerms& terms);

/// The larger root of a t^2 + 2 b t + c, in the form that does not cancel; d >= 0.
[[nodiscard]] double larger_root(const PairTerms& terms);

/// -b / a, where |r + v t| is smallest.
[[nodiscard]] double closest_time(const PairTerms& terms);

extern template PairTerms pair_terms<2>(const Vec<double, 2>&, const Vec<double, 2>&, double);
extern template PairTerms pair_terms<3>(const Vec<double, 3>&, const Vec<double, 3>&, double);

}  // namespace carom
