#pragma once
// The positive times at which a polynomial of degree <= 4 changes its sign, without transcendental functions.
//
// Between two sign changes of its derivative a polynomial is monotone, so it has a root there if and only if its signs at
// both ends differ [papers/contact_times.md, eq. 13]. The derivative's sign changes come the same way, down to a quadratic.
// A root where the sign does not change (a double root) is none.

#include <algorithm>

#include "carom/solve/horner.hpp"

namespace carom {

template <Real T>
struct Crossings {
  std::array<T, Polynomial<T>::max_degree> t{};  ///< ascending, > 0
  int count = 0;
};

namespace detail {

template <Real T>
[[nodiscard]] inline int sign_of(const T& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

template <Real T>
[[nodiscard]] inline int sign_at(const Polynomial<T>& p, int i) {
  return sign_of(narrow(p.c[i]));
}

/// The power of t that p starts with, at most the degree.
template <Real T>
[[nodiscard]] inline int lowest(const Polynomial<T>& p) {
  int i = 0;
  while (i < p.degree && sign_at(p, i) == 0) ++i;
  return i;
}

template <Real T>
inline void trim(Polynomial<T>& p) {
  while (p.degree > 0 && sign_at(p, p.degree) == 0) --p.degree;
}

template <Real T>
[[nodiscard]] inline Polynomial<T> derivative(const Polynomial<T>& p) {
  Polynomial<T> q;
  q.degree = std::max(p.degree - 1, 0);
  for (int i = 1; i <= p.degree; ++i) q.c[i - 1] = p.c[i] * T(i);
  trim(q);
  return q;
}

/// Powers of two between which the size of every root that is not 0 lies [papers/contact_times.md, eq. 14].
struct RootRange {
  long low = 0;
  long high = 0;
};
template <Real T>
[[nodiscard]] inline RootRange root_range(const Polynomial<T>& p) {
  const auto exponent = [&p](int i) { return exponent_of<T>(narrow(p.c[i])); };
  const auto up = [](long n, long k) { return n >= 0 ? (n + k - 1) / k : -(-n / k); };
  const int m = lowest(p);
  const int n = p.degree;
  const long em = exponent(m);
  const long en = exponent(n);
  long high = up(em - en + 1, n - m);
  long low = up(en - em + 1, n - m);
  for (int i = m + 1; i < n; ++i) {
    if (sign_at(p, i) == 0) continue;
    const long e = exponent(i);
    high = std::max(high, up(e - en + 1, n - i));
    low = std::max(low, up(e - em + 1, i - m));
  }
  return {-(low + 1), high + 1};
}

/// The root of a polynomial that is monotone between lo and hi, where its signs are `sign` and -sign. Newton's method kept
/// inside the bracket, which shrinks at every step; where a step does not halve the last one it is a bisection.
/// Ends when the value cannot be told from 0, or the step is below the resolution.
template <Real T>
[[nodiscard]] inline T newton(const Window<T>& p, T lo, T hi, int sign) {
  using std::abs;
  const T resolution = 2 * unit_roundoff<T>();
  T s = (lo + hi) / 2;
  T step = hi - lo;
  for (int i = 0; i < 4 * significand_bits<T>(); ++i) {
    const Enclosed<T> p_s = p.enclose(s);
    if (p_s.sign() == 0) return s;
    (p_s.sign() == sign ? lo : hi) = s;
    const T slope = p.slope(s);
    const T last = step;
    step = slope != 0 ? T(p_s.value / slope) : last;
    T next = s - step;
    const bool inside = lo <= next && next <= hi;
    if (inside && abs(step) <= resolution * s) return next;
    if (!inside || 2 * abs(step) > abs(last)) {
      next = (lo + hi) / 2;
      if (next == lo || next == hi) return s;
      step = s - next;
    }
    s = next;
  }
  return s;
}

/// The same between any lo >= 0 and hi, which may be infinite: first the power of two, then the root.
template <Real T>
[[nodiscard]] inline T crossing(const Polynomial<T>& p, const T& lo, const T& hi, int sign) {
  const RootRange range = root_range(p);
  long low = range.low;
  long high = range.high;
  if (lo > 0) low = std::max(low, exponent_of(lo) - 1);
  if (hi < never<T>()) high = std::min(high, exponent_of(hi));
  while (high - low > 1) {
    const long middle = low + (high - low) / 2;
    (Window<T>(p, middle).enclose(T(1)).sign() == sign ? low : high) = middle;
  }
  const T from = lo > 0 ? std::max(T(1), times_power_of_two(lo, -low)) : T(1);
  const T to = hi < never<T>() ? std::min(T(2), times_power_of_two(hi, -low)) : T(2);
  return times_power_of_two(newton(Window<T>(p, low), from, to, sign), low);
}

/// Degree 2 in closed form, t scaled so that the outer coefficients are alike and nothing overflows.
template <Real T>
[[nodiscard]] inline Crossings<T> quadratic_crossings(const Polynomial<T>& p) {
  using std::abs;
  using std::sqrt;
  Crossings<T> found;
  const int s0 = sign_at(p, 0);
  const int s1 = sign_at(p, 1);
  const int s2 = sign_at(p, 2);
  if (s0 == 0 || s0 == s2) {
    if (s1 == 0 || s1 == s2) return found;
    if (s0 == 0) {
      found.t[found.count++] = narrow(Wide<T>(-p.c[1] / p.c[2]));
      return found;
    }
  }
  const long e0 = exponent_of<T>(narrow(p.c[0]));
  const long e2 = exponent_of<T>(narrow(p.c[2]));
  const long k = (e0 - e2) / 2;
  const Wide<T> c0 = times_power_of_two(p.c[0], -e0);
  const Wide<T> c2 = times_power_of_two(p.c[2], 2 * k - e0);
  const Wide<T> half = times_power_of_two(p.c[1], k - e0 - 1);
  Wide<T> far;   // half + sqrt(half^2 - c0 c2) in size: no cancellation
  if (s1 != 0 && exponent_of<T>(narrow(p.c[1])) + k - e0 > 300) {
    far = half + half;  // the rest is below 2^-600 of it
  } else {
    const Wide<T> square = half * half;
    const Wide<T> product = c0 * c2;
    const Wide<T> d = square - product;
    if (!(narrow(d) > detail::horner_error<T>() * (narrow(square) + abs(narrow(product))))) return found;
    const Wide<T> root = sqrt(d);
    far = s1 < 0 ? Wide<T>(half - root) : Wide<T>(half + root);
  }
  const T x = times_power_of_two(narrow(Wide<T>(-far / c2)), k);
  const T y = times_power_of_two(narrow(Wide<T>(-c0 / far)), k);
  if (x > 0) found.t[found.count++] = x;
  if (y > 0) found.t[found.count++] = y;
  if (found.count == 2 && y < x) std::swap(found.t[0], found.t[1]);
  return found;
}

}  // namespace detail

/// Positive sign changes of p, ascending.
template <Real T>
[[nodiscard]] inline Crossings<T> crossings(const Polynomial<T>& p) {
  Crossings<T> found;
  if (p.degree == 0) return found;
  if (p.degree == 1) {
    if (detail::sign_at(p, 0) * detail::sign_at(p, 1) < 0)
      found.t[found.count++] = narrow(Wide<T>(-p.c[0] / p.c[1]));
    return found;
  }
  if (p.degree == 2) return detail::quadratic_crossings(p);
  const Crossings<T> turns = crossings(detail::derivative(p));
  T lo(0);
  int sign_lo = detail::sign_at(p, detail::lowest(p));
  for (int i = 0; i <= turns.count; ++i) {
    const bool last = i == turns.count;
    const T hi = last ? never<T>() : turns.t[i];
    const int sign_hi = last ? detail::sign_at(p, p.degree) : enclose(p, hi).sign();
    if (sign_lo * sign_hi < 0) found.t[found.count++] = detail::crossing(p, lo, hi, sign_lo);
    lo = hi;
    sign_lo = sign_hi;
  }
  return found;
}

}  // namespace carom
