// Standard errors against synthetic data whose true error is known.

#include "carom/observe/block_sums.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "carom/core/random.hpp"

namespace carom {
namespace {

const auto mean = [](const auto& s) { return s[1] / s[0]; };

TEST(BlockSums, keeps_the_totals_through_every_doubling) {
  BlockSums<1> sums(1.0);
  for (int i = 0; i < 100'000; ++i) {
    sums.add(i + 0.5, {1.0});
    ASSERT_EQ(sums.total()[0], i + 1.0);
  }
  sums.end(100'000);
  EXPECT_EQ(sums.complete_blocks(), 48U);  // of 2048 = 2^11 each
}

TEST(BlockSums, spreads_evenly) {
  BlockSums<1> sums(1.0);
  sums.spread(0.5, 40.25, {39.75});  // a density of 1 a block
  sums.end(40.25);
  // Leaving out block 0 takes away 0.5, any other block 1: f is 39.25, or 38.75 for 39 of the 40 complete blocks.
  // s.e. = sqrt(39/40 sum (f_k - mean)^2), sum = 0.25 (1/40) (39/40) 40
  const Estimate e = sums.estimate("x", [](const auto& s) { return s[0]; });
  EXPECT_DOUBLE_EQ(e.value, 39.75);
  EXPECT_EQ(sums.complete_blocks(), 40U);
  EXPECT_NEAR(e.error, std::sqrt(39.0 / 40 * 0.25 * 39 / 40), 1e-12);
}

TEST(BlockSums, spread_over_more_than_all_blocks_makes_room_first) {
  BlockSums<2> sums(0x1p-20);
  sums.spread(0, 1e6, {1e6, 3e6});
  sums.end(1e6);
  EXPECT_GE(sums.complete_blocks(), 32U);
  const Estimate e = sums.estimate("x", mean);
  EXPECT_DOUBLE_EQ(e.value, 3.0);
  EXPECT_LT(e.error, 1e-14);
}

TEST(BlockSums, has_no_error_without_two_blocks) {
  BlockSums<2> sums(1.0);
  sums.add(0.5, {1, 2});
  sums.end(1.5);
  EXPECT_EQ(sums.estimate("x", mean).value, 2.0);
  EXPECT_TRUE(std::isnan(sums.estimate("x", mean).error));
}

TEST(BlockSums, of_a_mean_is_the_standard_error_of_block_averages) {
  BlockSums<2> sums(1.0);
  const double x[] = {3, 1, 4, 1, 5, 9, 2, 6};
  double squares = 0;
  for (int k = 0; k < 8; ++k) {
    sums.add(k, {1, x[k]});
    squares += (x[k] - 31.0 / 8) * (x[k] - 31.0 / 8);
  }
  sums.end(8);
  EXPECT_NEAR(sums.estimate("x", mean).error, std::sqrt(squares / (8 * 7)), 1e-14);
}

// A chain x_{i+1} = rho x_i + sqrt(1 - rho^2) g_i has variance 1 and a mean over n steps of variance
// (1/n) (1 + rho) / (1 - rho) for n >> 1/(1 - rho). The mean square of (value / stated error) over many chains is then that
// of Student's t with n_b - 1 = 47 degrees of freedom, 47/45, with a scatter of sqrt(2/400) or 7 %; and the stated error
// squared has the mean given. The error of independent data would be 4.4 times too small.
TEST(BlockSums, errors_are_right_for_correlated_data) {
  constexpr double rho = 0.9;
  constexpr int steps = 48 * 512, chains = 400;
  double scores = 0, stated = 0;
  for (int chain = 0; chain < chains; ++chain) {
    RandomStream random(1989, static_cast<std::uint64_t>(chain));
    BlockSums<2> sums(1.0);
    double x = random.normal();
    for (int i = 0; i < steps; ++i) {
      x = rho * x + std::sqrt(1 - rho * rho) * random.normal();
      sums.add(i, {1, x});
    }
    sums.end(steps);
    ASSERT_EQ(sums.complete_blocks(), 48U);
    const Estimate e = sums.estimate("x", mean);
    scores += e.value * e.value / (e.error * e.error) / chains;
    stated += e.error * e.error / chains;
  }
  EXPECT_NEAR(scores, 47.0 / 45, 4 * 0.07);
  EXPECT_NEAR(stated / ((1 + rho) / (1 - rho) / steps), 1.0, 0.06);  // blocks of 512 steps lose 2 %
}

// A ratio of two fluctuating sums, and a square: functions that are not linear. With y of mean 2, x = 3 y + noise, the
// ratio's error is that of the noise alone, sigma / (2 sqrt(n)); that of ybar^2 is 2 ybar sigma_y / sqrt(n).
TEST(BlockSums, errors_of_functions_follow_them) {
  constexpr int steps = 48 * 256, chains = 100;
  double ratio = 0, square = 0;
  for (int chain = 0; chain < chains; ++chain) {
    RandomStream random(1982, static_cast<std::uint64_t>(chain));
    BlockSums<3> sums(1.0);
    for (int i = 0; i < steps; ++i) {
      const double y = 2 + 0.5 * random.normal();
      sums.add(i, {1, y, 3 * y + 0.1 * random.normal()});
    }
    sums.end(steps);
    ratio += sums.estimate("r", [](const auto& s) { return s[2] / s[1]; }).error / chains;
    square += sums.estimate("s", [](const auto& s) { return s[1] * s[1] / (s[0] * s[0]); }).error / chains;
  }
  EXPECT_NEAR(ratio / (0.1 / (2 * std::sqrt(steps))), 1.0, 0.05);
  EXPECT_NEAR(square / (2 * 2 * 0.5 / std::sqrt(steps)), 1.0, 0.05);
}

}  // namespace
}  // namespace carom
