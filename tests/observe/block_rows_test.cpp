// Rows of sums in blocks, and curves over lags.

#include "carom/observe/block_rows.hpp"

#include <random>

#include <gtest/gtest.h>

#include "carom/observe/origins.hpp"

namespace carom {
namespace {

// The mean of n independent numbers of variance 1 has the error 1/sqrt(n), however often blocks were joined; the estimate of
// it from 32 to 64 blocks is good to 1/sqrt(2 * 32) = 13 %.
TEST(BlockRows, give_the_error_of_a_mean) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(2.0, 1.0);
  for (const int n : {64, 1000, 50000}) {
    BlockRows rows(2);
    double sum = 0;
    for (int i = 0; i < n; ++i) {
      const double x = normal(random);
      sum += x;
      const auto row = rows.row(static_cast<std::size_t>(i));
      row[0] += x;
      row[1] += 1;
    }
    const Estimate mean = rows.estimate("mean", [](BlockRows::Row row) { return row[0] / row[1]; });
    EXPECT_EQ(mean.name, "mean");
    EXPECT_NEAR(mean.value, sum / n, 1e-12);
    EXPECT_NEAR(mean.error * std::sqrt(n), 1.0, 0.4) << n;
    EXPECT_EQ(rows.total()[1], n);
  }
}

TEST(BlockRows, of_one_unit_have_no_error) {
  BlockRows rows(1);
  rows.row(0)[0] = 3;
  const Estimate e = rows.estimate("x", [](BlockRows::Row row) { return row[0]; });
  EXPECT_EQ(e.value, 3);
  EXPECT_TRUE(std::isnan(e.error));
}

// Each origin sees each lag once, from 0 to the last, and no slot is given away before.
TEST(Origins, see_every_lag_once) {
  for (const std::size_t count : {1u, 3u, 10u, 11u}) {
    constexpr std::size_t lags = 10;
    Origins origins(lags, count);
    std::vector<std::vector<std::size_t>> seen(100);
    for (std::size_t s = 0; s < 100; ++s)
      origins.sample({{static_cast<double>(s), 0, 0}}, [&](const Origins::Origin& o, std::size_t lag) {
        EXPECT_EQ(o.value[0][0], static_cast<double>(s - lag));
        seen[o.number].push_back(lag);
      });
    const std::size_t complete = 89 / ((lags + count) / count) + 1;  // made at sample 89 or before
    for (std::size_t o = 0; o < complete; ++o) {
      ASSERT_EQ(seen[o].size(), lags + 1) << count << " origins, number " << o;
      for (std::size_t lag = 0; lag <= lags; ++lag) EXPECT_EQ(seen[o][lag], lag);
    }
  }
}

}  // namespace
}  // namespace carom
