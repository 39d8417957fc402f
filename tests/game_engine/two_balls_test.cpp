// Two balls that meet in an engine, against the formulas of an impact. Impacts of 1 m/s and more in the engine's units.

#include <cmath>

#include "engine_runs.hpp"

namespace carom {
namespace {

using test::EngineRun;
using test::run_engine;

class TwoBalls : public test::EachEngine {};
INSTANTIATE_TEST_SUITE_P(Engines, TwoBalls, testing::ValuesIn(test::built_engines()),
                         [](const auto& e) { return e.param; });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(TwoBalls);

constexpr double frame = 1.0 / 60;

// Equal masses, e = 1: they exchange velocities. Impulse m (u1 - u2) = 5. All three engines: to the last bit of a float.
TEST_P(TwoBalls, exchange_velocities_head_on) {
  const EngineRun run = run_engine(engine(), R"(
    run.until = 1
    [[ball]]
    name = "left"
    position = [0, 0]
    velocity = [2, 0]
    [[ball]]
    position = [3, 0]
    velocity = [-3, 0])",
                                   frame, 60);
  EXPECT_NEAR(run.balls[0].velocity[0], -3, 1e-6);
  EXPECT_NEAR(run.balls[1].velocity[0], 2, 1e-6);
  EXPECT_EQ(run.balls[0].velocity[1], 0);
  // The impact is found up to a step late, and acts in the next: each is off by at most (2 + 3) dt.
  EXPECT_NEAR(run.balls[0].position[0], 2 * 0.4 - 3 * 0.6, 5 * frame);
  ASSERT_EQ(run.collisions.size(), 1U);
  const StepContact& hit = run.collisions[0];
  EXPECT_EQ(hit.kind, EventKind::ball_ball);
  EXPECT_EQ(hit.ball, 0U);
  EXPECT_EQ(hit.partner, 1U);
  EXPECT_NEAR(hit.impulse, 5, 1e-5);
  EXPECT_NEAR(hit.time, 0.4, 2.5 * frame);
  EXPECT_NEAR(hit.time, static_cast<double>(hit.step) * frame, 1e-12);
  EXPECT_LE(hit.overlap, 5 * frame);
  EXPECT_EQ(run.balls[0].name, "left");
  EXPECT_EQ(test::doubles(run.balls[0].unwrapped_position), test::doubles(run.balls[0].position));
  EXPECT_EQ(run.balls[1].image, (std::vector<std::int64_t>{0, 0}));
}

// v1' = v1 - (1 + e) m2 / (m1 + m2) (v1 - v2), the materials' pair above the product of their values (0.72).
// The balls start in contact, so that no overlap is to be taken back.
TEST_P(TwoBalls, have_the_restitution_of_their_pair) {
  const EngineRun run = run_engine(engine(), R"(
    run.until = 1
    [material.ivory]
    restitution = 0.9
    [material.rubber]
    restitution = 0.8
    [[material_pair]]
    of = ["ivory", "rubber"]
    restitution = 0.25
    [[ball]]
    position = [0, 0]
    velocity = [4, 0]
    material = "ivory"
    [[ball]]
    position = [1, 0]
    velocity = [-4, 0]
    mass = 3
    material = "rubber")",
                                   frame, 2);
  EXPECT_NEAR(run.balls[0].velocity[0], 4 - 1.25 * 0.75 * 8, 1e-5);
  EXPECT_NEAR(run.balls[1].velocity[0], -4 + 1.25 * 0.25 * 8, 1e-5);
}

// The impulse is along the line of centres, and a smooth ball does not spin: the other components stay.
// Line of centres (0.8, 0.6): ball 0 gives the other its component 5 * 0.8 along it. Chipmunk moves before it looks: the
// line has turned by 5 dt then.
TEST_P(TwoBalls, keep_what_is_tangential) {
  const EngineRun run = run_engine(engine(), R"(
    run.until = 1
    [[ball]]
    position = [0, 0]
    velocity = [5, 0]
    [[ball]]
    position = [0.8, 0.6])",
                                   1e-4, 3);
  EXPECT_NEAR(run.balls[1].velocity[0], 4 * 0.8, 2e-3);
  EXPECT_NEAR(run.balls[1].velocity[1], 4 * 0.6, 2e-3);
  EXPECT_NEAR(run.balls[0].velocity[0], 5 - 4 * 0.8, 2e-3);
  EXPECT_NEAR(run.balls[0].velocity[1], -4 * 0.6, 2e-3);
}

// A ball of infinite mass and speed 5 pushes one at rest to twice its speed, keeps its own and follows its parabola; a
// fixed one stays. Bullet takes back part of the overlap by speed, up to 0.2 of the overlap a step: 0.2 * 5 here.
TEST_P(TwoBalls, of_infinite_mass_are_not_moved_by_others) {
  const std::string scene = R"(
    run.until = 1
    [[ball]]
    position = [-3, 0]
    velocity = [5, 0]
    mass = "inf"
    [[ball]]
    position = [0, 0]
    [[ball]]
    position = [20, 0]
    fixed = true)";
  const EngineRun run = run_engine(engine(), scene, 0.01, 100);
  EXPECT_NEAR(run.balls[0].velocity[0], 5, 1e-6);
  EXPECT_NEAR(run.balls[0].position[0], 2, 1e-5);
  EXPECT_NEAR(run.balls[1].velocity[0], 10, engine() == "bullet" ? 1.01 : 1e-5);
  EXPECT_EQ(test::doubles(run.balls[2].position), (std::vector{20.0, 0.0}));
  EXPECT_TRUE(std::isinf(run.balls[2].mass));

  const EngineRun fall = run_engine(engine(), scene + "\n[motion]\nacceleration = [2, -4]\n", 0.01, 50);
  EXPECT_NEAR(fall.balls[0].position[0], -3 + 5 * 0.5 + 0.25, 1e-5);
  EXPECT_NEAR(fall.balls[0].position[1], -0.5, 1e-5);
  EXPECT_NEAR(fall.balls[0].velocity[1], -2, 1e-6);
  EXPECT_EQ(test::doubles(fall.balls[2].position), (std::vector{20.0, 0.0}));
}

// Steps of 1/256 at speed 4 end with an overlap of 1/128: the bounce is faster by 0.2 (1/128) 256 = 0.4, shared by both.
TEST(BulletPair, is_driven_apart_by_its_overlap) {
  CAROM_SKIP_UNLESS_BUILT("bullet");
  const EngineRun run = run_engine("bullet", R"(
    run.until = 1
    [[ball]]
    position = [0, 0]
    velocity = [4, 0]
    [[ball]]
    position = [2.5078125, 0])",
                                   1.0 / 256, 128);
  EXPECT_EQ(run.collisions.at(0).overlap, 1.0 / 128);
  EXPECT_NEAR(run.balls[0].velocity[0], -0.2, 1e-5);
  EXPECT_NEAR(run.balls[1].velocity[0], 4.2, 1e-5);
}

// Ten balls run into one another in the open: the sum of m v stays. Errors seen, of sum m |v|: 4e-8 in Bullet, 2e-8
// in Box2D, none in Chipmunk.
TEST_P(TwoBalls, and_more_keep_momentum) {
  std::string scene = "run.until = 1\n";
  double px = 0.0, size = 0.0;
  for (int k = 0; k < 10; ++k) {
    const int mass = 1 + k % 3, speed = k % 2 == 0 ? 4 : -5;
    scene += "[[ball]]\nposition = [" + std::to_string(1.4 * k) + ", " + std::to_string(0.1 * (k % 4)) +
             "]\nmass = " + std::to_string(mass) + "\nvelocity = [" + std::to_string(speed) + ", 0]\n";
    px += mass * speed;
    size += mass * std::abs(speed);
  }
  const EngineRun run = run_engine(engine(), scene, 0.005, 400);
  EXPECT_GE(run.collisions.size(), 9U);
  double x = 0.0, y = 0.0;
  for (const BallState& b : run.balls) {
    x += b.mass * b.velocity[0];
    y += b.mass * b.velocity[1];
  }
  EXPECT_NEAR(x, px, 1e-7 * size);
  EXPECT_NEAR(y, 0, 1e-7 * size);
}

// Lengths 2^-10 times as large, masses 2^20 times: the engine is given the same numbers, and the results are scaled bit for
// bit.
TEST_P(TwoBalls, do_not_feel_the_units_of_length_and_mass) {
  const EngineRun one = run_engine(engine(), R"(
    run.until = 1
    [[ball]]
    position = [0, 0]
    velocity = [4, 0.5]
    [[ball]]
    position = [2, 0.25]
    radius = 0.75)",
                                   frame, 40);
  const EngineRun other = run_engine(engine(), R"(
    run.until = 1
    [[ball]]
    position = [0, 0]
    velocity = [0.00390625, 0.00048828125]
    radius = 0.00048828125
    mass = 1048576
    [[ball]]
    position = [0.001953125, 0.000244140625]
    radius = 0.000732421875
    mass = 1048576)",
                                     frame, 40);
  ASSERT_EQ(one.collisions.size(), 1U);
  ASSERT_EQ(other.collisions.size(), 1U);
  EXPECT_EQ(other.collisions[0].impulse, 0x1p10 * one.collisions[0].impulse);
  EXPECT_EQ(other.collisions[0].overlap, 0x1p-10 * one.collisions[0].overlap);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(other.balls[i].position[k], 0x1p-10 * one.balls[i].position[k]);
      EXPECT_EQ(other.balls[i].velocity[k], 0x1p-10 * one.balls[i].velocity[k]);
    }
}

// The clock begins where the scene says, and counts whole steps.
TEST_P(TwoBalls, are_on_the_clock_of_the_scene) {
  const EngineRun run = run_engine(engine(), R"(
    run = { start = 10, until = 20 }
    [[ball]]
    position = [0, 0]
    velocity = [1, 0])",
                                   0.125, 8);
  EXPECT_EQ(run.time, 11.0);
  EXPECT_EQ(run.balls[0].position[0], 1.0);
}

// What lies on the ground is one collision, then a contact without a new impulse. (In Box2D until it sleeps, after 0.5 s.)
TEST_P(TwoBalls, are_counted_once_while_they_touch) {
  const EngineRun run = run_engine(engine(), R"(
    run.until = 1
    collision.restitution = 0
    motion.acceleration = [0, -9.81]
    [[ball]]
    position = [0, 0]
    fixed = true
    [[ball]]
    position = [0, 1.5])",
                                   frame, 100);
  EXPECT_EQ(run.collisions.size(), 1U);
  EXPECT_GT(run.contacts.size(), 20U);
  EXPECT_NEAR(run.balls[1].position[1], 1, 0.02);
}

}  // namespace
}  // namespace carom
