#pragma once
// The exact value of a number, as a quotient of whole numbers.

#include <boost/multiprecision/cpp_int.hpp>

#include "carom/core/number.hpp"

namespace carom {

using Rational = boost::multiprecision::cpp_rational;

/// The exact value. Requires a finite number.
[[nodiscard]] Rational exact(const Number& number);

/// The double nearest to a rational, ties to even.
[[nodiscard]] double nearest_double(const Rational& r);

}  // namespace carom
