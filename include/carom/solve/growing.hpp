#pragma once
// Contact times of bodies that grow in free flight: |r + v t| = sigma + G t.
//
//   |r + v t|^2 - (sigma + G t)^2 = a t^2 + 2 b t + c                        [papers/contact_times.md, eq. 18]
//   a = v.v - G^2,  b = r.v - sigma G,  c = r.r - sigma^2
//   d = b^2 - a c = |sigma v - G r|^2 - |r x v|^2                            [eq. 19]
//
// a may be 0 or negative: then a pair meets even if it recedes. Ranges of the inputs as in quadratic.hpp.

#include "carom/solve/polynomial.hpp"
#include "carom/solve/quadratic.hpp"

namespace carom {

/// Bound of the relative error of `growing_meet_time` for double, in units of u = 2^-53 [papers/contact_times.md, eq. 21].
inline constexpr double growing_time_error = 1200.0;

namespace detail {

// What is left of v.v - G^2 beside its terms, so that the sign is certain, and so that a quotient by it is good.
inline constexpr double certain_rate = 0x1p-40;
inline constexpr double good_rate = 0x1p-5;

/// First t >= 0 at which a t^2 + 2 b t + c is <= 0 and falling, or `never`; d = b^2 - a c. No form cancels.
template <class T>
[[nodiscard]] inline T fall_of_quadratic(const T& a, const T& b, const T& c, const T& d) {
  using std::sqrt;
  if (c > 0) {
    if (b < 0) return d > 0 ? T(c / (sqrt(d) - b)) : never<T>();
    return a < 0 ? T((b + sqrt(d)) / -a) : never<T>();
  }
  if (b < 0 || (b == 0 && a < 0)) return T(0);
  if (!(a < 0)) return never<T>();
  return d > 0 ? T((b + sqrt(d)) / -a) : T(b / -a);
}

/// a, b, c and d in twice the precision.
template <Real T, int D>
struct GrowingTerms {
  Wide<T> a, b, c, d;

  GrowingTerms(const Vec<T, D>& r, const Vec<T, D>& v, const T& sigma, const T& growth)
      : a(wide_dot<T, D>(v, v) - wide_product<T>(growth, growth)),
        b(wide_dot<T, D>(r, v) - wide_product<T>(sigma, growth)),
        c(wide_dot<T, D>(r, r) - wide_product<T>(sigma, sigma)),
        d(T(0)) {
    for (int k = 0; k < D; ++k) {
      const Wide<T> along = wide_product<T>(sigma, v[k]) - wide_product<T>(growth, r[k]);
      d = d + along * along;
      for (int m = k + 1; m < D; ++m) {
        const Wide<T> minor = wide_product<T>(r[k], v[m]) - wide_product<T>(r[m], v[k]);
        d = d - minor * minor;
      }
    }
  }
};

/// What plain arithmetic has not settled.
template <int D>
[[nodiscard, gnu::noinline]] double growing_meet_time_close(const Vec<double, D>& r, const Vec<double, D>& v, double sigma,
                                                            double growth) {
  const GrowingTerms<double, D> t(r, v, sigma, growth);
  const double vv = dot<double, D>(v, v), rr = dot<double, D>(r, r), gg = growth * growth, ss = sigma * sigma;
  const double length = rr > ss ? rr : ss, rate = vv + gg;
  const bool certain = moderate<D>(r, v, sigma) && growth < 0x1p100 && std::fabs(t.a.hi) > settled * rate &&
                       std::fabs(t.b.hi) > settled * std::sqrt(rate * length) && std::fabs(t.c.hi) > settled * length &&
                       std::fabs(t.d.hi) > settled * rate * length;
  if (certain) return fall_of_quadratic(t.a.hi, t.b.hi, t.c.hi, t.d.hi);
  return first_fall(std::array{t.c, t.b * 2.0, t.a});
}

}  // namespace detail

/// First t >= 0 at which |r + v t| - (sigma + growth t) is <= 0 and falling, or `never`; growth >= 0. Two balls: r and v of
/// one relative to the other, sigma the sum of the radii, growth that of their rates. For double the decision is that of
/// the exact numbers wherever they are 2^-100 of their terms away from another, and the relative error of t at most
/// growing_time_error u.
template <Real T, int D>
[[nodiscard]] inline T growing_meet_time(const Vec<T, D>& r, const Vec<T, D>& v, const T& sigma, const T& growth) {
  static_assert(D >= 2, "on a line use gap_time");
  using std::sqrt;
  if constexpr (std::is_same_v<T, double>) {
    const double vv = dot<T, D>(v, v), rr = dot<T, D>(r, r), ss = sigma * sigma, gg = growth * growth;
    const double a = vv - gg, b = dot<T, D>(r, v) - sigma * growth, rate = vv + gg;
    if (b >= 0.0 && rr > detail::apart * ss && a > detail::certain_rate * rate) return never<T>();
    const double c = rr - ss;
    double along = 0.0;
    for (int k = 0; k < D; ++k) {
      const double x = sigma * v[k] - growth * r[k];
      along += x * x;
    }
    const double d = along - cross_squared<T, D>(r, v);
    const bool far = c > detail::near_contact * ss;
    if (far && -d > 4 * detail::no_root * (rate * rr) + detail::no_underflow) return never<T>();
    if (d > detail::near_grazing * (vv * ss + gg * rr) + detail::no_underflow && (b < 0.0 || -a > detail::good_rate * rate)) {
      double excess = c;
      if (!far) {
        const DoubleDouble wide = wide_dot<double, D>(r, r) - two_prod(sigma, sigma);
        excess = wide.hi > 0x1p-42 * ss ? wide.hi : 0.0;
      }
      if (excess > 0.0) return b < 0.0 ? excess / (sqrt(d) - b) : (b + sqrt(d)) / -a;
    }
    return detail::growing_meet_time_close<D>(r, v, sigma, growth);
  } else {
    const detail::GrowingTerms<T, D> t(r, v, sigma, growth);
    return detail::fall_of_quadratic<T>(t.a, t.b, t.c, t.d);
  }
}

/// A ball that grows inside a circle or sphere (rho: its radius less that of the ball, now; growth > 0): first t >= 0 at which
/// (rho - growth t) - |r + v t| is <= 0 and falling, or `never` [papers/contact_times.md, eq. 22]: at the latest when it fills
/// the circle. Relative error of t: that of `first_fall` of a polynomial.
template <Real T, int D>
[[nodiscard]] inline T growing_leave_time(const Vec<T, D>& r, const Vec<T, D>& v, const T& rho, const T& growth) {
  const detail::GrowingTerms<T, D> t(r, v, rho, T(-growth));
  const T leaves = first_fall(std::array{Wide<T>(-t.c), Wide<T>(t.b * T(-2)), Wide<T>(-t.a)});
  const T fills = rho > 0 ? T(rho / growth) : T(0);
  return leaves < fills ? leaves : fills;
}

/// From wall to wall inside a circle or sphere, after a contact that has just been resolved: |r| = rho by state.
template <Real T, int D>
[[nodiscard]] inline T growing_chord_time(const Vec<T, D>& r, const Vec<T, D>& v, const T& rho, const T& growth) {
  const detail::GrowingTerms<T, D> t(r, v, rho, T(-growth));
  return next_fall(std::array{Wide<T>(t.b * T(-2)), Wide<T>(-t.a)});
}

}  // namespace carom
