// Intervals hold the exact results of what is computed in them: in doubles and in any precision, against rationals.

#include "certify/enclosure.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "carom/core/rational.hpp"
#include "sim/scenes.hpp"

namespace carom::certify {
namespace {

using carom::testing::Dice;

Rational rational(double x) { return exact(Number(x)); }

bool holds(const Outward& x, const Rational& r) {
  const bool above_lower = std::isinf(x.lower) || rational(x.lower) <= r;
  return above_lower && (std::isinf(x.upper) || r <= rational(x.upper));
}
/// By an enclosure of the rational in many more bits.
bool holds(const Enclosure& x, const Rational& r) {
  const Bits more(2000);
  const Enclosure truth = Enclosure::of(r);
  return !is_before(truth, x.lower()) && !is_before(x.upper(), truth);
}

/// A double of any sign, with exponents from -60 to 60.
double number(Dice& dice) { return std::ldexp(dice.between(-1.0, 1.0), static_cast<int>(dice.between(-60.0, 60.0))); }

template <class I>
void expect_operations_to_hold(Dice& dice) {
  const double a = number(dice), b = number(dice), c = number(dice), d = number(dice);
  const Rational p = rational(a), q = rational(b), r = rational(c), s = rational(d);
  // Both operands are results already, so they are intervals with a width.
  const I x = I(a) * I(b), y = I(c) + I(d);
  const Rational u = p * q, v = r + s;
  EXPECT_TRUE(holds(x, u));
  EXPECT_TRUE(holds(y, v));
  EXPECT_TRUE(holds(x + y, u + v));
  EXPECT_TRUE(holds(x - y, u - v));
  EXPECT_TRUE(holds(x * y, u * v));
  EXPECT_TRUE(holds(-x, -u));
  EXPECT_TRUE(holds(square(y), v * v));
  EXPECT_TRUE(holds(half(x), u / 2));
  EXPECT_TRUE(holds(x - x, 0));
}

TEST(Outward, holds_the_exact_results) {
  Dice dice(1);
  for (int n = 0; n < 2000; ++n) expect_operations_to_hold<Outward>(dice);
  EXPECT_TRUE(holds(ratio<Outward>(1, 3), Rational(1, 3)));
  EXPECT_FALSE(holds(Outward(1.0 / 3.0), Rational(1, 3))) << "one third is no double";
}

// 1e-300 squared is below the smallest double, 1e300 squared above the largest; inf - inf is anything.
TEST(Outward, holds_what_underflows_and_overflows) {
  const Outward tiny(1e-300), huge(1e300);
  EXPECT_TRUE(holds(tiny * tiny, rational(1e-300) * rational(1e-300)));
  EXPECT_TRUE(holds(square(tiny) - square(tiny) * huge * tiny, Rational(0)));
  EXPECT_FALSE(is_positive(tiny * tiny)) << "it cannot be told from 0 here";
  EXPECT_TRUE(holds(huge * huge, rational(1e300) * rational(1e300)));
  const Outward whole = huge * huge - huge * huge;
  EXPECT_FALSE(is_positive(whole) || is_negative(whole));
}

TEST(Enclosure, holds_the_exact_results_in_any_precision) {
  Dice dice(2);
  for (const int bits : {30, 53, 100, 400}) {
    const Bits scope(bits);
    for (int n = 0; n < 200; ++n) expect_operations_to_hold<Enclosure>(dice);
    EXPECT_TRUE(holds(Enclosure::of(Rational(1, 3)), Rational(1, 3)));
    EXPECT_TRUE(holds(square(sqrt(Enclosure(2.0))), 2));
    EXPECT_TRUE(holds(Enclosure(1.0) / Enclosure(3.0), Rational(1, 3)));
    EXPECT_LE(Enclosure::of(Rational(1, 3)).width().log10_size(), -0.3010 * bits);
  }
}

// Decimals are rounded outwards when written, and inwards when they are the bounds that something has to keep.
TEST(Enclosure, writes_outwards_and_reads_inwards) {
  const Bits scope(200);
  Dice dice(3);
  for (int n = 0; n < 500; ++n) {
    const Rational r = rational(number(dice)) / 3;
    const Enclosure x = Enclosure::of(r);
    for (const int digits : {3, 17, 50}) {
      const Rational lower = exact(parse_number(x.lower_text(digits))), upper = exact(parse_number(x.upper_text(digits)));
      EXPECT_LE(lower, r);
      EXPECT_LE(r, upper);
      const Enclosure inside = Enclosure::within(x.lower_text(digits), x.upper_text(digits));
      EXPECT_TRUE(x.is_inside(inside));
      const Bits more(2000);
      EXPECT_FALSE(is_before(inside.lower(), Enclosure::of(lower)));
      EXPECT_FALSE(is_before(Enclosure::of(upper), inside.upper()));
    }
  }
  EXPECT_FALSE(Enclosure::of(Rational(1, 3)).is_inside(Enclosure::within("0.3333", "0.3333"))) << "nothing lies in there";
}

}  // namespace
}  // namespace carom::certify
