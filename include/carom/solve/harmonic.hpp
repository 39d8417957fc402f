#pragma once
// When an overlap function that repeats with every turn falls through zero: circular motion against lines and circles.
//
// On an arc of angular speed w every such function is f = g0 + g1 sin(w s) + g2 (1 - cos(w s)), and
//   (1 + (w t / 2)^2) f = c0 + c1 t + c2 t^2,  t = (2 / w) tan(w s / 2),  c2 = bend + w^2 c0 / 4  [papers/magnetic.md, eq. 4]
// where c0, c1 and 2 bend are f and its first two derivatives at s = 0. As s goes once about the turn, t runs from 0 to
// infinity and from -infinity back to 0; w -> 0 is straight flight, t = s. The discriminant is taken in wide arithmetic and
// each root in the form that does not cancel. What decides whether there is a root is + - * / sqrt alone; its time takes one
// arc tangent of the machine's own.

#include <cmath>

#include "carom/core/double_double.hpp"
#include "carom/core/real.hpp"

namespace carom {

/// Bound of the relative error of `first_fall` on an arc for double, in units of u = 2^-53, for the coefficients given and
/// D > 2^-40 c1^2 (measured by harmonic_test).
inline constexpr double arc_fall_error = 6.0;

/// An overlap function on an arc.
template <Real T>
struct ArcGap {
  T speed;       ///< w [rad / time], > 0
  Wide<T> c0;    ///< f now
  Wide<T> c1;    ///< its rate of change now
  Wide<T> bend;  ///< half of its second derivative now

  [[nodiscard]] Wide<T> c2() const { return Wide<T>(bend + c0 * Wide<T>(wide_product<T>(speed, speed) * (T(1) / 4))); }
  /// c1^2 - 4 c0 c2: > 0 if f changes its sign twice a turn.
  [[nodiscard]] Wide<T> discriminant() const { return Wide<T>(c1 * c1 - c0 * c2() * T(4)); }
  /// Time of a turn.
  [[nodiscard]] T turn() const {
    using std::atan;
    return 8 * atan(T(1)) / speed;
  }
  [[nodiscard]] ArcGap operator-() const { return {speed, Wide<T>(-c0), Wide<T>(-c1), Wide<T>(-bend)}; }
};

namespace detail {

/// Where f falls through zero, within the turn that begins now; discriminant > 0, and not both c0 = 0 and c1 <= 0.
template <Real T>
[[nodiscard]] inline T falling_root(const ArcGap<T>& f, const Wide<T>& discriminant) {
  using std::atan2;
  using std::sqrt;
  const T root = sqrt(narrow(discriminant)), c0 = narrow(f.c0), c1 = narrow(f.c1);
  T half;
  if (!(c1 < 0)) {
    half = atan2(T(f.speed * (c1 + root)), T(-4 * narrow(f.c2())));
  } else if (c0 > 0) {
    half = atan2(T(f.speed * c0), T(root - c1));
  } else {
    half = atan2(T(T(0) - f.speed * c0), T(c1 - root));  // 0 - 0 is +0: a whole turn
  }
  return 2 * half / f.speed;
}

/// Where f, which does not fall now, next turns to fall: less than a turn away. It rises, or is bent upwards.
template <Real T>
[[nodiscard]] inline T turning_point(const ArcGap<T>& f) {
  using std::atan2;
  return atan2(T(f.speed * narrow(f.c1)), T(-2 * narrow(f.bend))) / f.speed;
}

}  // namespace detail

/// First s >= 0 at which f is <= 0 and falling, or `never`, by the overlap rule of gap.hpp.
template <Real T>
[[nodiscard]] inline T first_fall(const ArcGap<T>& f) {
  const T c0 = narrow(f.c0), c1 = narrow(f.c1), bend = narrow(f.bend);
  if (!(c0 > 0) && (c1 < 0 || (c1 == 0 && bend < 0))) return T(0);
  if (!(c0 > 0) && c1 == 0 && bend == 0) return never<T>();
  const Wide<T> d = f.discriminant();
  if (narrow(d) > 0) return detail::falling_root(f, d);
  return c0 > 0 ? never<T>() : detail::turning_point(f);
}

/// First s > 0 at which f, which is < 0 and not an overlap as it lies beyond a line, falls through 0 from above, or `never`.
template <Real T>
[[nodiscard]] inline T fall_from_above(const ArcGap<T>& f) {
  const Wide<T> d = f.discriminant();
  return narrow(d) > 0 ? detail::falling_root(f, d) : never<T>();
}

/// When a contact that has just been resolved falls again: f(0) = 0 by state, and a c1 < 0 is rounding and counts as 0.
/// Rising, the later root is taken with the gap as it is, so that a body which comes back for ever does not wander off its
/// partner by a rounding each time. Returns 0 if f falls to second order (pressed together).
template <Real T>
[[nodiscard]] inline T return_to_contact(const ArcGap<T>& f) {
  if (!(narrow(f.c1) > 0)) return narrow(f.bend) < 0 ? T(0) : never<T>();
  const Wide<T> d = f.discriminant();
  return narrow(d) > 0 ? detail::falling_root(f, d) : T(2 * detail::turning_point(f));
}

}  // namespace carom
