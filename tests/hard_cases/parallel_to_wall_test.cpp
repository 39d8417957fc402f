// Row 10: motion parallel to a wall, at any distance down to contact, never meets it: its rate of approach is 0.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

TEST(ParallelToWall, never_meets_it) {
  for (const double distance : {0.0, 1e-15, 1e-90, 1.0})
    for (const double radius : {0.0, 0.5}) {
      Scene scene = open_space(2);
      scene.walls = {plane({0.0, 0.0}, {0.0, 1.0}), plane({0.0, 3.0}, {0.0, -1.0}), segment({-1e3, 0.0}, {1e6, 0.0})};
      scene.balls = {ball({0.0, radius + distance}, {1.0, 0.0}, radius)};
      const Result result = watched_run(scene, {.until = 1e5});
      EXPECT_TRUE(result.log.empty()) << "distance " << distance << " radius " << radius;
      EXPECT_EQ(result.balls[0].position[0], 1e5);
    }
}

// Along an inclined plane whose direction (3, 4) / 5 is exact: the rate is 0 exactly.
TEST(ParallelToWall, along_an_exact_incline) {
  Scene scene = open_space(2);
  scene.walls = {plane({0.0, 0.0}, {4.0, -3.0})};
  scene.balls = {ball({4.0, -3.0}, {3.0, 4.0}, 0.5)};
  EXPECT_TRUE(watched_run(scene, {.until = 1e6}).log.empty());
}

// Straight at the end of a segment that it runs along: a ball of any size hits the end, not the face.
TEST(ParallelToWall, meets_the_end_of_a_segment_head_on) {
  for (const double radius : {0.0, 1e-9, 0.5}) {
    Scene scene = open_space(2);
    scene.walls = {segment({0.0, 0.0}, {5.0, 0.0})};
    scene.balls = {ball({-10.0, 0.0}, {2.0, 0.0}, radius)};
    const Result result = watched_run(scene, {.until = 100.0});
    ASSERT_EQ(result.log.size(), 1u);
    EXPECT_EQ(result.log[0].feature, 1) << "the end `from`";
    EXPECT_DOUBLE_EQ(result.log[0].time, (10.0 - radius) / 2);
    EXPECT_EQ(result.balls[0].velocity, (std::vector<Number>{-2.0, 0.0}));
  }
}

// Thrown along a floor under gravity: rate 0 and falling, in contact: the contact never ends, and is named.
TEST(ParallelToWall, in_contact_under_gravity_is_a_contact_that_never_ends) {
  Scene scene = open_space(2);
  scene.motion.acceleration = {0.0, -1.0};
  scene.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
  scene.balls = {ball({0.0, 0.5}, {1.0, 0.0})};
  const Result result = watched_run(scene, {.events = 10'000});
  EXPECT_EQ(result.stop, Stop::collapse);
  ASSERT_TRUE(result.summary.stopped.has_value());
  EXPECT_EQ(result.summary.stopped->balls, std::vector<std::uint32_t>{0});
}

}  // namespace
}  // namespace carom
