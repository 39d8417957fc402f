// Measurements of motions so simple that every number is known.

#include "carom/observe/observers.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "observe/measure.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using testing::ball;
using testing::measure;
using testing::Measured;

/// A rod of length 1 in a box of length 11, at speed 1: it hits a face at 5, 15, 25, ...
Scene shuttle(double until) {
  Scene scene = testing::box({0}, {11});
  scene.balls = {ball({5.5}, {1})};
  scene.run.until = until;
  scene.observe.collision_rate = scene.observe.mean_free_path = scene.observe.pressure = true;
  return scene;
}

// 10 hits in 100: rate 1/10, path 10 with the halves at both ends; each face takes 2 m v in 20, a force of 1/10. The
// virial: kT = 2E = 1, r J = 1/2 2 a hit, Z = 1 + 10 / 100, P = kT Z / L = 1.1 / 11.
TEST(Observers, a_rod_between_two_faces) {
  const Measured m = measure(shuttle(100));
  EXPECT_DOUBLE_EQ(m["collision_rate"], 0.1);
  EXPECT_DOUBLE_EQ(m["wall_collision_rate"], 0.1);
  EXPECT_DOUBLE_EQ(m["mean_free_path"], 10);
  EXPECT_DOUBLE_EQ(m["mean_free_time"], 10);
  EXPECT_DOUBLE_EQ(m["pressure.kT"], 1);
  EXPECT_DOUBLE_EQ(m["pressure.Z"], 1.1);
  EXPECT_DOUBLE_EQ(m["pressure.virial"], 0.1);
  EXPECT_DOUBLE_EQ(m["pressure.wall"], 0.1);
  EXPECT_DOUBLE_EQ(m["pressure.face.x-"], 0.1);
  EXPECT_DOUBLE_EQ(m["pressure.face.x+"], 0.1);
}

TEST(Observers, start_after_a_time) {
  Scene scene = shuttle(100);
  scene.observe.after_time = 45.0;  // the hit at 45 is not after 45: those at 55, ..., 95 are 5 in 55
  const Measured m = measure(scene);
  EXPECT_DOUBLE_EQ(m["collision_rate"], 5.0 / 55);
  EXPECT_DOUBLE_EQ(m["mean_free_path"], 55.0 / 5);
  EXPECT_DOUBLE_EQ(m["pressure.face.x+"], 2 * 2.0 / 55);  // 65, 85
}

TEST(Observers, start_after_a_number_of_collisions) {
  Scene scene = shuttle(100);
  scene.observe.after_events = 5;  // from 45 on, too
  EXPECT_DOUBLE_EQ(measure(scene)["collision_rate"], 5.0 / 55);
  scene.observe.after_events = 0;
  EXPECT_DOUBLE_EQ(measure(scene)["collision_rate"], 0.1);
}

TEST(Observers, of_a_run_that_ends_before_the_start_have_no_value) {
  Scene scene = shuttle(100);
  scene.observe.speed_histogram = true;
  for (const bool events : {false, true}) {
    if (events) {
      scene.observe.after_events = 1000;
    } else {
      scene.observe.after_time = 1e3;
    }
    const Measured m = measure(scene);
    EXPECT_EQ(m.list.size(), 2U + 2U + 3U + 3U + 4U);
    for (const Estimate& e : m.list) EXPECT_TRUE(std::isnan(e.value) && std::isnan(e.error)) << e.name;
    EXPECT_TRUE(m.speeds && m.speeds->empty());
    scene.observe.after_time.reset();
  }
}

// A point at 1 goes to the wall at 0 and out through the opening at 4, by time 5: what comes after is not measured.
TEST(Observers, end_with_a_ball_that_leaves) {
  Scene scene = testing::open_space(2);
  WallSpec gap;
  gap.kind = WallKind::segment;
  gap.from = {4, -10};
  gap.to = {4, 10};
  gap.opening = true;
  scene.walls = {testing::plane({0, 0}, {1, 0}), gap};
  scene.balls = {ball({1, 0}, {-1, 0}, 0)};
  scene.run.until = 100.0;
  scene.observe.collision_rate = scene.observe.mean_free_path = true;
  Measured m = measure(scene);
  EXPECT_DOUBLE_EQ(m["mean_free_path"], 5);
  EXPECT_DOUBLE_EQ(m["collision_rate"], 1 / 5.0);
  scene.balls.push_back(ball({2, 5}, {-1, 0}, 0));  // hits at 2, leaves at 6
  m = measure(scene);
  EXPECT_DOUBLE_EQ(m["mean_free_time"], 11 / 2.0);
  EXPECT_DOUBLE_EQ(m["collision_rate"], 2 / 11.0);
}

// A start far from time 0, on another epoch, changes nothing.
TEST(Observers, clock_starts_anywhere) {
  Scene scene = shuttle(1e9 + 100);
  scene.run.start = 1e9;
  EXPECT_DOUBLE_EQ(measure(scene)["mean_free_path"], 10);
}

// Two rods on a ring of L = 10 with kT = 2E/(2 - 1) = 2 meet every (L - 2 sigma) / 2 = 4: J = 2, so
// Z = 1 + (1/4) 2 / (2 2) = 1.125, the canonical value of two rods, (1 + L / (L - 2 sigma)) / 2.
TEST(Observers, two_rods_on_a_ring) {
  Scene scene = testing::box({0}, {10});
  scene.space.kind = SpaceKind::periodic;
  scene.balls = {ball({2}, {1}), ball({5}, {-1})};
  scene.run.until = 401.0;  // meetings at 1, 5, 9, ..., 401: 101 in 401
  scene.observe.pressure = scene.observe.collision_rate = scene.observe.mean_free_path = true;
  const Measured m = measure(scene);
  EXPECT_DOUBLE_EQ(m["pressure.kT"], 2);
  EXPECT_NEAR(m["pressure.Z"], 1.125, 0.125 * 4 / 401);
  EXPECT_DOUBLE_EQ(m["collision_rate"], 101.0 / 401);
  EXPECT_DOUBLE_EQ(m["wall_collision_rate"], 0);
  EXPECT_DOUBLE_EQ(m["mean_free_path"], 401.0 / 101);
  // Seen from a frame that moves along, it is the same gas.
  scene.balls[0].velocity = {11.0};
  scene.balls[1].velocity = {9.0};
  EXPECT_NEAR(measure(scene)["pressure.Z"], m["pressure.Z"], 1e-12);
}

// A hit on a fixed ball counts for the one that flies; the fixed ball is none of those averaged over.
TEST(Observers, fixed_balls_are_obstacles) {
  Scene scene = testing::open_space(2);
  BallSpec left = ball({0, 0}, {}), right = ball({6, 0}, {});
  left.fixed = right.fixed = true;
  scene.balls = {left, ball({2, 0}, {2, 0}), right};
  scene.run.until = 103.0;  // between x = 1 and 5: 1.5, 3.5, ..., 101.5: 51 hits
  scene.observe.collision_rate = scene.observe.mean_free_path = true;
  const Measured m = measure(scene);
  EXPECT_DOUBLE_EQ(m["collision_rate"], 51.0 / 103);
  EXPECT_DOUBLE_EQ(m["wall_collision_rate"], 0);
  EXPECT_DOUBLE_EQ(m["mean_free_path"], 206.0 / 51);
}

// Two balls until they merge at 1, then one until 3: two collisions (one for each) in a time of 2 1 + 1 2 = 4.
TEST(Observers, rate_of_merging_balls_counts_those_that_are_left) {
  Scene scene = testing::open_space(2);
  scene.collision.law = LawKind::merge;
  scene.balls = {ball({0, 0}, {1, 0}), ball({3, 0}, {-1, 0})};
  scene.run.until = 3.0;
  scene.observe.collision_rate = true;
  EXPECT_DOUBLE_EQ(measure(scene)["collision_rate"], 2.0 / 4);
}

// A ball bounces on a floor to height h above contact: path 2 h, time 2 sqrt(2 h / g) between hits; the floor takes m g.
TEST(Observers, a_bouncing_ball) {
  Scene scene = testing::box({0, 0}, {3, 100});
  scene.motion.acceleration = {0, -8};
  scene.balls = {ball({1.5, 4.5}, {0, 0}, 0.5, 2)};  // h = 4: speed 8, period 2
  scene.run.until = 200.0;                           // 1, 3, ..., 199: 100 hits
  scene.observe.collision_rate = scene.observe.mean_free_path = scene.observe.pressure = scene.observe.speed_histogram =
      true;
  const Measured m = measure(scene);
  EXPECT_DOUBLE_EQ(m["mean_free_path"], 8);
  EXPECT_DOUBLE_EQ(m["mean_free_time"], 2);
  EXPECT_DOUBLE_EQ(m["pressure.face.y-"] * 3, 16);
  EXPECT_DOUBLE_EQ(m["pressure.face.y+"], 0);
  EXPECT_DOUBLE_EQ(m["pressure.wall"], 16.0 / 206);
  EXPECT_THROW((void)m.at("pressure.Z"), std::out_of_range) << "not homogeneous";
  // Speed |g s|, s uniform in 0..1.
  EXPECT_DOUBLE_EQ(m["speed_histogram.mean"], 4);
  EXPECT_DOUBLE_EQ(m["speed_histogram.mean_square"], 64.0 / 3);
  for (const SpeedBin& bin : *m.speeds) EXPECT_NEAR(bin.share, (std::min(bin.to, 8.0) - bin.from) / 8, 1e-12) << bin.from;
}

// Balls of mass 1 and 4 at speeds that a collision exchanges: the ledger of the loss enters kT.
TEST(Observers, temperature_falls_with_the_energy) {
  Scene scene = testing::box({0}, {10});
  scene.space.kind = SpaceKind::periodic;
  scene.collision.restitution = 0.5;
  scene.balls = {ball({2}, {1}), ball({5}, {-1})};
  scene.run.until = 3.0;  // K = 1 until they meet at 1, then 1/4: the mean is 1/2
  scene.observe.pressure = true;
  EXPECT_DOUBLE_EQ(measure(scene)["pressure.kT"], 1.0);
}

}  // namespace
}  // namespace carom
