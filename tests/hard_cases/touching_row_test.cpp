// Row 3: balls in a touching row that move alike. Their relative velocity is 0, so they never meet; nothing may be passed
// between them, and they hit a wall one after the other.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

TEST(TouchingRow, that_flies_together_never_meets) {
  for (int d = 1; d <= 3; ++d)
    for (const double e : {1.0, 0.5, 0.0}) {
      Scene scene = open_space(d);
      scene.collision.restitution = e;
      for (int i = 0; i < 20; ++i) {
        Coordinates x(std::size_t(d), 0.0), v(std::size_t(d), 0.3);
        x[0] = 0.2 * i;
        scene.balls.push_back(ball(x, v, 0.1, 1.0 + i));
      }
      const Result result = watched_run(scene, {.until = 1e6});
      EXPECT_TRUE(result.log.empty()) << d << "-D, e " << e;
      EXPECT_EQ(result.balls[7].velocity[0], 0.3);
    }
}

// Under gravity too: all fall alike.
TEST(TouchingRow, that_falls_together_never_meets) {
  for (int d = 2; d <= 3; ++d) {
    Scene scene = open_space(d);
    scene.motion.acceleration = Coordinates(std::size_t(d), 0.0);
    scene.motion.acceleration.back() = -9.81;
    for (int i = 0; i < 10; ++i) {
      Coordinates x(std::size_t(d), 0.0);
      x.back() = 1.0 * i;
      scene.balls.push_back(ball(x, Coordinates(std::size_t(d), 0.1)));
    }
    EXPECT_TRUE(watched_run(scene, {.until = 100.0}).log.empty()) << d << "-D";
  }
}

// Equal balls, e = 1, on a wall: the first turns, and passes on the turn. n balls take n (n + 1) / 2 hits to turn round:
// equal masses exchange velocities, so each of the n velocities must be brought to the wall once.
TEST(TouchingRow, that_hits_a_wall_turns_as_one) {
  for (const int n : {1, 2, 5, 9}) {
    Scene scene = open_space(1);
    scene.walls = {plane({0.0}, {1.0})};
    for (int i = 0; i < n; ++i) scene.balls.push_back(ball({2.5 + i}, {-1.0}));
    const Result result = watched_run(scene, {});
    EXPECT_EQ(result.stop, Stop::no_events_left);
    EXPECT_EQ(result.log.size(), std::size_t(n * (n + 1) / 2));
    EXPECT_EQ(result.summary.events.ball_wall, n);
    for (const BallState& b : result.balls) EXPECT_EQ(b.velocity[0], 1.0);
    for (const Collision& c : result.log) EXPECT_EQ(c.time, 2.0);
  }
}

}  // namespace
}  // namespace carom
