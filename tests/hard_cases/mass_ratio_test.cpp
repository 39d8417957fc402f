// Row 14: masses 1e-12 .. 1e12 apart, and infinite ones. Energy and momentum stay to rounding, the light ball bounces off
// the heavy one as off a wall. Ratios up to 1e12 against pi are in tests/physics/galperin_test.cpp.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

// u' = ((m - M) u + 2 M U) / (m + M) and likewise for U, head-on.
TEST(MassRatio, head_on_by_the_formula) {
  for (int d = 1; d <= 3; ++d)
    for (int power = -12; power <= 12; ++power) {
      const double m = 1.0, M = std::pow(10.0, power);
      Scene scene = open_space(d);
      Coordinates x(std::size_t(d), 0.0), v(std::size_t(d), 0.0);
      v[0] = 0.75;
      scene.balls.push_back(ball(x, v, 0.5, m));
      x[0] = 4.0;
      v[0] = -0.5;
      scene.balls.push_back(ball(x, v, 0.5, M));
      const Result result = watched_run(scene, {});
      ASSERT_EQ(result.log.size(), 1u);
      const long double sum = static_cast<long double>(m) + M;
      const double u = double(((m - static_cast<long double>(M)) * 0.75L + 2.0L * M * -0.5L) / sum);
      const double U = double(((static_cast<long double>(M) - m) * -0.5L + 2.0L * m * 0.75L) / sum);
      EXPECT_NEAR(result.balls[0].velocity[0], u, 1.2e-16 * 2) << "1e" << power;
      EXPECT_NEAR(result.balls[1].velocity[0], U, 1.2e-16 * 2) << "1e" << power;
      EXPECT_LE(result.summary.energy.relative_error, 4e-16);
      EXPECT_LE(result.summary.momentum.relative_error.value(), 4e-16);
    }
}

// A crowd of masses 1e-12 .. 1e12 in a box, in every dimension.
TEST(MassRatio, of_a_crowd) {
  for (int d = 1; d <= 3; ++d) {
    Scene scene = d == 1 ? rods(8, 141) : mixed_box(d, d == 2 ? 9 : 8, 8.0, 142);
    for (std::size_t i = 0; i < scene.balls.size(); ++i) scene.balls[i].mass = std::pow(10.0, -12.0 + 3.0 * double(i));
    const Result result = watched_run(scene, {.events = scaled_count(20'000), .stride = 97, .energy_error = 1e-13});
    EXPECT_EQ(result.stop, Stop::events) << d << "-D";
    EXPECT_LT(result.summary.exactness.max_gap_error, 1e-6);
  }
}

// The light balls move slowly at first and may grow fast: the clock must serve both. A heavy ball sweeps a light one along.
TEST(MassRatio, any_ratio_meets_in_time) {
  for (const int power : {0, 20, 40, 60, 80, 100, 200, 390}) {
    Scene scene = open_space(2);
    scene.balls = {ball({0.0, 0.0}, {1.0, 0.0}, 0.5, std::ldexp(1.0, power)), ball({1001.0, 0.0}, {}, 0.5, 1.0)};
    const Result result = watched_run(scene, {.until = 2000.0});
    ASSERT_EQ(result.log.size(), 1u) << "2^" << power;
    EXPECT_DOUBLE_EQ(result.log[0].time, 1000.0);
    EXPECT_LE(result.balls[1].velocity[0], 2.0);
    EXPECT_GE(result.balls[1].velocity[0], 1.0);
  }
}

// A piston of infinite mass gives 2 V to whatever it meets; m (u'^2 - u^2) / 2 is what it injects.
TEST(MassRatio, infinite) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double m : {1e-12, 1.0, 1e12}) {
    Scene scene = open_space(2);
    scene.balls = {ball({0.0, 0.0}, {0.5, 0.0}, 0.5, inf), ball({4.0, 0.0}, {-1.0, 0.0}, 0.5, m)};
    const Result result = watched_run(scene, {});
    ASSERT_EQ(result.log.size(), 1u);
    EXPECT_EQ(result.balls[1].velocity[0], 2.0);
    EXPECT_EQ(result.balls[0].velocity[0], 0.5);
    EXPECT_DOUBLE_EQ(result.summary.energy.injected, 0.5 * m * (4.0 - 1.0));
  }
}

}  // namespace
}  // namespace carom
