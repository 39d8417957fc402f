// A segment's end hit exactly. For a disk the end is a point: head-on it turns straight round. A point that meets it has no
// normal: its velocity is reversed, and that is counted (`singular`). Beside it by one ulp it passes, or meets the face.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

TEST(SegmentEnd, hit_by_a_point_reverses_it) {
  // Rational directions: the path runs through the end exactly, from either side of the segment and along it.
  const double directions[][2] = {{1.0, 0.0}, {0.0, 1.0}, {3.0, 4.0}, {-3.0, 4.0}, {5.0, -12.0}, {1.0, 1.0}, {-1.0, -2.0}};
  for (const auto& d : directions) {
    Scene scene = open_space(2);
    scene.walls = {segment({0.5, 0.25}, {0.5, -8.0})};
    scene.balls = {ball({0.5 - 2 * d[0], 0.25 - 2 * d[1]}, {d[0], d[1]}, 0.0)};
    if (d[0] == 0.0) continue;
    const Result result = watched_run(scene, {.until = 10.0});
    ASSERT_EQ(result.log.size(), 1u) << d[0] << ' ' << d[1];
    EXPECT_EQ(result.log[0].time, 2.0);
    EXPECT_EQ(result.log[0].feature, 1);
    EXPECT_EQ(result.summary.exactness.singular, 1);
    EXPECT_EQ(result.balls[0].velocity, (std::vector<Number>{-d[0], -d[1]}));
  }
}

TEST(SegmentEnd, missed_by_an_ulp_is_missed) {
  for (const double aside : {0x1p-54, -0x1p-54, 1e-12, -1e-12}) {
    Scene scene = open_space(2);
    scene.walls = {segment({0.5, 0.25}, {0.5, -8.0})};
    scene.balls = {ball({-2.0, 0.25 + aside}, {1.0, 0.0}, 0.0)};
    const Result result = watched_run(scene, {.until = 10.0});
    EXPECT_EQ(result.log.size(), aside > 0 ? 0u : 1u) << aside;
    EXPECT_EQ(result.summary.exactness.singular, 0);
  }
}

// A disk from all around: it turns by the angle that the line of centres gives, wherever it comes from.
TEST(SegmentEnd, hit_by_a_disk) {
  for (int k = 0; k < 64; ++k) {
    const double turn = 0.01 + k * 6.283185307179586 / 64, c = std::cos(turn), s = std::sin(turn);
    Scene scene = open_space(2);
    scene.walls = {segment({0.0, 0.0}, {0.0, -8.0})};
    scene.balls = {ball({-3 * c, -3 * s}, {c, s}, 0.5)};
    if (-s < -0.9) continue;  // along the segment from below: it would start on it
    const Result result = watched_run(scene, {.until = 4.0});
    ASSERT_GE(result.log.size(), 1u);
    if (s > 0) continue;  // from below the face is hit first
    EXPECT_NEAR(result.log[0].time, 2.5, 1e-14) << turn;
    EXPECT_NEAR(result.balls[0].velocity[0], -c, 1e-14);
    EXPECT_NEAR(result.balls[0].velocity[1], -s, 1e-14);
  }
}

// Where face and end meet: the foot of the contact is the end itself. One hit, not two, not none.
TEST(SegmentEnd, at_the_foot_of_a_disk) {
  for (const double aside : {0.0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-8, -1e-8})
    for (const double slope : {0.0, 0.3, -0.3, 3.0, -3.0}) {
      Scene scene = open_space(2);
      scene.walls = {segment({0.0, 0.0}, {8.0, 0.0})};
      scene.balls = {ball({aside - 4 * slope, 4.5}, {slope, -1.0}, 0.5)};
      const Result result = watched_run(scene, {.until = 10.0});
      ASSERT_EQ(result.log.size(), 1u) << "aside " << aside << " slope " << slope;
      EXPECT_NEAR(result.log[0].time, 4.0, 1e-7);
      EXPECT_NEAR(result.balls[0].velocity[1], 1.0, 1e-6);
      EXPECT_NEAR(result.balls[0].velocity[0], slope, 1e-6);
    }
}

}  // namespace
}  // namespace carom
