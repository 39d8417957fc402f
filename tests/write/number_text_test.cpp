#include "carom/write/number_text.hpp"

#include <bit>
#include <charconv>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(NumberText, is_the_shortest) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(5.0), "5");
  EXPECT_EQ(number_text(-0.0), "-0");
  EXPECT_EQ(number_text(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(number_text(-std::numeric_limits<double>::max()), "-1.7976931348623157e+308");
  EXPECT_EQ(number_text(std::numeric_limits<double>::denorm_min()), "5e-324");
}

TEST(NumberText, reads_back_as_the_same_bits) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 20000; ++k) {
    const double x = std::bit_cast<double>(random());
    if (x != x) continue;
    const std::string text = number_text(x);
    double y = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), y);
    ASSERT_EQ(error, std::errc()) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(x), std::bit_cast<std::uint64_t>(y)) << text;
  }
}

TEST(NumberText, hexadecimal_is_exact) {
  EXPECT_EQ(hex_text(0x1p-12), "0x1p-12");
  EXPECT_EQ(hex_text(1.5), "0x1.8p+0");
}

}  // namespace
}  // namespace carom
