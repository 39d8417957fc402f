// Row 6: two walls at once. In a right corner an elastic ball turns straight round, whatever its angle; in any corner it
// comes out again. Boxes at 45 degrees are in tests/sim/contact_test.cpp (Corner); here: corners made of planes and of
// segments, points and disks, and any number of walls in one point.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

// Aimed into the corner of two inclined planes at a right angle: two hits within rounding of each other, velocity reversed.
TEST(RightCorner, of_two_planes_turns_a_ball_round) {
  Dice dice(61);
  for (int i = 0; i < 200; ++i) {
    const double turn = dice.between(0.0, 6.28), c = std::cos(turn), s = std::sin(turn);
    Scene scene = open_space(2);
    scene.walls = {plane({0.0, 0.0}, {c, s}), plane({0.0, 0.0}, {-s, c})};
    const double a = dice.between(0.1, 1.0), b = dice.between(0.1, 1.0), radius = i % 2 == 0 ? 0.0 : 0.25;
    const double along = radius + 3 * a, up = radius + 3 * b;  // reaches both walls after a time of 3
    scene.balls = {ball({along * c - up * s, along * s + up * c}, {-a * c + b * s, -a * s - b * c}, radius)};
    const Result result = watched_run(scene, {.until = 100.0});
    ASSERT_EQ(result.log.size(), 2u) << i;
    EXPECT_NEAR(result.log[0].time, 3.0, 1e-13);
    EXPECT_NEAR(result.log[1].time, 3.0, 1e-13);
    EXPECT_NEAR(result.balls[0].velocity[0], a * c - b * s, 1e-14);
    EXPECT_NEAR(result.balls[0].velocity[1], a * s + b * c, 1e-14);
  }
}

// In a wedge of angle alpha a ball aimed at the corner hits at most ceil(pi / alpha) times and comes out.
TEST(SharpCorner, lets_the_ball_out_again) {
  for (const double alpha : {1.0, 0.3, 0.1, 0.01, 1e-3})
    for (const double radius : {0.0, 0.1})
      for (const double aside : {0.0, 1e-14, 1e-9}) {
        Scene scene = open_space(2);
        scene.walls = {plane({0.0, 0.0}, {0.0, 1.0}), plane({0.0, 0.0}, {std::sin(alpha), -std::cos(alpha)})};
        const double far = 2.0 * radius / std::sin(alpha / 2) + 3.0;
        scene.balls = {ball({far * std::cos(alpha / 2), far * std::sin(alpha / 2)},
                            {-std::cos(alpha / 2), -std::sin(alpha / 2) + aside}, radius)};
        const std::int64_t most = static_cast<std::int64_t>(std::ceil(3.14159265 / alpha)) + 1;
        const Result result = watched_run(scene, {.events = 2 * most, .stride = 13, .energy_error = 1e-14});
        EXPECT_EQ(result.stop, Stop::no_events_left) << "alpha " << alpha << " radius " << radius;
        EXPECT_LE(std::int64_t(result.log.size()), most) << "alpha " << alpha << " radius " << radius;
        EXPECT_NEAR(speed_of(result.balls[0]) / std::hypot(std::cos(alpha / 2), std::sin(alpha / 2) - aside), 1.0, 1e-13);
      }
}

// Eight planes through one edge of a trough, and the three faces of a cube's corner hit by a ball aimed straight at it.
TEST(ManyWalls, in_one_point) {
  Scene scene = open_space(2);
  for (int k = -4; k <= 4; ++k) scene.walls.push_back(plane({0.0, 0.0}, {0.1 * k, 1.0}));
  scene.balls = {ball({0.0, 5.0}, {0.0, -1.0}, 0.0)};
  const Result result = watched_run(scene, {.until = 100.0});
  EXPECT_EQ(result.stop, Stop::no_events_left);
  EXPECT_GE(result.log.size(), 1u);
  EXPECT_GT(result.balls[0].velocity[1], 0.0);
}

// Plastic walls of an inclined corner catch the ball for good: it stays, and the run goes on to its end or says why not.
TEST(PlasticCorner, catches_the_ball) {
  Dice dice(62);
  for (int i = 0; i < 100; ++i) {
    const double turn = dice.between(0.0, 6.28), c = std::cos(turn), s = std::sin(turn);
    Scene scene = open_space(2);
    scene.collision.restitution = 0.0;
    scene.walls = {plane({0.0, 0.0}, {c, s}), plane({0.0, 0.0}, {-s, c})};
    scene.balls = {ball({3 * c - 3 * s, 3 * s + 3 * c}, {-c + 0.5 * s, -s - 0.5 * c}, 0.25)};
    const Result result = watched_run(scene, {.until = 1000.0});
    EXPECT_LT(speed_of(result.balls[0]), 1e-15) << i;
    EXPECT_GE(result.log.size(), 2u);
    EXPECT_LT(result.log.size(), 100u);
  }
}

}  // namespace
}  // namespace carom
