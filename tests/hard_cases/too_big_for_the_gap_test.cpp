// A ball larger than the gap it is asked to pass bounces off the gap's edges; a smaller one passes; the limit is the width
// of the gap to the last bit.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

/// A wall along x = 0 with a gap of width `gap` about y = 0.
Scene wall_with_gap(double gap) {
  Scene scene = open_space(2);
  scene.walls = {segment({0.0, gap / 2}, {0.0, 20.0}), segment({0.0, -gap / 2}, {0.0, -20.0})};
  return scene;
}

TEST(TooBigForTheGap, bounces_off_its_edges) {
  Dice dice(251);
  for (int i = 0; i < 300; ++i) {
    const double gap = dice.between(0.1, 1.0), radius = 0.5 * gap * (1.0 + (i % 3 == 0 ? 1e-7 : dice.between(1e-3, 3.0)));
    Scene scene = wall_with_gap(gap);
    const double y = i % 5 == 0 ? 0.0 : dice.between(-0.3, 0.3) * gap;
    scene.balls = {ball({-10.0, y}, {1.0, i % 7 == 0 ? 0.0 : dice.between(-0.02, 0.02)}, radius)};
    const Result result = watched_run(scene, {.until = 200.0, .stride = 5, .energy_error = 2e-14});
    EXPECT_EQ(result.stop, Stop::no_events_left);
    EXPECT_GE(result.log.size(), 1u);
    EXPECT_LT(result.balls[0].position[0], 0.0) << "it got through: case " << i;
    // The centre is in a wedge between two circles about the ends, which cross at the angle 2 acos(gap / 2 radius).
    EXPECT_LE(double(result.log.size()), 3.15 / (2 * std::acos(0.5 * gap / radius)) + 2);
  }
}

// Head on, in the middle: it touches both edges at once, at x = -sqrt(radius^2 - (gap / 2)^2); 3-4-5.
TEST(TooBigForTheGap, both_edges_at_once) {
  Scene scene = wall_with_gap(1.5);
  scene.balls = {ball({-10.0, 0.0}, {1.0, 0.0}, 1.25)};
  const Result result = watched_run(scene, {.until = 100.0});
  ASSERT_GE(result.log.size(), 2u);
  EXPECT_EQ(result.log[0].time, 9.0);
  EXPECT_NEAR(result.log[1].time, 9.0, 1e-14);
  EXPECT_LT(result.balls[0].velocity[0], 0.0);
}

// By one bit too large it is stopped; that it comes out of that wedge again takes pi / 4e-8 hits, which are not waited for.
TEST(TooBigForTheGap, fits_to_the_last_bit) {
  const auto hits = [](double radius, double y) {
    Scene scene = wall_with_gap(1.0);
    scene.balls = {ball({-10.0, y}, {1.0, 0.0}, radius)};
    const Result result = watched_run(scene, {.events = 3, .until = 100.0});
    EXPECT_EQ(result.balls[0].position[0] > 0.0, result.log.empty());
    return result.log.size();
  };
  EXPECT_EQ(hits(0.5, 0.0), 0u) << "touches both edges in passing, and no more";
  EXPECT_EQ(hits(0.5 - 0x1p-54, 0.0), 0u);
  EXPECT_EQ(hits(0.5 + 0x1p-53, 0.0), 3u);
  EXPECT_GE(hits(0.5, 0x1p-53), 1u);
}

// Between two fixed balls, in 3-D through a ring of them, and a ball on a line, which passes nothing.
TEST(TooBigForTheGap, of_balls) {
  for (const double radius : {0.4, 0.6}) {
    Scene scene = open_space(2);
    scene.balls = {fixed_ball({0.0, 1.0}), fixed_ball({0.0, -1.0}), ball({-5.0, 0.0}, {1.0, 0.0}, radius)};
    EXPECT_EQ(watched_run(scene, {.until = 50.0}).balls[2].position[0] > 0.0, radius < 0.5);
    Scene ring = open_space(3);
    for (const double s : {1.0, -1.0}) {
      ring.balls.push_back(fixed_ball({0.0, s, 0.0}));
      ring.balls.push_back(fixed_ball({0.0, 0.0, s}));
    }
    ring.balls.push_back(ball({-5.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, radius));
    EXPECT_EQ(watched_run(ring, {.until = 50.0}).balls[4].position[0] > 0.0, radius < 0.5);
  }
  Scene line = open_space(1);
  line.balls = {fixed_ball({3.0}, 0.0), ball({0.0}, {1.0}, 0.0)};
  EXPECT_LT(watched_run(line, {.until = 50.0}).balls[1].position[0], 0.0) << "even a point cannot pass a point";
}

}  // namespace
}  // namespace carom
