// carom's compile options round every operation once, as written, also where the machine has a fused multiply-add.
//   a = 1 + 2^-30, b = 1 - 2^-30:  a b = 1 - 2^-60, which rounds to 1.
// So a b - 1 is 0 as written, and -2^-60 fused. The contracted variant shows that the inputs tell the two apart.

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "structure/rounding.hpp"

namespace {

constexpr double a = 1.0 + 0x1p-30;
constexpr double b = 1.0 - 0x1p-30;

class Contraction : public testing::Test {
 protected:
  void SetUp() override {
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
#endif
  }
};

TEST_F(Contraction, is_off_in_a_sum) {
  EXPECT_EQ(rounding::as_written::multiply_add(a, b, -1.0), 0.0);
  EXPECT_EQ(rounding::contracted::multiply_add(a, b, -1.0), -0x1p-60);
}

// Long enough for the widest vector unit, and a remainder.
TEST_F(Contraction, is_off_in_a_vectorised_loop) {
  constexpr int n = 19;
  std::array<double, n> x{}, y{}, as_written{}, contracted{};
  x.fill(a);
  y.fill(b);
  as_written.fill(-1.0);
  contracted.fill(-1.0);
  rounding::as_written::add_product(as_written.data(), x.data(), y.data(), n);
  rounding::contracted::add_product(contracted.data(), x.data(), y.data(), n);
  EXPECT_THAT(as_written, testing::Each(0.0));
  EXPECT_THAT(contracted, testing::Each(-0x1p-60));
}

}  // namespace
