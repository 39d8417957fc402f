// Lanes have the bits of doubles alone, with and without vector instructions.

#include <gtest/gtest.h>

#include "core/lane_checks.hpp"

namespace carom::testing {
namespace {

void expect_none(const LaneDifferences& d) {
  EXPECT_EQ(d.looked_at, 20000);
  EXPECT_EQ(d.wide, 0);
  EXPECT_EQ(d.dots, 0);
  EXPECT_EQ(d.order, 0);
  EXPECT_EQ(d.clock, 0);
  EXPECT_EQ(d.chosen, 0);
  EXPECT_EQ(d.squares, 0);
}

TEST(Lanes, have_the_bits_of_doubles_alone) { expect_none(as_compiled::lane_differences()); }

#if defined(CAROM_HAVE_V3_CHECKS)
TEST(Lanes, have_the_bits_of_doubles_alone_in_vectors) {
  if (__builtin_cpu_supports("avx2") == 0 || __builtin_cpu_supports("fma") == 0) GTEST_SKIP() << "no AVX2 here";
  expect_none(for_v3::lane_differences());
}
#endif

}  // namespace
}  // namespace carom::testing
