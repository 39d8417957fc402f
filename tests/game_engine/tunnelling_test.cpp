// What is fast: through, or stopped, or slowed down. And what is slow.

#include <cmath>

#include "engine_runs.hpp"

namespace carom {
namespace {

using test::EngineRun;
using test::run_engine;

// Diameter 1, each ball moves by 1.9 in a step: between two steps they go from a gap of 1.1 to being 2.7 past each other.
const std::string fast_pair = R"(
  run.until = 1
  [[ball]]
  position = [-10, 0]
  velocity = [95, 0]
  [[ball]]
  position = [11.1, 0]
  velocity = [-95, 0])";
constexpr double dt = 0.02;
constexpr int steps = 20;

class Fast : public test::EachEngine {};
INSTANTIATE_TEST_SUITE_P(Engines, Fast, testing::ValuesIn(test::built_engines()), [](const auto& e) { return e.param; });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Fast);

TEST_P(Fast, pair_tunnels) {
  const EngineRun run = run_engine(engine(), fast_pair, dt, steps);
  EXPECT_TRUE(run.contacts.empty());
  EXPECT_NEAR(run.balls[0].position[0], -10 + 95 * 0.4, 1e-4);
  EXPECT_NEAR(run.balls[1].velocity[0], -95, 1e-4);
}

// Exact: they touch after 20.1 / 190 and exchange their velocities. Box2D is 0.010 off: it lets them overlap by 0.015 m.
TEST(FastBox2D, bullets_collide_in_the_open) {
  CAROM_SKIP_UNLESS_BUILT("box2d");
  const EngineRun run = run_engine("box2d:continuous", fast_pair, dt, steps);
  EXPECT_EQ(run.collisions.size(), 1U);
  EXPECT_NEAR(run.balls[0].velocity[0], -95, 1e-3);
  EXPECT_NEAR(run.balls[1].velocity[0], 95, 1e-3);
  EXPECT_NEAR(run.balls[0].position[0], -10 + 95 * (2 * 20.1 / 190 - 0.4), 0.02);
}

// Bullet sees them, but takes a contact that it predicts for plastic: 95 becomes 35.
TEST(FastBullet, pair_is_stopped_and_loses_speed) {
  CAROM_SKIP_UNLESS_BUILT("bullet");
  const EngineRun run = run_engine("bullet:continuous", fast_pair, dt, steps);
  EXPECT_EQ(run.collisions.size(), 1U);
  EXPECT_LT(run.balls[0].position[0], run.balls[1].position[0]);
  EXPECT_NEAR(run.balls[0].velocity[0], -35, 1);
  EXPECT_NEAR(run.balls[1].velocity[0], 35, 1);
}

const std::string fast_at_wall = R"(
  run.until = 1
  space = { kind = "box", lower = [0, -50], upper = [10, 50] }
  [[ball]]
  position = [5, 0]
  velocity = [90, 0])";

// 4 a step, from 9 to 13, beyond a face at 10 that is as thick as a ball.
TEST(FastChipmunk, goes_through_a_face) {
  CAROM_SKIP_UNLESS_BUILT("chipmunk");
  const std::string faster = R"(
    run.until = 1
    space = { kind = "box", lower = [0, -50], upper = [10, 50] }
    [[ball]]
    position = [5, 0]
    velocity = [400, 0])";
  EXPECT_NEAR(run_engine("chipmunk", faster, 0.01, 10).balls[0].position[0], 45, 1e-9);
}

TEST(FastBox2D, stays_in_the_box) {
  CAROM_SKIP_UNLESS_BUILT("box2d");
  const EngineRun run = run_engine("box2d", fast_at_wall, dt, 100);
  EXPECT_GT(run.collisions.size(), 15U);
  EXPECT_GT(run.balls[0].position[0], 0.4);
  EXPECT_LT(run.balls[0].position[0], 9.6);
  EXPECT_NEAR(std::abs(run.balls[0].velocity[0]), 90, 1e-3);
}

// At most 2 m a step: 2 / 0.01 = 200 m/s, for good.
TEST(FastBox2D, is_slowed_down_for_good) {
  CAROM_SKIP_UNLESS_BUILT("box2d");
  const EngineRun run = run_engine("box2d", R"(
    run.until = 1
    [[ball]]
    position = [0, 0]
    velocity = [1000, 0])",
                                   0.01, 10);
  EXPECT_NEAR(run.balls[0].velocity[0], 200, 1e-3);
  EXPECT_NEAR(run.balls[0].position[0], 20, 1e-4);
}

// Balls that touch, and approach at 0.5: below Box2D's 1 m/s, above Bullet's 0.2.
TEST(Slow, impacts_do_not_bounce_in_box2d) {
  CAROM_SKIP_UNLESS_BUILT("box2d");
  const std::string scene = R"(
    run.until = 1
    [[ball]]
    position = [0, 0]
    velocity = [0.5, 0]
    [[ball]]
    position = [1, 0])";
  EXPECT_NEAR(run_engine("box2d", scene, dt, 5).balls[1].velocity[0], 0.25, 1e-5);
  EXPECT_NEAR(run_engine("box2d:threshold=0", scene, dt, 5).balls[1].velocity[0], 0.5, 1e-5);
  EXPECT_NEAR(run_engine("box2d:threshold=0.6", scene, dt, 5).balls[1].velocity[0], 0.25, 1e-5);
  if (test::built("chipmunk")) {
    EXPECT_NEAR(run_engine("chipmunk", scene, dt, 5).balls[1].velocity[0], 0.5, 1e-5);
  }
  if (test::built("bullet")) {
    EXPECT_NEAR(run_engine("bullet", scene, dt, 5).balls[1].velocity[0], 0.5, 1e-5);
    EXPECT_NEAR(run_engine("bullet:threshold=0.6", scene, dt, 5).balls[1].velocity[0], 0.25, 1e-5);
  }
}

// In free flight, below 0.8 m/s for 2 s (Bullet) or 0.01 m/s for 0.5 s (Box2D).
TEST(Slow, balls_fall_asleep) {
  const auto free_flight = [](const std::string& engine, const std::string& speed) {
    return run_engine(engine, "run.until = 1\n[[ball]]\nposition = [0, 0]\nvelocity = [" + speed + ", 0]\n", 0.01, 400)
        .balls[0]
        .position[0];
  };
  if (test::built("bullet")) {
    EXPECT_NEAR(free_flight("bullet", "0.5"), 1, 0.02);
    EXPECT_NEAR(free_flight("bullet:awake", "0.5"), 2, 1e-5);
    EXPECT_NEAR(free_flight("bullet", "0.9"), 3.6, 1e-5);
  }
  if (test::built("box2d")) {
    EXPECT_NEAR(free_flight("box2d", "0.008"), 0.004, 2e-4);
    EXPECT_NEAR(free_flight("box2d:awake", "0.008"), 0.032, 1e-5);
    EXPECT_NEAR(free_flight("box2d", "0.02"), 0.08, 1e-5);
  }
  if (test::built("chipmunk")) {
    EXPECT_NEAR(free_flight("chipmunk", "1e-6"), 4e-6, 1e-12);
  }
}

}  // namespace
}  // namespace carom
