// Row 5: events at one moment. The order is total: time, kind, then the user's numbers. A tie is counted only if a ball is
// shared; two pairs that meet far apart at one moment have nothing to do with each other.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

// A 10 x 10 array of head-on pairs, all of which meet at t = 1 exactly.
TEST(EqualTimes, of_strangers_are_no_ties_and_come_in_the_order_of_their_numbers) {
  Scene scene = open_space(2);
  for (int i = 0; i < 100; ++i) {
    const double x = 10.0 * (i % 10), y = 10.0 * (i / 10);
    scene.balls.push_back(ball({x, y}, {1.0, 0.0}));
    scene.balls.push_back(ball({x + 3.0, y}, {-1.0, 0.0}));
  }
  const Result result = watched_run(scene, {.events = 100});
  ASSERT_EQ(result.log.size(), 100u);
  EXPECT_EQ(result.summary.events.ties, 0);
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(result.log[i].time, 1.0);
    EXPECT_EQ(result.log[i].ball.number, 2 * i);
    EXPECT_EQ(result.log[i].partner.number, 2 * i + 1);
  }
}

// Four balls strike a fifth from four sides at t = 3, exactly.
TEST(EqualTimes, of_a_shared_ball_are_ties) {
  Scene scene = open_space(2);
  scene.balls = {ball({-4.0, 0.0}, {1.0, 0.0}), ball({4.0, 0.0}, {-1.0, 0.0}), ball({0.0, -4.0}, {0.0, 1.0}),
                 ball({0.0, 4.0}, {0.0, -1.0}), ball({0.0, 0.0}, {})};
  const Result result = watched_run(scene, {});
  EXPECT_EQ(result.stop, Stop::no_events_left);
  EXPECT_EQ(result.log.size(), 6u) << "in, through and out again along either axis";
  EXPECT_EQ(result.summary.events.ties, 5);
  for (const Collision& c : result.log) EXPECT_EQ(c.time, 3.0);
  for (const BallState& b : result.balls) EXPECT_EQ(speed_of(b), b.index == 4 ? 0.0 : 1.0);
}

// Four balls meet in the middle of a cross at a time that no double is: the symmetry is lost to rounding, and nothing else.
TEST(EqualTimes, to_rounding_keep_the_books) {
  Scene scene = open_space(2);
  scene.balls = {ball({-4.0, 0.0}, {1.0, 0.0}), ball({4.0, 0.0}, {-1.0, 0.0}), ball({0.0, -4.0}, {0.0, 1.0}),
                 ball({0.0, 4.0}, {0.0, -1.0})};
  const Result result = watched_run(scene, {});
  EXPECT_EQ(result.stop, Stop::no_events_left);
  for (const Collision& c : result.log) EXPECT_NEAR(c.time, 4.0 - std::sqrt(0.5), 1e-15);
  EXPECT_LE(result.summary.momentum.relative_error.value(), 1e-15);
}

// A wall before a ball: the kinds have an order too. Ball 0 reaches the wall and ball 1 at t = 1.
TEST(EqualTimes, a_wall_comes_before_a_ball) {
  Scene scene = open_space(1);
  scene.walls = {plane({0.0}, {1.0})};
  scene.balls = {ball({1.5}, {-1.0}), ball({4.5}, {-3.0})};
  const Result result = watched_run(scene, {});
  ASSERT_GE(result.log.size(), 2u);
  EXPECT_EQ(result.log[0].kind, EventKind::ball_wall);
  EXPECT_EQ(result.log[1].kind, EventKind::ball_ball);
  EXPECT_EQ(result.log[0].time, 1.0);
  EXPECT_EQ(result.log[1].time, 1.0);
  EXPECT_FALSE(result.log[0].tie);
  EXPECT_TRUE(result.log[1].tie);
}

// No NaN and no loss in a perfectly symmetric crowd, where half of all events are simultaneous.
TEST(EqualTimes, in_a_symmetric_crowd) {
  Scene scene = box({-8.0, -8.0}, {8.0, 8.0});
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j)
      if (i != 0 || j != 0) scene.balls.push_back(ball({2.0 * i, 2.0 * j}, {-0.25 * i, -0.25 * j}));
  const Result result = watched_run(scene, {.events = scaled_count(3000), .stride = 11});
  EXPECT_GT(result.summary.events.ties, 10);
  for (const BallState& b : result.balls) EXPECT_TRUE(std::isfinite(speed_of(b)));
}

}  // namespace
}  // namespace carom
