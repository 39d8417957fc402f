#pragma once
// A scene's number in the arithmetic of a world.

#include <cmath>
#include <type_traits>

#include "carom/core/number.hpp"
#include "carom/core/rational.hpp"

namespace carom {

/// The number times 2^exponent in Real: the exact text rounded once (for double: the double of the scene, scaled exactly).
template <class Real>
[[nodiscard]] inline Real real_number(const Number& number, int exponent) {
  using std::ldexp;
  if constexpr (std::is_same_v<Real, double>) {
    return ldexp(number.value, exponent);
  } else {
    if (!std::isfinite(number.value)) return infinity<Real>();
    const Rational r = exact(number);
    return ldexp(Real(Real(numerator(r)) / Real(denominator(r))), exponent);
  }
}

}  // namespace carom
