// Row 12: straight up, straight down, along an axis, at 90 degrees to a wall: no slope is ever formed, so no direction is
// special. A velocity turned by any angle gives the same time of flight.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

// From the centre of a circle every direction takes the same time, and comes back through the centre.
TEST(VerticalVelocity, is_like_any_other_in_a_circle) {
  for (int k = 0; k < 360; ++k) {
    const double turn = k * 3.141592653589793 / 180;
    const double vx = k == 90 || k == 270 ? 0.0 : std::cos(turn), vy = k % 180 == 0 ? 0.0 : std::sin(turn);
    Scene scene = open_space(2);
    scene.walls = {circle({0.0, 0.0}, 2.0, WallSide::inside)};
    scene.balls = {ball({0.0, 0.0}, {vx, vy})};
    const Result result = watched_run(scene, {.events = 7});
    ASSERT_EQ(result.log.size(), 7u);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(result.log[i].time, 1.5 + 3.0 * double(i), 1e-13) << k;
  }
}

// Along the axes among segments, planes, faces and polygons at once; signed zeros make no difference.
TEST(VerticalVelocity, among_all_walls) {
  for (const double zero : {0.0, -0.0})
    for (int axis = 0; axis < 2; ++axis)
      for (const double sign : {1.0, -1.0}) {
        Scene scene = box({-6.0, -6.0}, {6.0, 6.0});
        scene.walls = {segment({-3.0, 4.0}, {3.0, 4.0}), segment({4.0, -3.0}, {4.0, 3.0}), plane({-5.0, 0.0}, {1.0, 0.0}),
                       polygon({{-2.0, -4.0}, {2.0, -4.0}, {0.0, -5.0}})};
        Coordinates v{zero, zero};
        v[std::size_t(axis)] = sign;
        scene.balls = {ball({0.0, 0.0}, v)};
        const Result result = watched_run(scene, {.events = 20});
        ASSERT_EQ(result.log.size(), 20u);
        for (const Collision& c : result.log) EXPECT_EQ(c.ball.velocity_after[std::size_t(1 - axis)], 0.0);
        EXPECT_EQ(result.log[0].time, axis == 0 ? (sign > 0 ? 3.5 : 4.5) : 3.5);
      }
}

}  // namespace
}  // namespace carom
