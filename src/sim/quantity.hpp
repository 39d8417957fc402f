#pragma once
// A number of a world in the user's units: the nearest double, and all digits where the world's arithmetic has more.

#include <charconv>
#include <cmath>
#include <string>

#include "carom/core/number.hpp"
#include "carom/core/real.hpp"
#include "carom/world/units.hpp"

namespace carom {

/// Decimal digits that the arithmetic is sure of.
template <Real T>
[[nodiscard]] inline int decimal_digits() {
  return static_cast<int>(significand_bits<T>() * 302L / 1000);
}

/// x to as many significant digits as its arithmetic is sure of; nothing where it is no finite number.
template <Real T>
[[nodiscard]] inline std::string digits_of(const T& x) {
  if (!(x - x == 0)) return "";
  if constexpr (std::is_floating_point_v<T>) {
    char text[64];
    const auto [end, error] = std::to_chars(text, text + sizeof text, x);
    return std::string(text, end);
  } else {
    return x.str(decimal_digits<T>(), std::ios_base::fmtflags(0));
  }
}

/// x 2^exponent.
template <Real T>
[[nodiscard]] inline Number quantity(const T& x, int exponent) {
  if constexpr (std::is_same_v<T, double>) {
    return Number(std::ldexp(x, exponent));
  } else {
    const T there = scaled(x, exponent);
    Number n(static_cast<double>(there));
    n.text = digits_of(there);
    return n;
  }
}

}  // namespace carom
