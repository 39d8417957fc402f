#pragma once
// When a smooth overlap function falls through zero, from a bound of its second derivative alone: no root is stepped over.
//
// Where f'' >= -bend, f stays above f(t) + f'(t) h - bend h^2 / 2, so it has no root before that parabola has one. Steps from
// root to root of these parabolas approach the first root of f from below, quadratically where it is simple: near it they are
// Newton's.

#include "carom/core/real.hpp"

namespace carom {

/// An overlap function at a moment.
template <Real T>
struct Overlap {
  T value;  ///< f
  T rate;   ///< f'
};

namespace detail {

/// f has no root nearer than this; after a value <= 0 that rises, f does not turn to fall nearer than this.
template <Real T>
[[nodiscard]] inline T clear_of_roots(const Overlap<T>& f, const T& bend) {
  using std::sqrt;
  if (!(f.value > 0)) return f.rate > 0 ? (bend > 0 ? T(f.rate / bend) : never<T>()) : T(0);
  if (!(bend > 0)) return f.rate < 0 ? T(f.value / -f.rate) : never<T>();
  const T root = sqrt(T(f.rate * f.rate + 2 * bend * f.value));
  return f.rate < 0 ? T(2 * f.value / (root - f.rate)) : T((f.rate + root) / bend);
}

}  // namespace detail

/// First t in [from, until] at which f is <= 0 and falling, by the overlap rule of gap.hpp, or `never`. `f(t)` is an
/// Overlap<T> and f'' >= -bend in [from, until]; before t + wait(t) it does not fall through 0 (a bound that is known
/// otherwise, 0 if none is). What is found is the root of f as it is evaluated: within a rounding of t, and what the rounding
/// of f makes of it, error of f / |f'|.
template <Real T, class F, class Wait>
[[nodiscard]] inline T bracketed_fall(F&& f, Wait&& wait, const T& from, const T& until, const T& bend) {
  T t = from;
  while (true) {
    const T idle = wait(t);
    if (idle == never<T>()) return idle;
    t += idle;
    if (t > until) return never<T>();
    const Overlap<T> now = f(t);
    if (!(now.value > 0) && now.rate < 0) return t;
    const T next = t + detail::clear_of_roots(now, bend);
    if (!(next > t)) return t;  // nearer than a rounding
    t = next;
  }
}
template <Real T, class F>
[[nodiscard]] inline T bracketed_fall(F&& f, const T& from, const T& until, const T& bend) {
  return bracketed_fall(f, [](const T&) { return T(0); }, from, until, bend);
}

}  // namespace carom
