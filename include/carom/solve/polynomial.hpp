#pragma once
// When an overlap function that is a polynomial of degree <= 4 in time falls through zero: relative acceleration.

#include <cstddef>

#include "carom/solve/crossings.hpp"

namespace carom {

namespace detail {

template <Real T, class Coefficient, std::size_t N>
[[nodiscard]] inline Polynomial<T> polynomial(const std::array<Coefficient, N>& c) {
  static_assert(N >= 1 && N <= Polynomial<T>::max_degree + 1);
  Polynomial<T> p;
  p.degree = int(N) - 1;
  for (std::size_t i = 0; i < N; ++i) p.c[i] = c[i];
  trim(p);
  return p;
}

/// The first sign change of p from + to - after `lo`, a point between two of which p is monotone: 0, or turns.t[i - 1].
template <Real T>
[[nodiscard]] inline T first_crossing(const Polynomial<T>& p, const Crossings<T>& turns, int i) {
  T lo = i == 0 ? T(0) : turns.t[i - 1];
  for (; i <= turns.count; ++i) {
    const bool last = i == turns.count;
    const T hi = last ? never<T>() : turns.t[i];
    if ((last ? sign_at(p, p.degree) : enclose(p, hi).sign()) < 0) return crossing(p, lo, hi, +1);
    lo = hi;
  }
  return never<T>();
}

template <Real T>
[[nodiscard]] inline T first_fall(const Polynomial<T>& p) {
  if (std::none_of(p.c.begin(), p.c.begin() + p.degree + 1, [](const Wide<T>& c) { return narrow(c) < 0; })) {
    return never<T>();  // rises, or stays, from wherever it is
  }
  if (sign_at(p, 0) > 0) return first_crossing(p, crossings(derivative(p)), 0);
  const Polynomial<T> rate = derivative(p);
  const int rising = sign_at(rate, lowest(rate));
  if (rising < 0) return T(0);
  if (rising == 0) return never<T>();
  const Crossings<T> turns = crossings(rate);
  if (turns.count == 0) return never<T>();
  if (enclose(p, turns.t[0]).sign() <= 0) return turns.t[0];
  return first_crossing(p, turns, 1);
}

/// f / t given.
template <Real T>
[[nodiscard]] inline T next_fall(Polynomial<T> p) {
  if (sign_at(p, 0) < 0) p.c[0] = T(0);
  const int start = lowest(p);
  const int rising = sign_at(p, start);
  if (rising == 0) return never<T>();
  if (rising < 0) return T(0);
  std::rotate(p.c.begin(), p.c.begin() + start, p.c.end());
  p.degree -= start;
  return first_fall(p);
}

}  // namespace detail

/// Bounds for double, u = 2^-53 [papers/contact_times.md, eq. 15, 16]. With t returned and t* the exact answer for the
/// given f,
///   |t - t*| <= root_error u t + root_noise u^2 sum |c_i t^i| / |f'(t)|,
/// and a minimum or maximum of f within root_noise u^2 sum |c_i t^i| of 0 counts as 0: it touches.
inline constexpr double root_error = 4.0;
inline constexpr double root_noise = 256.0;

/// First t >= 0 at which f = c[0] + c[1] t + ... (degree <= 4) is <= 0 and falling, or `never`, by the overlap rule of
/// gap.hpp. The order is that of the coefficients that are there (not 0). Their sizes may differ by any power that double
/// holds.
template <Real T, std::size_t N>
[[nodiscard]] inline T first_fall(const std::array<T, N>& c) {
  return detail::first_fall(detail::polynomial<T>(c));
}
/// With coefficients in twice the precision, as `pair_polynomial` gives them.
template <std::size_t N>
[[nodiscard]] inline double first_fall(const std::array<DoubleDouble, N>& c) {
  return detail::first_fall(detail::polynomial<double>(c));
}

/// The same for a contact that has just been resolved, f(0) = 0 by state: f = t (c[0] + c[1] t + ...), so the
/// coefficients begin with that of t. f does not fall to first order: a c[0] < 0 is rounding and counts as 0. Returns 0
/// if the next one falls.
template <Real T, std::size_t N>
[[nodiscard]] inline T next_fall(const std::array<T, N>& c) {
  return detail::next_fall(detail::polynomial<T>(c));
}
template <std::size_t N>
[[nodiscard]] inline double next_fall(const std::array<DoubleDouble, N>& c) {
  return detail::next_fall(detail::polynomial<double>(c));
}

}  // namespace carom
