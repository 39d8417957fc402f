// What counts as a collision, and what only lasts.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/fixed_step/stepping.hpp"

namespace carom {
namespace {

using namespace testing;

Scene ball_on_floor(double height, double e) {
  Scene scene = box({-5.0, 0.0}, {5.0, 10.0});
  scene.motion.acceleration = {0.0, -10.0};
  scene.collision.restitution = e;
  scene.balls = {ball({0.0, 0.5 + height}, {0.0, 0.0})};
  return scene;
}

// A plastic ball falls to the floor and lies there: one collision, however long it lies. Without correction it sinks by g
// dt^2 in every step; on a spring it lies g / omega^2 deep, omega = pi / (20 dt).
TEST(Counting, a_ball_that_comes_to_rest_collides_once) {
  for (const std::string& method : every_method) {
    const Stepped result = run_steps(ball_on_floor(1.0, 0.0), 0.01, method, 300);
    EXPECT_EQ(result.collisions(), 1) << method;
    const double depth = method == "discrete:correction=none" ? 10.0 * 1e-4 * 255
                         : method == "penalty"                ? 10.0 * std::pow(0.2 / M_PI, 2)
                                                              : 0.0;
    EXPECT_NEAR(result.balls[0].position[1], 0.5 - depth, 0.04) << method;
    EXPECT_NEAR(result.balls[0].velocity[1], 0.0, 0.11) << method;
  }
}

// Two balls that are pressed together by a third of the way they overlap stay one contact until they part.
TEST(Counting, a_contact_that_separates_slowly_is_one) {
  Scene scene = open_space(2);
  scene.collision.restitution = 0.1;
  scene.balls = {ball({-0.6, 0.0}, {1.0, 0.0}), ball({0.6, 0.0}, {-1.0, 0.0})};
  // Found 0.1 deep, they part at 0.2: for 5 steps of 0.1 they overlap, and only the first of them is a collision.
  const Stepped result = run_steps(scene, 0.15, "discrete:correction=none", 20);
  EXPECT_EQ(result.collisions(), 1);
  ASSERT_GE(result.contacts.size(), 3u);
  EXPECT_NEAR(result.contacts[0].overlap, 0.1, 1e-15);
  EXPECT_NEAR(result.contacts[0].impulse, 1.1, 1e-15);
  for (std::size_t k = 1; k < result.contacts.size(); ++k) {
    EXPECT_EQ(result.contacts[k].impulse, 0.0);
    EXPECT_EQ(result.contacts[k].step, result.contacts[k - 1].step + 1);
    EXPECT_LT(result.contacts[k].overlap, result.contacts[k - 1].overlap);
  }
}

// An elastic ball bounces as often as its height says: every 2 sqrt(2 h / g).
TEST(Counting, bounces_are_counted_one_by_one) {
  for (const std::string& method : every_method) {
    const Stepped result = run_steps(ball_on_floor(0.8, 1.0), 1e-3, method, 7400);  // at 0.4, then every 0.8
    EXPECT_NEAR(double(result.collisions()), 9, method == "penalty" ? 1 : 0) << method;
  }
}

// Times are those of the steps' ends, but for what is swept.
TEST(Counting, times_and_steps) {
  Scene scene = open_space(1);
  scene.run.start = 100.0;
  scene.balls = {ball({-1.03125}, {1.0}), ball({0.5}, {0.0})};
  for (const std::string& method : every_method) {
    const Stepped result = run_steps(scene, 0.125, method, 60);
    EXPECT_EQ(result.time, 107.5);
    ASSERT_EQ(result.collisions(), 1) << method;
    const StepContact& c =
        *std::find_if(result.contacts.begin(), result.contacts.end(), [](const StepContact& k) { return k.impulse > 0; });
    EXPECT_EQ(c.kind, EventKind::ball_ball);
    EXPECT_EQ(c.ball, 0u);
    EXPECT_EQ(c.partner, 1u);
    EXPECT_NEAR(c.impulse, 1.0, method == "penalty" ? 0.1 : 1e-14) << method;
    if (method == "penalty") continue;  // told at its end
    EXPECT_EQ(c.step, 5) << method;     // the gap of 17/32 closes in step 5
    EXPECT_NEAR(c.time, method.starts_with("swept") ? 100.53125 : 100.625, 1e-13) << method;
  }
}

}  // namespace
}  // namespace carom
