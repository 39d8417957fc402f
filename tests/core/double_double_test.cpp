// Error-free transformations against 400-bit arithmetic, and the relative error of each double-double operation against the
// bound stated for it.

#include "carom/core/double_double.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

namespace carom {
namespace {

using Exact = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<400, boost::multiprecision::digit_base_2>, boost::multiprecision::et_off>;
constexpr double u = 0x1p-53;

Exact exact(const DoubleDouble& x) { return Exact(x.hi) + Exact(x.lo); }

class Random {
 public:
  // Sizes log-uniform in 2^-60 .. 2^60, either sign.
  double number() {
    const double m = std::uniform_real_distribution<double>(1.0, 2.0)(engine_);
    return std::ldexp(coin() ? m : -m, std::uniform_int_distribution<int>(-60, 59)(engine_));
  }
  // A normalised pair whose low part fills its range.
  DoubleDouble pair() {
    const double hi = number();
    const double lo = 0.5 * (std::nextafter(std::fabs(hi), INFINITY) - std::fabs(hi)) *
                      std::uniform_real_distribution<double>(-1.0, 1.0)(engine_);
    return fast_two_sum(hi, lo);
  }
  bool coin() { return std::uniform_int_distribution<int>(0, 1)(engine_) == 1; }

 private:
  std::mt19937_64 engine_{20170715};
};

constexpr int trials = 8000;

// |computed - true| / |true| in units of u^2.
double error(const DoubleDouble& computed, const Exact& truth) {
  EXPECT_EQ(computed.hi, computed.hi + computed.lo) << "not normalised";
  return double(abs((exact(computed) - truth) / truth) / Exact(u * u));
}

TEST(TwoSum, is_exact) {
  Random random;
  for (int i = 0; i < trials; ++i) {
    const double a = random.number();
    const double b = random.number();
    const DoubleDouble s = two_sum(a, b);
    ASSERT_EQ(exact(s), Exact(a) + Exact(b));
    ASSERT_EQ(s.hi, a + b);
    ASSERT_EQ(exact(two_diff(a, b)), Exact(a) - Exact(b));
  }
}

TEST(TwoProd, is_exact_and_the_same_without_a_fused_operation) {
  Random random;
  for (int i = 0; i < trials; ++i) {
    const double a = random.number();
    const double b = random.number();
    const DoubleDouble p = detail::two_prod_dekker(a, b);
    ASSERT_EQ(exact(p), Exact(a) * Exact(b));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(p.lo), std::bit_cast<std::uint64_t>(std::fma(a, b, -(a * b))));
    ASSERT_EQ(two_prod(a, b), p);
  }
  // An exact product leaves +0 either way.
  for (const double a : {-3.0, 3.0})
    for (const double b : {-0.5, 0.5, 0.0, -0.0}) {
      ASSERT_FALSE(std::signbit(detail::two_prod_dekker(a, b).lo));
      ASSERT_FALSE(std::signbit(two_prod(a, b).lo));
    }
}

struct Worst {
  double add = 0, add_double = 0, multiply = 0, multiply_double = 0, divide = 0, divide_double = 0, root = 0;
};

Worst measure() {
  Random random;
  Worst w;
  for (int i = 0; i < trials; ++i) {
    const DoubleDouble x = random.pair();
    DoubleDouble y = random.pair();
    if (i % 4 == 0) y = fast_two_sum(-x.hi * (1 + 8 * u), y.lo / y.hi * x.hi);  // x + y cancels
    const double z = random.number();
    w.add = std::max(w.add, error(x + y, exact(x) + exact(y)));
    w.add = std::max(w.add, error(x - y, exact(x) - exact(y)));
    w.add_double = std::max(w.add_double, error(x + z, exact(x) + Exact(z)));
    w.add_double = std::max(w.add_double, error(z - x, Exact(z) - exact(x)));
    w.multiply = std::max(w.multiply, error(x * y, exact(x) * exact(y)));
    w.multiply_double = std::max(w.multiply_double, error(x * z, exact(x) * Exact(z)));
    w.divide = std::max(w.divide, error(x / y, Exact(exact(x) / exact(y))));
    w.divide_double = std::max(w.divide_double, error(x / z, Exact(exact(x) / Exact(z))));
    w.root = std::max(w.root, error(sqrt(abs(x)), Exact(sqrt(abs(exact(x))))));
  }
  return w;
}

TEST(DoubleDouble, keeps_its_error_bounds) {
  const Worst w = measure();
  EXPECT_LE(w.add, 3.0 / (1 - 4 * u));
  EXPECT_LE(w.add_double, 2.0);
  EXPECT_LE(w.multiply, 5.0);
  EXPECT_LE(w.multiply_double, 1.5 + 4 * u);
  EXPECT_LE(w.divide, 15.0 + 56 * u);
  EXPECT_LE(w.divide_double, 3.0);
  EXPECT_LE(w.root, 25.0 / 8.0);
  // The sample reaches into the bounds: plain double arithmetic would show 1/u here.
  EXPECT_GT(w.multiply, 1.0);
  EXPECT_GT(w.divide, 1.0);
}

TEST(DoubleDouble, rounds_once_to_double) {
  // (1 + 2^-52)(1 - 2^-53) = 1 + 2^-53 - 2^-105, just below the midpoint of 1 and 1 + 2^-52.
  const DoubleDouble p = two_prod(1 + 0x1p-52, 1 - 0x1p-53);
  EXPECT_EQ(narrow(p), 1.0);
  EXPECT_EQ(narrow(p + 0x1p-104), 1 + 0x1p-52);
  // 1/3 to 106 bits: three times it is 1 but for 3 u^2.
  const DoubleDouble third = DoubleDouble(1.0) / 3.0;
  EXPECT_EQ(narrow(third * 3.0), 1.0);
  EXPECT_LE(std::fabs(narrow(third * 3.0 - 1.0)), 3 * u * u);
}

TEST(DoubleDouble, orders_by_value) {
  const DoubleDouble one(1.0);
  const DoubleDouble more(1.0, 0x1p-60);
  EXPECT_LT(one, more);
  EXPECT_GT(more, one);
  EXPECT_EQ(one, 1.0);
  EXPECT_LT(-more, -one);
  EXPECT_EQ(abs(-more), more);
  EXPECT_EQ(sqrt(DoubleDouble(0.0)), 0.0);
}

TEST(DoubleDouble, works_at_compile_time) {
  static_assert(two_sum(1.0, 0x1p-80) == DoubleDouble(1.0, 0x1p-80));
  static_assert(two_prod(1 + 0x1p-30, 1 + 0x1p-30) == DoubleDouble(1 + 0x1p-29, 0x1p-60));
  static_assert(DoubleDouble(1.0) / DoubleDouble(4.0) == 0.25);
}

TEST(Wide, is_double_double_for_double_and_itself_for_any_other) {
  static_assert(std::is_same_v<Wide<double>, DoubleDouble>);
  static_assert(std::is_same_v<Wide<Exact>, Exact>);
  EXPECT_EQ(exact(wide_product(0.1, 0.1)), Exact(0.1) * Exact(0.1));
  EXPECT_EQ(wide_sum(Exact(1), Exact(2)), Exact(3));
  EXPECT_EQ(exact(wide_difference(1.0, 0x1p-90)), Exact(1) - Exact(0x1p-90));
  EXPECT_EQ(narrow(Exact(7)), Exact(7));
}

}  // namespace
}  // namespace carom
