// Coordinates offset by 1e8. Positions are then rounded to 1.5e-8 of 1: gaps are as wrong as that, and the same physics
// happens: no overlap beyond it, nothing lost, the first hits at the same times to that rounding. With an offset that is a
// power of two and coordinates that fit, nothing is rounded, and the log is the same but for the offset.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

Scene moved_by(Scene scene, double offset) {
  for (BallSpec& b : scene.balls)
    for (Number& x : b.position) x = x + offset;
  for (Coordinates* c : {&scene.space.lower, &scene.space.upper})
    for (Number& x : *c) x = x + offset;
  return scene;
}

TEST(FarFromTheOrigin, a_crowd_keeps_its_books_and_its_distances) {
  for (int d = 1; d <= 3; ++d)
    for (const double offset : {1e8, -1e8, 1e12}) {
      const Scene near = d == 1 ? rods(9, 271) : mixed_box(d, 9, 10.0, 272, 0.5);
      const Scene far = moved_by(near, offset);
      const double grain = std::abs(offset) * 0x1p-52;
      const Result result = watched_run(far, {.events = 3000, .stride = 29, .energy_error = 1e-14});
      EXPECT_EQ(result.stop, Stop::events) << d << "-D, offset " << offset;
      EXPECT_LE(result.summary.exactness.max_gap_error, 8 * grain);
      const Result one = run(near, 3), other = run(far, 3);
      for (std::size_t i = 0; i < 3 && std::abs(offset) < 1e9; ++i) {
        EXPECT_EQ(one.log[i].ball.number, other.log[i].ball.number);
        EXPECT_NEAR(one.log[i].time, other.log[i].time, 1e3 * grain);
      }
    }
}

// Offset in one direction only: y stays exact.
TEST(FarFromTheOrigin, a_wall_and_a_joint) {
  for (const double offset : {1e8, -1e12}) {
    Scene scene = open_space(2);
    const std::vector<Coordinates> corners = {{offset, 0.0}, {offset + 4.0, 0.5}, {offset + 2.0, 4.0}};
    scene.walls = {polygon(corners)};
    scene.balls = {ball({offset + 2.0, 1.0}, {0.3, 0.7}, 0.0)};
    const Result result = watched_run(scene, {.events = 20'000, .stride = 7, .energy_error = 1e-13});
    EXPECT_EQ(result.stop, Stop::events) << "a point got out at offset " << offset;
    EXPECT_NEAR(result.balls[0].position[0], offset + 2.0, 2.01);
  }
}

TEST(FarFromTheOrigin, without_rounding_is_the_same_log) {
  Scene scene = box({0.0, 0.0}, {16.0, 16.0});
  scene.balls = {ball({2.0, 8.0}, {1.0, 0.0}), ball({8.0, 8.0}, {0.0, 0.0}), ball({12.0, 8.0}, {-1.0, 0.0})};
  const Result near = run(scene, 40), far = run(moved_by(scene, 0x1p30), 40);
  ASSERT_EQ(near.log.size(), far.log.size());
  for (std::size_t i = 0; i < near.log.size(); ++i) {
    EXPECT_EQ(near.log[i].time, far.log[i].time);
    EXPECT_EQ(near.log[i].ball.position[0] + 0x1p30, far.log[i].ball.position[0]);
    EXPECT_EQ(near.log[i].ball.velocity_after, far.log[i].ball.velocity_after);
  }
}

}  // namespace
}  // namespace carom
