// Shares of time at each speed, and how they compare with Maxwell's.

#include "carom/observe/speed_histogram.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "observe/maxwell.hpp"
#include "observe/measure.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using testing::measure;
using testing::Measured;

// c = sqrt(2/n) Gamma((n + 1)/2) / Gamma(n/2): sqrt(2/pi), sqrt(pi)/2, sqrt(8/(3 pi)); and c(n) c(n + 1) = sqrt(n / (n +
// 1)).
TEST(Maxwell, mean_length_ratio) {
  EXPECT_NEAR(mean_length_ratio(1), std::sqrt(2 / std::numbers::pi), 1e-15);
  EXPECT_NEAR(mean_length_ratio(2), std::sqrt(std::numbers::pi) / 2, 1e-15);
  EXPECT_NEAR(mean_length_ratio(3), std::sqrt(8 / (3 * std::numbers::pi)), 1e-15);
  for (double n = 1; n < 1e7; n *= 1.1)
    EXPECT_NEAR(mean_length_ratio(n) * mean_length_ratio(n + 1) / std::sqrt(n / (n + 1)), 1, 2e-11) << n;
}

// The derivative of the probability is the density: proportional to v^(d-1) exp(-v^2/2).
TEST(Maxwell, probabilities) {
  for (int d = 1; d <= 3; ++d) {
    const double norm[] = {std::sqrt(2 / std::numbers::pi), 1.0, std::sqrt(2 / std::numbers::pi)};
    EXPECT_EQ(maxwell_below(0, 1, d), 0);
    EXPECT_NEAR(maxwell_below(40, 1, d), 1, 1e-15);
    for (double v = 0.1; v < 5; v += 0.1) {
      const double density = norm[d - 1] * std::pow(v, d - 1) * std::exp(-v * v / 2), h = 1e-4;
      EXPECT_NEAR((maxwell_below(v + h, 1, d) - maxwell_below(v - h, 1, d)) / (2 * h), density, 1e-8);
      EXPECT_NEAR(maxwell_below(v, 1, d), maxwell_below(3 * v, 9, d), 1e-15);
    }
  }
}

// Speeds 1 and 3 for as long as no collision comes, then beyond the bins that the start suggests.
TEST(SpeedHistogram, widens_for_speeds_beyond_it) {
  Scene scene = testing::open_space(1);
  scene.balls = {testing::ball({0}, {1}), testing::ball({1e6}, {3})};
  scene.run.until = 10.0;
  scene.observe.speed_histogram = true;
  Measured m = measure(scene);
  EXPECT_EQ(m["speed_histogram.mean"], 2);
  EXPECT_EQ(m["speed_histogram.mean_square"], 5);
  ASSERT_TRUE(m.speeds);
  double total = 0;
  for (const SpeedBin& bin : *m.speeds) {
    total += bin.share;
    EXPECT_EQ(bin.share, (bin.from <= 1 && 1 < bin.to) || (bin.from <= 3 && 3 < bin.to) ? 0.5 : 0.0);
  }
  EXPECT_EQ(total, 1);

  // A drop from rest at the start: no speed to go by. Speed 100 s, s in 0..10.
  scene.balls.resize(1);
  scene.balls[0].velocity = {0.0};
  scene.motion.acceleration = {100.0};
  m = measure(scene);
  EXPECT_DOUBLE_EQ(m["speed_histogram.mean"], 500);
  for (const SpeedBin& bin : *m.speeds) EXPECT_NEAR(bin.share, (std::min(bin.to, 1000.0) - bin.from) / 1000, 1e-12);
}

}  // namespace
}  // namespace carom
