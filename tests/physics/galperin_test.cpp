// Galperin's billiard: a heavy ball pushes a light one against a wall, and the collisions count the digits of pi.
//
// Wall at x = 0, light ball m at rest at Y0, heavy ball M = m q at X0 > Y0 with velocity -V0. With theta = arctan sqrt(m/M)
// the number of collisions is ceil(pi / theta) - 1 [Galperin2003]. After k ball-ball hits the velocities are
//   u = -V0 cos 2 k theta,   |v| = V0 sqrt(M/m) |sin 2 k theta|.
// At every moment M x^2 + m y^2 = M (X0 - V0 t)^2 + m Y0^2: in the plane of (sqrt(M) x, sqrt(m) y) the pair moves on a
// straight line that the mirrors of a wedge of angle theta fold, and its distance from the corner does not see the folds.

#include <gtest/gtest.h>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

constexpr double X0 = 2.0, Y0 = 1.0, V0 = 1.0;

Scene galperin(double ratio) {
  Scene scene = open_space(1);
  scene.walls.push_back(plane({0.0}, {1.0}));
  scene.balls.push_back(ball({Y0}, {0.0}, 0.0, 1.0));
  scene.balls.push_back(ball({X0}, {-V0}, 0.0, ratio));
  return scene;
}

struct Finals {
  double ratio;
  std::int64_t count;
  double u, v;
};

class Galperin : public ::testing::TestWithParam<Finals> {};

TEST_P(Galperin, counts_the_digits_of_pi_and_ends_with_the_closed_form) {
  const Finals expected = GetParam();
  Simulation simulation(galperin(expected.ratio));
  EXPECT_EQ(simulation.advance(std::nullopt), Stop::no_events_left);
  EXPECT_EQ(simulation.counts().collisions(), expected.count);
  EXPECT_EQ(simulation.counts().ball_ball, (expected.count + 1) / 2);
  EXPECT_NEAR(simulation.ball(1).velocity[0], expected.u, 1e-9);
  EXPECT_NEAR(simulation.ball(0).velocity[0], expected.v, 1e-6);
  EXPECT_LE(simulation.summary().energy.relative_error, 5e-13);
  EXPECT_EQ(simulation.summary().exactness.clamped, 0);
}

// 1 and 3: pi / theta is an integer (4 and 6); the last collision would be a grazing one, which is none.
INSTANTIATE_TEST_SUITE_P(MassRatio, Galperin,
                         ::testing::Values(Finals{1.0, 3, 1.0, 0.0}, Finals{3.0, 5, 1.0, 0.0},
                                           Finals{1e2, 31, 0.998857595563118, 0.477860208205886},
                                           Finals{1e4, 314, 0.999998559562978, 0.169731316195040},
                                           Finals{1e6, 3141, 0.999999917460531, 0.406299066323258},
                                           Finals{1e8, 31415, 0.999999999973092, 0.0733593820675857}));

// |v| and u from the angle in long double: 2 k theta is about pi, so its rounding moves v by sqrt(M/m) 1e-19.
void expect_closed_form(int n, std::int64_t count) {
  const double ratio = std::pow(10.0, 2 * n);
  Simulation simulation(galperin(ratio));
  EXPECT_EQ(simulation.advance(std::nullopt), Stop::no_events_left);
  EXPECT_EQ(simulation.counts().collisions(), count);
  const long double theta = std::atan(1.0L / std::pow(10.0L, n));
  const long double angle = 2 * ((count + 1) / 2) * theta;
  EXPECT_NEAR(simulation.ball(1).velocity[0], static_cast<double>(-std::cos(angle)), 1e-9);
  EXPECT_NEAR(simulation.ball(0).velocity[0], static_cast<double>(std::pow(10.0L, n) * std::abs(std::sin(angle))), 1e-4);
  EXPECT_LE(simulation.summary().energy.relative_error, 5e-13);
  EXPECT_EQ(simulation.summary().exactness.clamped, 0);
}

TEST(GalperinLong, mass_ratio_1e10) { expect_closed_form(5, 314159); }

TEST(GalperinLong, mass_ratio_1e12) {
  if (scaled_count(100) < 100) GTEST_SKIP() << "three million collisions: in an optimised build only";
  expect_closed_form(6, 3141592);
}

TEST(GalperinInvariant, the_distance_from_the_corner_is_that_of_the_unfolded_line) {
  for (const double ratio : {1.0, 3.0, 1e2, 1e4, 1e6, 1e8}) {
    Simulation simulation(galperin(ratio));
    double x = X0, u = -V0, t = 0.0, worst = 0.0;
    simulation.advance(std::nullopt, std::nullopt, [&](const Collision& c) {
      x += u * (c.time - t);
      t = c.time;
      if (c.kind == EventKind::ball_ball) {
        x = c.partner.position[0];
        u = c.partner.velocity_after[0];
      }
      const double y = c.ball.position[0];
      const double line = ratio * (X0 - V0 * t) * (X0 - V0 * t) + Y0 * Y0;
      worst = std::max(worst, std::abs(ratio * x * x + y * y - line) / line);
    });
    EXPECT_LE(worst, 1e-9) << "mass ratio " << ratio;
  }
}

// The count does not depend on where the balls start, nor on the unit of anything.
TEST(Galperin, counts_the_same_from_anywhere) {
  Dice dice(7);
  for (int i = 0; i < 20; ++i) {
    Scene scene = open_space(1);
    const double scale = std::exp(dice.between(-30.0, 30.0)), mass = std::exp(dice.between(-30.0, 30.0));
    const double speed = std::exp(dice.between(-30.0, 30.0)), y = dice.between(0.1, 1.0);
    scene.walls.push_back(plane({0.0}, {3.0}));
    scene.balls.push_back(ball({y * scale}, {0.0}, 0.0, mass));
    scene.balls.push_back(ball({(y + dice.between(0.1, 3.0)) * scale}, {-speed}, 0.0, 1e4 * mass));
    const Result result = run(scene, 1000);
    EXPECT_EQ(result.stop, Stop::no_events_left);
    EXPECT_EQ(result.log.size(), 314u) << i;
  }
}

// Wall behind the rods' ends: lengths shift the balls, and nothing else.
TEST(Galperin, counts_the_same_with_rods) {
  Scene scene = open_space(1);
  scene.walls.push_back(plane({-1.0}, {1.0}));
  scene.balls.push_back(ball({1.0}, {0.0}, 0.3, 1.0));
  scene.balls.push_back(ball({2.5}, {-1.0}, 0.7, 1e6));
  const Result result = run(scene, 10000);
  EXPECT_EQ(result.stop, Stop::no_events_left);
  EXPECT_EQ(result.log.size(), 3141u);
}

}  // namespace
}  // namespace carom
