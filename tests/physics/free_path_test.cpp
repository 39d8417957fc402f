// Mean free paths of billiards: pi |Q| / |dQ| in the plane, 4 |Q| / |dQ| in space, for a point in the free region Q
// [Chernov1997], whatever its shape as long as the motion is ergodic.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "observe/measure.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using std::numbers::pi;
using testing::measure;
using testing::Measured;
using testing::scaled_count;

BallSpec disk(Coordinates centre, double radius) {
  BallSpec d = testing::ball(centre, {}, radius);
  d.fixed = true;
  return d;
}

void expect_free_path(Scene scene, double expected, double speed = 1) {
  scene.observe.collision_rate = scene.observe.mean_free_path = true;
  const Measured m = measure(scene);
  const Estimate& path = m.at("mean_free_path");
  EXPECT_NEAR(path.value, expected, 4 * path.error);
  EXPECT_LT(4 * path.error, 0.02 * expected);
  EXPECT_NEAR(m["mean_free_time"] * speed, path.value, 1e-9 * expected);
  EXPECT_NEAR(m["collision_rate"] * m["mean_free_time"], 1, 1e-9);
  EXPECT_EQ(m.summary.exactness.clamped, 0);
}

// Disks of radius 1 on a triangular lattice of spacing 2 + w: |Q| = sqrt(3) (2 + w)^2 / 2 - pi a disk, |dQ| = 2 pi. The
// cell is a rectangle 1 : sqrt(3) with two disks.
TEST(FreePath, triangular_lorentz_gas) {
  for (const double w : {0.3, 1.0}) {
    const double a = 2 + w;
    Scene scene = testing::box({0, 0}, {a, a * std::sqrt(3.0)});
    scene.space.kind = SpaceKind::periodic;
    scene.balls = {disk({0, 0}, 1), disk({a / 2, a * std::sqrt(3.0) / 2}, 1),
                   testing::ball({a / 2, 0.1}, {std::cos(0.4), std::sin(0.4)}, 0)};
    scene.run.events = scaled_count(300'000);
    expect_free_path(scene, (std::sqrt(3.0) * a * a / 2 - pi) / 2);
  }
}

TEST(FreePath, sinai_billiard) {
  Scene scene = testing::box({0, 0}, {1, 1});
  scene.balls = {disk({0.5, 0.5}, 0.3), testing::ball({0.1, 0.1}, {1.2, 1.6}, 0)};
  scene.run.events = scaled_count(300'000);
  const double area = 1 - pi * 0.09;
  expect_free_path(scene, pi * area / (4 + 2 * pi * 0.3), 2);
  scene.space.kind = SpaceKind::periodic;
  expect_free_path(scene, pi * area / (2 * pi * 0.3), 2);
}

// In space: a sphere in a box.
TEST(FreePath, sphere_in_a_box) {
  Scene scene = testing::box({0, 0, 0}, {1, 1, 1});
  scene.balls = {disk({0.5, 0.5, 0.5}, 0.4), testing::ball({0.1, 0.1, 0.05}, {0.48, 0.6, 0.64}, 0)};
  scene.run.events = scaled_count(300'000);
  expect_free_path(scene, 4 * (1 - 4 * pi / 3 * 0.064) / (6 + 4 * pi * 0.16));
}

// A box alone is not ergodic: |v_k| / L_k hits a unit of time on the faces across axis k, in every direction.
TEST(FreePath, point_in_a_box) {
  Scene scene = testing::box({0, 0, 0}, {1, 2, 3});
  scene.balls = {testing::ball({0.3, 0.3, 0.3}, {2, 3, 6}, 0)};
  scene.run.until = 1e4;
  scene.observe.mean_free_path = scene.observe.collision_rate = true;
  const Measured m = measure(scene);
  EXPECT_NEAR(m["collision_rate"], 2.0 + 1.5 + 2.0, 3 / 1e4);
  EXPECT_NEAR(m["wall_collision_rate"], m["collision_rate"], 1e-12);
  EXPECT_NEAR(m["mean_free_path"], 7 / 5.5, 1e-3);
}

// A ball on a floor: period 2 sqrt(2E/m) / g, path 2 E / (m g) twice the height, E counted from contact.
TEST(FreePath, bouncing_ball) {
  Scene scene = testing::box({0, 0}, {2, 50});
  scene.motion.acceleration = {0, -9.81};
  scene.balls = {testing::ball({1, 0.3}, {0, 3.7}, 0.3, 1.7)};  // starts in contact, going up
  const double period = 2 * 3.7 / 9.81;
  scene.observe.after_events = 1;
  scene.observe.mean_free_path = true;
  scene.run.events = 1001;
  const Measured m = measure(scene);
  EXPECT_NEAR(m["mean_free_time"], period, 1e-12 * period);
  EXPECT_NEAR(m["mean_free_path"], 3.7 * 3.7 / 9.81, 1e-12);
}

}  // namespace
}  // namespace carom
