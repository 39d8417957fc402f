#pragma once
// When a gap that is a polynomial of degree 1 or 2 in time falls through zero: planes, and balls on a line.
//
// The overlap rule [Bannerman2014; papers/contact_times.md, eq. 1]: f > 0: the next time f turns negative. f <= 0 and
// falling: now. f <= 0 and rising: where f next turns to fall, if f <= 0 there; else the next time it turns negative.
// Falling is the sign of the first derivative that is not zero. Touching zero without turning negative is no event.

#include "carom/core/double_double.hpp"
#include "carom/core/real.hpp"

namespace carom {

/// First t >= 0 at which gap + rate t is <= 0 and falling, or `never`. One rounding.
template <Real T>
[[nodiscard]] inline T gap_time(const T& gap, const T& rate) {
  if (!(rate < 0)) return never<T>();
  return gap > 0 ? T(gap / -rate) : T(0);
}

/// q^2 - p r. For double the sign is exact and the relative error <= 4 u, barring underflow [Boldo2009, after Kahan2004].
template <Real T>
[[nodiscard]] inline T discriminant(const T& p, const T& q, const T& r) {
  const T qq = q * q;
  const T pr = p * r;
  if constexpr (std::is_same_v<T, double>) {
    if (qq + pr > 3.0 * (qq > pr ? qq - pr : pr - qq)) return (qq - pr) + (two_prod(q, q).lo - two_prod(p, r).lo);
  }
  return T(qq - pr);
}

/// Bound of the relative error of `first_fall` for a parabola, in units of u = 2^-53 [papers/contact_times.md, eq. 12].
inline constexpr double parabola_error = 6.0;

/// First t >= 0 at which f = g0 + g1 t + g2 t^2 is <= 0 and falling, or `never`.
/// Every root is taken in the form that does not cancel; the exact sign of g1^2 - 4 g2 g0 decides whether there is one.
template <Real T>
[[nodiscard]] inline T first_fall(const T& g0, const T& g1, const T& g2) {
  using std::sqrt;
  if (g2 == 0) return gap_time(g0, g1);
  if (!(g0 > 0)) {
    if (g1 < 0 || (g1 == 0 && g2 < 0)) return T(0);
    if (g2 > 0) return never<T>();  // rises for ever
    const T d = discriminant(T(4 * g2), g1, g0);
    return d > 0 ? T((g1 + sqrt(d)) / (-2 * g2)) : T(g1 / (-2 * g2));
  }
  if (g2 > 0 && !(g1 < 0)) return never<T>();
  const T d = discriminant(T(4 * g2), g1, g0);
  if (!(d > 0)) return never<T>();
  return g1 > 0 ? T((g1 + sqrt(d)) / (-2 * g2)) : T(2 * g0 / (sqrt(d) - g1));
}

/// The same for a contact that has just been resolved: f(0) = 0 by state, so f = t (g1 + g2 t), and f does not fall to
/// first order. A g1 < 0 is rounding and counts as 0. Returns 0 if f falls to second order (pressed together).
template <Real T>
[[nodiscard]] inline T next_fall(const T& g1, const T& g2) {
  if (!(g2 < 0)) return never<T>();
  return g1 > 0 ? T(g1 / -g2) : T(0);
}

/// When a contact that has just been resolved, g0 = 0 but for rounding, falls again. Rising, the later root is taken with
/// the gap as it is, so that a body which comes back for ever does not wander off its partner by a rounding each time.
template <Real T>
[[nodiscard]] inline T return_to_contact(const T& g0, const T& g1, const T& g2) {
  return g1 > 0 ? first_fall(g0, g1, g2) : next_fall(g1, g2);
}

}  // namespace carom
