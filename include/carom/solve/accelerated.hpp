#pragma once
// Contact times of two bodies under different accelerations: the first root of a quartic.

#include "carom/core/vec.hpp"
#include "carom/solve/polynomial.hpp"

namespace carom {

/// |r + v t + a t^2 / 2|^2 - sigma^2 by powers of t [papers/contact_times.md, eq. 17]. For double each coefficient is off
/// by at most 32 u^2 of the sum of the sizes of its terms.
template <Real T, int D>
[[nodiscard]] inline std::array<Wide<T>, 5> pair_polynomial(const Vec<T, D>& r, const Vec<T, D>& v, const Vec<T, D>& a,
                                                            const T& sigma) {
  return {Wide<T>(wide_dot<T, D>(r, r) - wide_product<T>(sigma, sigma)), Wide<T>(wide_dot<T, D>(r, v) * T(2)),
          Wide<T>(wide_dot<T, D>(v, v) + wide_dot<T, D>(r, a)), wide_dot<T, D>(v, a),
          Wide<T>(wide_dot<T, D>(a, a) * (T(1) / 4))};
}

/// First t >= 0 at which |r + v t + a t^2 / 2| - sigma is <= 0 and falling, or `never`.
template <Real T, int D>
[[nodiscard]] inline T meet_time(const Vec<T, D>& r, const Vec<T, D>& v, const Vec<T, D>& a, const T& sigma) {
  return first_fall(pair_polynomial<T, D>(r, v, a, sigma));
}

/// The next meeting of two bodies in a contact that has just been resolved: |r| = sigma by state.
template <Real T, int D>
[[nodiscard]] inline T next_meet_time(const Vec<T, D>& r, const Vec<T, D>& v, const Vec<T, D>& a) {
  const auto c = pair_polynomial<T, D>(r, v, a, T(0));
  return next_fall(std::array{c[1], c[2], c[3], c[4]});
}

/// A ball inside a circle or sphere: first t >= 0 at which rho - |r + v t + a t^2 / 2| is <= 0 and falling, or `never`.
template <Real T, int D>
[[nodiscard]] inline T leave_time(const Vec<T, D>& r, const Vec<T, D>& v, const Vec<T, D>& a, const T& rho) {
  auto c = pair_polynomial<T, D>(r, v, a, rho);
  for (auto& x : c) x = -x;
  return first_fall(c);
}

/// From wall to wall inside a circle or sphere, after a contact that has just been resolved: |r| = rho by state.
template <Real T, int D>
[[nodiscard]] inline T chord_time(const Vec<T, D>& r, const Vec<T, D>& v, const Vec<T, D>& a) {
  const auto c = pair_polynomial<T, D>(r, v, a, T(0));
  return next_fall(std::array{Wide<T>(-c[1]), Wide<T>(-c[2]), Wide<T>(-c[3]), Wide<T>(-c[4])});
}

}  // namespace carom
