// Row 11: what is of which order. A ball that falls on a fixed one meets it at the root of a quartic, two that fall
// together at that of a quadratic, and coefficients vanish: at rest, at right angles, straight above. The order of the
// polynomial is that of the coefficients that are there. Each case against its closed form.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

Scene falling(double g, BallSpec a, BallSpec b) {
  Scene scene = open_space(2);
  scene.motion.acceleration = {0.0, -g};
  scene.balls = {std::move(a), std::move(b)};
  return scene;
}

double first_time(const Scene& scene) {
  const Result result = watched_run(scene, {.events = 1, .until = 100.0});
  return result.log.empty() ? -1.0 : result.log[0].time;
}

// Both fall: only their relative velocity counts, whatever g is.
TEST(EqualAccelerations, cancel) {
  for (const double g : {1e-9, 1.0, 9.81, 1e9}) {
    EXPECT_DOUBLE_EQ(first_time(falling(g, ball({0.0, 0.0}, {1.0, 0.0}), ball({3.0, 0.0}, {0.0, 0.0}))), 2.0);
    EXPECT_DOUBLE_EQ(first_time(falling(g, ball({0.0, 0.0}, {0.0, 4.0}), ball({0.0, 3.0}, {0.0, 0.0}))), 0.5);
    EXPECT_EQ(first_time(falling(g, ball({0.0, 0.0}, {0.0, 0.0}), ball({0.0, 3.0}, {0.0, 0.0}))), -1.0);
  }
}

// One is fixed. Dropped from rest: h - g t^2 / 2 = sigma. Thrown up first. Past it: never.
TEST(UnequalAccelerations, of_a_ball_dropped_on_a_fixed_one) {
  EXPECT_DOUBLE_EQ(first_time(falling(2.0, ball({0.0, 5.0}, {}), fixed_ball({0.0, 0.0}))), 2.0);
  EXPECT_DOUBLE_EQ(first_time(falling(2.0, ball({0.0, 1.0 + 3.0}, {0.0, 2.0}), fixed_ball({0.0, 0.0}))), 3.0);
  EXPECT_EQ(first_time(falling(2.0, ball({1.0, 5.0}, {}), fixed_ball({0.0, 0.0}))), -1.0) << "slides past, touching";
  EXPECT_GT(first_time(falling(2.0, ball({1.0 - 1e-9, 5.0}, {}), fixed_ball({0.0, 0.0}))), 2.0);
  EXPECT_EQ(first_time(falling(2.0, ball({0.0, -5.0}, {}), fixed_ball({0.0, 0.0}))), -1.0) << "below it";
}

// Thrown from below, straight up: h = v t - t^2 / 2 with v^2 = 2 h + 1 comes to h at t = v - 1.
TEST(UnequalAccelerations, of_a_ball_thrown_up_at_a_fixed_one) {
  EXPECT_DOUBLE_EQ(first_time(falling(1.0, ball({0.0, -5.0}, {0.0, 3.0}), fixed_ball({0.0, 0.0}))), 2.0);
  EXPECT_EQ(first_time(falling(1.0, ball({0.0, -6.0}, {0.0, 3.0}), fixed_ball({0.0, 0.0}))), -1.0) << "falls short";
}

// Thrown level, from a height of g / 2 t^2 above the line y = 0 at which it meets the fixed ball from its left at t = 2.
TEST(UnequalAccelerations, of_a_ball_thrown_level) {
  EXPECT_NEAR(first_time(falling(1.0, ball({-5.0, 2.0}, {2.0, 0.0}), fixed_ball({0.0, 0.0}))), 2.0, 1e-14);
}

// Hardly any acceleration: the quartic is nearly a quadratic, and the time that of free flight.
TEST(UnequalAccelerations, too_weak_to_matter) {
  for (const double g : {1e-90, 1e-50, 1e-20})
    EXPECT_DOUBLE_EQ(first_time(falling(g, ball({-3.0, 0.0}, {1.0, 0.0}), fixed_ball({0.0, 0.0}))), 2.0) << g;
}

// On a pillar for a thousand bounces: h = 1 above it, straight, a period of 2 sqrt(2 h / g).
TEST(UnequalAccelerations, of_a_ball_that_bounces_on_a_fixed_one) {
  for (int d = 1; d <= 3; ++d) {
    Scene scene = open_space(d);
    Coordinates x(std::size_t(d), 0.0), a(std::size_t(d), 0.0);
    scene.balls.push_back(fixed_ball(x));
    x.back() = 2.0;
    a.back() = -2.0;
    scene.balls.push_back(ball(x, {}));
    scene.motion.acceleration = a;
    const Result result = watched_run(scene, {.events = 1000, .stride = 3});
    ASSERT_EQ(result.log.size(), 1000u);
    EXPECT_NEAR(result.summary.time, 1999.0, 1e-9) << d << "-D";
  }
}

}  // namespace
}  // namespace carom
