// Starting in exact contact: closing acts at once, separating and resting never. Pairs of equal balls are in
// tests/sim/contact_test.cpp (TouchingPair); here: unequal ones, more than two, gravity, restitution, through a period.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

// A ball in the middle of others that touch it on all sides, in every dimension: kicked, it hits those before it, at t = 0,
// and none of those behind it.
TEST(StartInContact, of_one_ball_with_many) {
  for (int d = 1; d <= 3; ++d) {
    Scene scene = open_space(d);
    Coordinates x(std::size_t(d), 0.0), v(std::size_t(d), 0.0);
    v[0] = 1.0;
    scene.balls.push_back(ball(x, v, 0.75));
    for (int k = 0; k < d; ++k)
      for (const double sign : {1.0, -1.0}) {
        x[std::size_t(k)] = sign;
        scene.balls.push_back(ball(x, {}, 0.25, 3.0));
        x[std::size_t(k)] = 0.0;
      }
    const Result result = watched_run(scene, {});
    ASSERT_GE(result.log.size(), 1u);
    EXPECT_EQ(result.log[0].time, 0.0);
    EXPECT_EQ(result.log[0].partner.number, 1u) << "the one before it";
    // u' = (1 - 3) / (1 + 3): it comes back, and hits the one behind it, which touches it.
    ASSERT_EQ(result.log.size(), 2u) << d << "-D";
    EXPECT_EQ(result.log[1].time, 0.0);
    EXPECT_EQ(result.log[1].partner.number, 2u);
    EXPECT_EQ(result.balls[1].velocity[0], 0.5);
    EXPECT_EQ(result.balls[2].velocity[0], -0.25);
    EXPECT_EQ(result.balls[0].velocity[0], 0.25);
  }
}

// Through a period: a row that fills a ring but for one gap.
TEST(StartInContact, through_a_period) {
  Scene scene = open_space(2);
  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {0.0, 0.0};
  scene.space.upper = {4.0, 10.0};
  scene.balls = {ball({0.5, 5.0}, {-1.0, 0.0}), ball({3.5, 5.0}, {0.0, 0.0})};
  const Result result = watched_run(scene, {.events = 1});
  ASSERT_EQ(result.log.size(), 1u);
  EXPECT_EQ(result.log[0].time, 0.0) << "they touch across the edge";
  EXPECT_EQ(result.balls[1].velocity[0], -1.0);
}

// Two balls at rest in a heap that falls; and a ball held from below by a fixed one: pressed for ever, and named.
TEST(StartInContact, under_gravity) {
  Scene scene = open_space(2);
  scene.motion.acceleration = {0.0, -1.0};
  scene.balls = {ball({0.0, 0.0}, {}), ball({0.0, 1.0}, {})};
  EXPECT_TRUE(watched_run(scene, {.until = 50.0}).log.empty());
  scene.balls[0].fixed = true;
  const Result pressed = watched_run(scene, {.events = 10'000});
  EXPECT_EQ(pressed.stop, Stop::collapse);
  scene.balls[1].velocity = {0.0, 1.0};
  const Result thrown = watched_run(scene, {.events = 3});
  ASSERT_EQ(thrown.log.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(thrown.log[i].time, 2.0 * double(i + 1), 1e-14);
}

// On top of a fixed ball, pushed aside: it leaves the surface at once if v^2 > g (r + R), and else rolls off along it: with
// no rest state that is a contact that never ends.
TEST(StartInContact, leaves_a_dome_if_fast_enough) {
  for (const double v : {1.01, 2.0, 0.5}) {
    Scene scene = open_space(2);
    scene.motion.acceleration = {0.0, -1.0};
    scene.balls = {fixed_ball({0.0, 0.0}), ball({0.0, 1.0}, {v, 0.0})};
    const Result result = watched_run(scene, {.events = 10'000, .until = 5.0});
    if (v > 1.0) {
      EXPECT_TRUE(result.log.empty()) << v;
    } else {
      EXPECT_EQ(result.stop, Stop::collapse) << v;
    }
  }
}

// A granular row of touching balls is hit: any restitution ends, and the balls separate or move as one.
TEST(StartInContact, of_a_granular_row) {
  for (const double e : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    Scene scene = open_space(1);
    scene.collision.restitution = e;
    for (int i = 0; i < 8; ++i) scene.balls.push_back(ball({double(i)}, {i == 0 ? 1.0 : 0.0}, 0.5, 1.0 + i % 3));
    const Result result = watched_run(scene, {.events = 200'000, .until = 10.0, .stride = 1000});
    EXPECT_NE(result.stop, Stop::events) << e;
    EXPECT_LE(result.summary.momentum.relative_error.value(), 1e-13);
  }
}

}  // namespace
}  // namespace carom
