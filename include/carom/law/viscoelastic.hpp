#pragma once
// Restitution of viscoelastic spheres: it depends on the speed of approach, and slow impacts are elastic.

#include "carom/solve/horner.hpp"

namespace carom {

/// e(x) = (1 + a x) / (1 + a x + b x^2 + c x^3 + d x^4), x = beta^(1/2) v^(1/10), the Pade approximant of
/// [MullerPoschel2011] for x'' = -x^(3/2) - beta v^(1/5) x^(1/2) x', which ends when the force does
/// [papers/viscoelastic.md, eq. 4]. From 1 at x = 0 it falls strictly; rounding makes it no larger than 1.
template <class Real>
[[nodiscard]] inline Real viscoelastic_restitution(const Real& x) {
  const Real a(0.501086), b(1.15345), c(0.577977), d(0.532178);
  const Real numerator = 1 + a * x;
  return numerator / (1 + x * (a + x * (b + x * (c + x * d))));
}

/// The x at which restitution is e, 0 < e <= 1: by bisection, to the last bit.
template <class Real>
[[nodiscard]] inline Real viscoelastic_argument(const Real& e) {
  if (!(e < 1)) return Real(0);
  Real low(0), high(1);
  while (viscoelastic_restitution(high) > e) high = 2 * high;
  while (true) {
    const Real middle = (low + high) / 2;
    if (!(low < middle && middle < high)) return high;
    (viscoelastic_restitution(middle) > e ? low : high) = middle;
  }
}

/// v^(1/10), v >= 0. The fifth root of sqrt(v) is taken by Newton's iteration from above, which ends when it no longer
/// falls: the same bits on every machine.
template <class Real>
[[nodiscard]] inline Real tenth_root(const Real& v) {
  using std::sqrt;
  if (!(v > 0)) return Real(0);
  const Real y = sqrt(v);
  const long e = detail::exponent_of(y);
  const long k = e >= 0 ? (e + 4) / 5 : -(-e / 5);
  const Real m = detail::times_power_of_two(y, -5 * k);  // 1/32 <= m < 1
  Real x(1);
  while (true) {
    const Real xx = x * x;
    const Real next = (4 * x + m / (xx * xx)) / 5;
    if (!(next < x)) return detail::times_power_of_two(x, k);
    x = next;
  }
}

}  // namespace carom
