// A ball between two walls with 1e-15 of its size to spare, with one ulp, and with nothing. As long as there is room it
// rattles or slides; where there is none and it is pressed, hits follow each other at one instant without end, and the run
// says so.

#include <algorithm>

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

TEST(WedgedBall, rattles_as_long_as_there_is_room) {
  for (const double room : {1e-15, 0x1p-51, 1e-13})
    for (const bool faces : {true, false}) {
      Scene scene = faces ? box({0.0, -100.0}, {1.0 + room, 100.0}) : open_space(2);
      if (!faces) scene.walls = {plane({0.0, 0.0}, {1.0, 0.0}), plane({1.0 + room, 0.0}, {-1.0, 0.0})};
      scene.balls = {ball({0.5, 0.0}, {1.0, 0.5})};
      const Result result = watched_run(scene, {.events = 3000, .stride = 31});
      EXPECT_EQ(result.stop, Stop::events);
      EXPECT_EQ(std::abs(result.balls[0].velocity[0]), 1.0);
      EXPECT_EQ(result.balls[0].velocity[1], 0.5) << "free along the walls";
      EXPECT_NEAR(result.balls[0].position[0], 0.5, 2 * room);
      EXPECT_LE(result.summary.time, 3000 * (room + 0x1p-51));
    }
}

TEST(WedgedBall, slides_along_if_nothing_presses_it) {
  for (const double room : {0.0, 1e-15}) {
    Scene scene = box({0.0, -100.0}, {1.0 + room, 100.0});
    scene.balls = {ball({0.5, 0.0}, {0.0, 1.0})};
    const Result result = watched_run(scene, {.events = 5});
    ASSERT_EQ(result.log.size(), 5u);
    EXPECT_EQ(result.log[0].time, 99.5);
    EXPECT_EQ(result.log[4].time, 99.5 + 4 * 199.0);
  }
}

// One ulp of 1 may be the rounding of the wall, the ball or its place: it starts in contact with both sides, by right.
TEST(WedgedBall, room_that_rounding_cannot_tell_from_none_is_none) {
  Scene scene = box({0.0, -100.0}, {1.0 + 0x1p-52, 100.0});
  scene.balls = {ball({0.5, 0.0}, {1.0, 0.5})};
  const Result result = watched_run(scene, {.until = 1.0, .stride = 1'000'000});
  EXPECT_EQ(result.stop, Stop::collapse);
  EXPECT_EQ(result.summary.stopped->time, 0.0);
}

// No room at all, and a velocity across: the instant does not end.
TEST(WedgedBall, pressed_without_room_is_named) {
  for (const double e : {1.0, 0.5, 0.0})
    for (const int kind : {0, 1, 2}) {
      Scene scene = kind == 0 ? box({0.0, -100.0}, {1.0, 100.0}) : open_space(2);
      if (kind == 1) scene.walls = {plane({0.0, 0.0}, {1.0, 0.0}), plane({1.0, 0.0}, {-1.0, 0.0})};
      if (kind == 2) scene.balls = {fixed_ball({-0.5, 0.0}), fixed_ball({1.5, 0.0})};
      scene.collision.restitution = e;
      const double along = kind == 2 ? 0.0 : 0.25;
      scene.balls.push_back(ball({0.5, 0.0}, {1.0, along}));
      const Result result = watched_run(scene, {.until = 10.0, .stride = 1'000'000});
      if (e == 0.0) {
        EXPECT_NE(result.stop, Stop::events) << "one plastic hit and it slides";
        continue;
      }
      EXPECT_EQ(result.stop, Stop::collapse) << "e " << e << ", kind " << kind;
      ASSERT_TRUE(result.summary.stopped.has_value());
      const std::vector<std::uint32_t>& named = result.summary.stopped->balls;
      EXPECT_NE(std::find(named.begin(), named.end(), std::uint32_t(scene.balls.size() - 1)), named.end());
      EXPECT_EQ(result.summary.stopped->time, 0.0);
    }
}

// As wide as the gap between a wall and the end of another: no room across, free along the wall.
TEST(WedgedBall, between_a_wall_and_the_end_of_another) {
  Scene scene = box({0.0, 0.0}, {8.0, 8.0});
  scene.walls = {segment({2.5, 4.5}, {7.0, 4.0})};
  scene.balls = {ball({7.5, 4.0}, {1.0, 0.0})};
  const Result across = watched_run(scene, {.until = 10.0, .stride = 1'000'000});
  EXPECT_EQ(across.stop, Stop::collapse);
  EXPECT_EQ(across.summary.stopped->time, 0.0);
  EXPECT_EQ(across.summary.stopped->balls, (std::vector<std::uint32_t>{0}));
  scene.balls[0].velocity = {0.0, -1.0};
  const Result along = watched_run(scene, {.until = 10.0});
  EXPECT_EQ(along.stop, Stop::until);
  EXPECT_EQ(along.log.front().time, 3.5) << "the floor";
}

// Rods that fill a box exactly, and disks that fill a periodic square: velocities go round for ever at one instant. (Equal
// masses exchange components, so that they come back; two unequal rods come back as well, since turning both round commutes
// with their impact. Three unequal ones need not, and are not waited for here.)
TEST(WedgedBall, a_row_without_room_is_named) {
  for (const int n : {2, 5})
    for (const double mass : {1.0, 1.7}) {
      if (n > 2 && mass != 1.0) continue;
      Scene scene = box({0.0}, {double(n)});
      for (int i = 0; i < n; ++i) scene.balls.push_back(ball({i + 0.5}, {i == 0 ? 1.0 : 0.0}, 0.5, i == 1 ? mass : 1.0));
      const Result result = watched_run(scene, {.until = 10.0, .stride = 1'000'000});
      EXPECT_EQ(result.stop, Stop::collapse) << n << " rods, mass " << mass;
      EXPECT_EQ(result.summary.time, 0.0);
      EXPECT_EQ(result.balls.size(), std::size_t(n));
    }
  Scene crystal = open_space(2);
  crystal.space.kind = SpaceKind::periodic;
  crystal.space.lower = {0.0, 0.0};
  crystal.space.upper = {4.0, 4.0};
  for (int i = 0; i < 16; ++i)
    crystal.balls.push_back(ball({0.5 + i % 4, 0.5 + i / 4}, {0.1 * (i % 3) - 0.1, 0.07 * (i % 5) - 0.14}));
  EXPECT_EQ(watched_run(crystal, {.until = 10.0, .stride = 1'000'000}).stop, Stop::collapse);
}

// Touching in a long row and free at one end there is room: the hits at one instant end, however many.
TEST(WedgedBall, a_row_with_room_at_its_end_is_not) {
  Scene scene = open_space(1);
  scene.walls = {plane({0.0}, {1.0})};
  for (int i = 0; i < 40; ++i) scene.balls.push_back(ball({i + 0.5}, {-1.0}));
  const Result result = watched_run(scene, {.until = 1000.0, .stride = 1'000'000});
  EXPECT_EQ(result.stop, Stop::no_events_left);
  EXPECT_EQ(result.log.size(), 820u) << "40 * 41 / 2, all at t = 0";
}

}  // namespace
}  // namespace carom
