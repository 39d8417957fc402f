#pragma once
// Contact times without relative acceleration: two convex bodies, and a ball inside a circle or sphere.
//
//   |r + v t|^2 - sigma^2 = a t^2 + 2 b t + c,  a = v.v,  b = r.v,  c = r.r - sigma^2  [papers/contact_times.md, eq. 3]
//   d = b^2 - a c = a sigma^2 - |r x v|^2                                              [eq. 5]
//
// For double a filter settles nearly every call in plain arithmetic; what it does not settle goes to pair_terms, where
// signs are exact. So whether two bodies meet is the exact answer for the r, v and sigma given. Inputs are finite;
// components and sigma that are not 0 lie within 2^-450 .. 2^450, where |r| >= 1 those of v within 2^-850 .. 2^450.

#include "carom/core/vec.hpp"
#include "carom/solve/gap.hpp"
#include "carom/solve/pair_terms.hpp"

namespace carom {

/// Bound of the relative error of `meet_time` and `leave_time` for double, in units of u = 2^-53 [eq. 10, 11].
inline constexpr double meet_time_error = 1500.0;
inline constexpr double leave_time_error = 800.0;

namespace detail {

// meet_time takes c as it comes only above this share of sigma^2, and d only where sqrt(d) (sqrt(d) - b) is above this share
// of a r.r: their errors, some u of r.r and of a r.r, then stay below meet_time_error [eq. 10].
inline constexpr double near_meeting = 0x1p-8;
inline constexpr double near_double_root = 0x1p-6;

// leave_time and growing_meet_time: the same with shares of sigma^2 and of a sigma^2 [eq. 11, 21].
inline constexpr double near_contact = 0x1p-7;
inline constexpr double near_grazing = 0x1p-5;

// |computed d - d| <= no_root a r.r where r.r >= sigma^2 [eq. 7].
inline constexpr double no_root = 16 * 0x1p-53;

// Above it no product has lost anything to underflow that matters beside rounding.
inline constexpr double no_underflow = 0x1p-960;

// With c > (apart - 1) sigma^2 and a computed b >= 0, exactly nothing is approaching that could meet [eq. 8].
inline constexpr double apart = 1 + 0x1p-48;

/// The meeting at c / q, q = sqrt(d) - b, is known well enough from plain d [eq. 10]. `scale` = a r.r; a real or one in
/// each lane.
template <class Real>
[[nodiscard, gnu::always_inline]] inline auto far_from_grazing(const Real& root, const Real& q, const Real& scale) {
  return root * q > near_double_root * scale + no_underflow;
}

/// When two meet that are apart or coming nearer, if plain arithmetic settles that. `scale` = a r.r.
[[nodiscard, gnu::always_inline]] inline bool meet_plainly(double b, double c, double ss, double d, double scale,
                                                           double& t) {
  if (!(c > near_meeting * ss)) return false;
  if (-d > no_root * scale + no_underflow) {
    t = never<double>();
    return true;
  }
  if (!(d > 0.0)) return false;
  const double root = __builtin_sqrt(d), q = root - b;
  if (!far_from_grazing(root, q, scale)) return false;
  t = c / q;
  return true;
}

/// The terms of `pair_terms` need no scaling if the largest components of r and v lie within 2^-100 .. 2^100.
template <int D>
[[nodiscard]] inline bool moderate(const Vec<double, D>& r, const Vec<double, D>& v, double sigma) {
  const auto largest = [](const Vec<double, D>& x) {
    double m = std::fabs(x[0]);
    for (int k = 1; k < D; ++k) m = std::fabs(x[k]) > m ? std::fabs(x[k]) : m;
    return m;
  };
  const double length = largest(r) > sigma ? largest(r) : sigma, speed = largest(v);
  return length > 0x1p-100 && length < 0x1p100 && speed > 0x1p-100 && speed < 0x1p100;
}

/// What plain arithmetic has not settled, in twice the precision. False if that is not enough; else t is the meeting time.
template <int D>
[[nodiscard]] inline bool meet_time_wide(const Vec<double, D>& r, const Vec<double, D>& v, double sigma, double& t) {
  const double plain_ss = sigma * sigma;
  const double plain_a = dot<double, D>(v, v);
  const double plain_d = plain_a * plain_ss - cross_squared<double, D>(r, v);
  const DoubleDouble ss = two_prod(sigma, sigma), xx = wide_dot<double, D>(r, r), c = xx - ss;
  if (plain_d > 0.0 && c.hi > 0x1p-42 * plain_ss && c.hi < plain_ss) {
    const double root = std::sqrt(plain_d), q = root - dot<double, D>(r, v);
    if (far_from_grazing(root, q, plain_a * dot<double, D>(r, r))) {
      t = c.hi / q;
      return true;
    }
  }
  if (!moderate<D>(r, v, sigma)) return false;
  // As pair_terms, whose powers of two change no bit here.
  const DoubleDouble a = wide_dot<double, D>(v, v), b = wide_dot<double, D>(r, v);
  const DoubleDouble d = a * ss - wide_cross_squared<D>(r, v);
  const double size = xx.hi > ss.hi ? xx.hi : ss.hi;
  const bool certain = std::fabs(b.hi) > settled * std::sqrt(a.hi * size) && std::fabs(c.hi) > settled * size &&
                       std::fabs(d.hi) > settled * a.hi * size;
  if (!certain) return false;
  t = !(b.hi < 0.0) ? never<double>() : !(c.hi > 0.0) ? 0.0 : d.hi > 0.0 ? c.hi / (-b.hi + std::sqrt(d.hi)) : never<double>();
  return true;
}

template <int D>
[[nodiscard, gnu::noinline]] double meet_time_close(const Vec<double, D>& r, const Vec<double, D>& v, double sigma) {
  double t;
  if (meet_time_wide<D>(r, v, sigma, t)) return t;
  const PairTerms terms = pair_terms<D>(r, v, sigma);
  if (!(terms.b.mantissa < 0.0)) return never<double>();
  if (!(terms.c.mantissa > 0.0)) return 0.0;
  return terms.d.mantissa > 0.0 ? smaller_root(terms) : never<double>();
}

template <int D>
[[nodiscard, gnu::noinline]] double leave_time_close(const Vec<double, D>& r, const Vec<double, D>& v, double rho) {
  const PairTerms terms = pair_terms<D>(r, v, rho);
  if (terms.a.mantissa == 0.0) return never<double>();
  const bool outside = !(terms.c.mantissa < 0.0);
  if (outside && !(terms.b.mantissa < 0.0)) return 0.0;
  return terms.d.mantissa > 0.0 ? larger_root(terms) : closest_time(terms);
}

}  // namespace detail

/// First t >= 0 at which |r + v t| falls to sigma: t = c / (-b + sqrt(d)), or `never`. Two balls: r and v of one relative
/// to the other, sigma the sum of the radii. Overlapping: 0 if approaching, else `never`. Grazing (d = 0) is no meeting.
/// For double the decision is exact and the relative error of t at most meet_time_error u.
template <Real T, int D>
[[nodiscard]] inline T meet_time(const Vec<T, D>& r, const Vec<T, D>& v, const T& sigma) {
  static_assert(D >= 2, "on a line use gap_time");
  using std::sqrt;
  const T b = dot<T, D>(r, v);
  const T rr = dot<T, D>(r, r);
  const T ss = sigma * sigma;
  if constexpr (std::is_same_v<T, double>) {
    if (b >= 0.0 && rr > detail::apart * ss) return never<T>();
    const double c = rr - ss;
    const double a = dot<T, D>(v, v);
    const double d = a * ss - cross_squared<T, D>(r, v);
    double t;
    return detail::meet_plainly(b, c, ss, d, a * rr, t) ? t : detail::meet_time_close<D>(r, v, sigma);
  } else {
    if (!(b < 0)) return never<T>();
    const T c = rr - ss;
    if (!(c > 0)) return T(0);
    const T a = dot<T, D>(v, v);
    const T d = a * ss - cross_squared<T, D>(r, v);
    return d > 0 ? T(c / (sqrt(d) - b)) : never<T>();
  }
}

/// A ball inside a circle or sphere (rho: the radius less that of the ball): first t >= 0 at which rho^2 - |r + v t|^2 is
/// <= 0 and falling. Outside and inward bound: where it leaves again, or the turning point -b / a if it never gets inside.
/// For double the decision is exact and the relative error of t at most leave_time_error u.
template <Real T, int D>
[[nodiscard]] inline T leave_time(const Vec<T, D>& r, const Vec<T, D>& v, const T& rho) {
  static_assert(D >= 2, "on a line use gap_time");
  using std::sqrt;
  const T a = dot<T, D>(v, v);
  const T b = dot<T, D>(r, v);
  const T ss = rho * rho;
  const T depth = ss - dot<T, D>(r, r);
  const T d = a * ss - cross_squared<T, D>(r, v);
  if constexpr (std::is_same_v<T, double>) {
    if (d > detail::near_grazing * (a * ss) + detail::no_underflow) {
      if (b < 0.0 && depth > -ss) return (sqrt(d) - b) / a;
      if (!(b < 0.0) && depth > detail::near_contact * ss) return depth / (b + sqrt(d));
    }
    return detail::leave_time_close<D>(r, v, rho);
  } else {
    if (a == 0) return never<T>();
    if (!(depth > 0) && !(b < 0)) return T(0);
    if (!(d > 0)) return T(-b / a);
    return b > 0 ? T(depth / (b + sqrt(d))) : T((sqrt(d) - b) / a);
  }
}

/// Bound of the relative error of `chord_time` for double, in units of u = 2^-53 [papers/contact_times.md, eq. 6].
inline constexpr double chord_time_error = 6.0;

/// From wall to wall inside a circle or sphere about the origin: |r| = rho by state, so the root 0 is dropped and the
/// other is -2 b / a. The contact has just been resolved: r.v > 0 is rounding and counts as 0, which returns 0 (pressed
/// to the wall).
template <Real T, int D>
[[nodiscard]] inline T chord_time(const Vec<T, D>& r, const Vec<T, D>& v) {
  const T a = dot<T, D>(v, v);
  if (a == 0) return never<T>();
  const T b = narrow(wide_dot<T, D>(r, v));
  return b < 0 ? T(-2 * b / a) : T(0);
}

}  // namespace carom
