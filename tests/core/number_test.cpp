// Numbers as text: what is read, what it is exactly, and that it is rounded once.

#include "carom/core/number.hpp"
#include "carom/core/rational.hpp"

#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace carom {
namespace {

using Limits = std::numeric_limits<double>;
using boost::multiprecision::cpp_int;

Rational power_of_two(int e) {
  return e >= 0 ? Rational(cpp_int(1) << static_cast<unsigned>(e)) : Rational(1, cpp_int(1) << static_cast<unsigned>(-e));
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

// Uniform in the bits: every size and sign, finite.
double any_double(std::mt19937_64& random) {
  while (true) {
    const double v = std::bit_cast<double>(random());
    if (std::isfinite(v)) return v;
  }
}

double any_normal(std::mt19937_64& random) {
  while (true) {
    const double v = any_double(random);
    if (std::abs(v) >= Limits::min()) return v;
  }
}

TEST(Number, keeps_its_text_and_its_exact_value) {
  const Number tenth = parse_number("0.1");
  EXPECT_EQ(tenth.value, 0.1);
  EXPECT_EQ(tenth.text, "0.1");
  EXPECT_EQ(exact(tenth), Rational(1, 10));
  EXPECT_EQ(exact(parse_number("1/3")), Rational(1, 3));
  EXPECT_EQ(parse_number("1/3").value, 1.0 / 3.0);
  EXPECT_EQ(exact(parse_number("-6/4")), Rational(-3, 2));
  EXPECT_EQ(exact(parse_number("-2.50e-1")), Rational(-1, 4));
  EXPECT_EQ(exact(parse_number("1_000.5_0E+0_2")), Rational(100050));
  EXPECT_EQ(exact(parse_number("+007")), Rational(7));
  EXPECT_EQ(exact(parse_number("0/5")), Rational(0));
  EXPECT_EQ(exact(parse_number("1/1_000")), Rational(1, 1000));
}

TEST(Number, set_in_code_is_its_binary_value) {
  // 0.1 as a double is 3602879701896397 / 2^55.
  EXPECT_EQ(exact(Number(0.1)), Rational(cpp_int(3602879701896397), cpp_int(1) << 55));
  EXPECT_EQ(exact(Number(-3.0)), Rational(-3));
  EXPECT_EQ(exact(Number(0.0)), Rational(0));
  EXPECT_EQ(exact(Number(Limits::denorm_min())), power_of_two(-1074));
  EXPECT_EQ(exact(Number(Limits::max())), power_of_two(1024) - power_of_two(971));
}

TEST(Number, knows_the_infinities_and_the_signed_zero) {
  EXPECT_EQ(parse_number("inf").value, Limits::infinity());
  EXPECT_EQ(parse_number("-inf").value, -Limits::infinity());
  EXPECT_TRUE(same_bits(parse_number("-0.0").value, -0.0));
  EXPECT_TRUE(same_bits(parse_number("0e999999999999999999999").value, 0.0));
}

TEST(Number, refuses_what_is_no_number) {
  for (const char* text : {"",     "abc",  "1.", ".5",    "1e",  "1e+", "--1",   "1_",   "_1",   "1__0",
                           "1._5", "1 ",   " 1", "1/0",   "1/",  "/3",  "1/2/3", "1/-3", "nan",  "0x10",
                           "1,5",  "1e5x", "+",  "1/2e3", "Inf", "e5",  "0.1/",  "1e1_", "0_.5", "1\n"}) {
    EXPECT_THROW((void)parse_number(text), std::invalid_argument) << '"' << text << '"';
  }
  EXPECT_THROW((void)parse_number(std::string_view("1\0", 2)), std::invalid_argument);
}

TEST(Number, refuses_what_no_double_holds) {
  for (const char* text : {"1e400", "-1e309", "1e-400", "1e-310", "1.7976931348623159e308", "2.2e-308"}) {
    EXPECT_THROW((void)parse_number(text), std::out_of_range) << text;
  }
  EXPECT_EQ(parse_number("1.7976931348623157e308").value, Limits::max());
  EXPECT_EQ(parse_number("2.2250738585072014e-308").value, Limits::min());
  EXPECT_THROW((void)parse_number("1/" + std::string(320, '9')), std::out_of_range);
  EXPECT_THROW((void)parse_number(std::string(320, '9') + "/7"), std::out_of_range);
  // Long texts are no large numbers: (10^400 - 1)/9 over itself, and 10^-1000 * 10^1000.
  EXPECT_EQ(parse_number(std::string(400, '1') + "/" + std::string(400, '1')).value, 1.0);
  EXPECT_EQ(exact(parse_number("0." + std::string(999, '0') + "1e1000")), Rational(1));
}

TEST(Number, huge_exponents_cost_nothing) {
  const auto start = std::chrono::steady_clock::now();
  for (const char* text : {"1e999999999", "-1e-999999999", "1e99999999999999999999999", "9e-99999999999999999999999"}) {
    EXPECT_THROW((void)parse_number(text), std::out_of_range) << text;
    Number by_hand;
    by_hand.text = text;
    EXPECT_THROW((void)exact(by_hand), std::out_of_range) << text;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

TEST(NearestDouble, ties_go_to_even) {
  // 2^53 + 1 lies between 2^53 (even) and 2^53 + 2; 2^53 + 3 between 2^53 + 2 and 2^53 + 4 (even).
  const cpp_int two53 = cpp_int(1) << 53;
  EXPECT_EQ(nearest_double(Rational(cpp_int(two53 + 1))), 0x1p53);
  EXPECT_EQ(nearest_double(Rational(cpp_int(two53 + 3))), 0x1p53 + 4);
  EXPECT_EQ(nearest_double(Rational(cpp_int(two53 + 1)) + power_of_two(-200)), 0x1p53 + 2);
  EXPECT_EQ(nearest_double(Rational(cpp_int(-two53 - 1))), -0x1p53);
  EXPECT_EQ(nearest_double(2 - power_of_two(-60)), 2.0);  // rounds up into the next binade
}

TEST(NearestDouble, has_ieee_ends) {
  const Rational half_step = power_of_two(970);  // half of the last bit of the largest double
  const Rational largest = exact(Number(Limits::max()));
  EXPECT_EQ(nearest_double(largest + half_step - power_of_two(100)), Limits::max());
  EXPECT_EQ(nearest_double(largest + half_step), Limits::infinity());
  EXPECT_EQ(nearest_double(-power_of_two(5000)), -Limits::infinity());
  EXPECT_EQ(nearest_double(power_of_two(-1074)), Limits::denorm_min());
  EXPECT_EQ(nearest_double(power_of_two(-1075)), 0.0);
  EXPECT_EQ(nearest_double(power_of_two(-1075) * Rational(3, 2)), Limits::denorm_min());
  EXPECT_EQ(nearest_double(power_of_two(-1075) * 3), 2 * Limits::denorm_min());  // a tie: 1.5 units to 2
  EXPECT_EQ(nearest_double(power_of_two(-5000)), 0.0);
}

TEST(NearestDouble, returns_every_double) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 5000; ++i) {
    const double v = any_double(random);
    ASSERT_EQ(nearest_double(exact(Number(v))), v) << fmt::format("{:a}", v);
  }
}

TEST(NearestDouble, is_ieee_division_of_whole_numbers) {
  // Two whole numbers below 2^53 are exact doubles, and IEEE 754 rounds their quotient once.
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    const auto p = static_cast<std::int64_t>(random() >> (11 + random() % 50));
    const auto q = static_cast<std::int64_t>(random() >> (11 + random() % 50)) + 1;
    ASSERT_EQ(nearest_double(Rational(p, q)), static_cast<double>(p) / static_cast<double>(q)) << p << '/' << q;
    ASSERT_EQ(parse_number(fmt::format("-{}/{}", p, q)).value, -static_cast<double>(p) / static_cast<double>(q));
  }
}

TEST(NearestDouble, is_nearer_than_its_neighbours) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    // A rational of any size, with more bits than a double.
    const double v = any_normal(random) / 4;
    const Rational r =
        exact(Number(v)) * (1 + Rational(static_cast<std::int64_t>(random() % 1000), 7919) * power_of_two(-52));
    const double d = nearest_double(r);
    const Rational error = abs(Rational(exact(Number(d)) - r));
    ASSERT_LE(error, abs(Rational(exact(Number(std::nextafter(d, Limits::infinity()))) - r))) << fmt::format("{:a}", v);
    ASSERT_LE(error, abs(Rational(exact(Number(std::nextafter(d, -Limits::infinity()))) - r))) << fmt::format("{:a}", v);
  }
}

TEST(ParseNumber, reads_back_the_shortest_and_the_longest_text) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 2000; ++i) {
    const double v = any_normal(random);
    ASSERT_EQ(parse_number(fmt::format("{}", v)).value, v);
    const Number longest = parse_number(fmt::format("{:.800e}", v));  // all digits of any double
    ASSERT_EQ(longest.value, v);
    ASSERT_EQ(exact(longest), exact(Number(v)));
  }
}

TEST(ParseNumber, rounds_its_exact_value_once) {
  // Two ways to the same double: the decimal parser, and integer arithmetic on the exact rational.
  std::mt19937_64 random(5);
  for (int i = 0; i < 5000; ++i) {
    const std::string text = fmt::format("{}{}.{:019d}e{}", random() % 2 == 0 ? "-" : "", random() % 10, random() >> 1,
                                         static_cast<int>(random() % 600) - 300);
    const Number n = parse_number(text);
    ASSERT_EQ(n.value, nearest_double(exact(n))) << text;
  }
}

// The exact value of a fraction costs the square of its digits.
TEST(ParseNumber, refuses_what_is_too_long_to_be_meant) {
  const std::string third = "1/3" + std::string(longest_number - 3, '0');
  EXPECT_THROW(static_cast<void>(parse_number(third)), std::out_of_range);  // 10^-9997
  EXPECT_EQ(parse_number("0." + std::string(longest_number - 2, '3')).value, 1.0 / 3.0);
  EXPECT_EQ(parse_number(std::string(4999, '1') + "/" + std::string(4999, '3')).value, 1.0 / 3.0);
  EXPECT_THROW(static_cast<void>(parse_number("0." + std::string(longest_number - 1, '3'))), std::length_error);
  EXPECT_THROW(static_cast<void>(parse_number("1/" + std::string(1'000'000, '3'))), std::length_error);
}

}  // namespace
}  // namespace carom
