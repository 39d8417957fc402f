// Row 15: an error of position that grows with speed. The state at a collision is (x, v, time of the collision), and the
// flight is computed from it once; so the gap error at contact is a rounding of the coordinates, whatever the speed.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

// The same scene with all velocities faster by a power of ten: the gap errors stay what they are, about 1e-15 of a radius.
TEST(FastBall, has_the_gap_error_of_a_slow_one) {
  for (int power = -30; power <= 30; power += 5) {
    Scene scene = mixed_box(2, 16, 10.0, 151);
    for (BallSpec& b : scene.balls)
      for (Number& v : b.velocity) v = v * std::pow(10.0, power);
    const Result result = watched_run(scene, {.events = 2000, .stride = 41, .energy_error = 1e-14});
    EXPECT_EQ(result.stop, Stop::events);
    EXPECT_LT(result.summary.exactness.max_gap_error, 2e-14) << "1e" << power;
    EXPECT_LT(result.summary.exactness.max_gap_error_relative, 1e-13);
    EXPECT_EQ(result.summary.exactness.unresolved, 0);
  }
}

// One ball a million times faster than its neighbours, and small: it must not tunnel, at a step of any size.
TEST(FastBall, does_not_tunnel) {
  Scene scene = box({0.0, 0.0}, {20.0, 1.0});
  scene.balls = {ball({1.0, 0.5}, {1e6, 0.0}, 1e-3), ball({18.0, 0.5}, {1.0, 0.0}, 0.25, 1e6)};
  scene.walls = {segment({10.0, 0.75}, {10.0, 1.0})};
  const Result result = watched_run(scene, {.events = 3000, .stride = 11, .energy_error = 1e-13});
  EXPECT_EQ(result.stop, Stop::events);
  EXPECT_GT(result.summary.events.ball_ball, 300);
  EXPECT_LE(result.summary.exactness.max_gap_error, 1e-13);
}

}  // namespace
}  // namespace carom
