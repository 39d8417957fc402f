// Row 13: resting contact. With e < 1 the impacts of a bouncing ball accumulate in finite time; a run that is not told how
// to go on stops there, with status 3 and the balls named. It neither hangs nor sinks nor loses energy from the books. One
// ball in 1-D is in tests/sim/whole_integrator_test.cpp (BouncingBall); clusters at one instant in contact_test.cpp
// (Persistent).

#include <algorithm>

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

void expect_named(const Result& result, std::vector<std::uint32_t> balls) {
  EXPECT_EQ(result.stop, Stop::collapse);
  ASSERT_TRUE(result.summary.stopped.has_value());
  EXPECT_FALSE(result.summary.stopped->reason.empty());
  for (const std::uint32_t b : balls)
    EXPECT_EQ(std::count(result.summary.stopped->balls.begin(), result.summary.stopped->balls.end(), b), 1)
        << "ball " << b << " is not named";
}

// Dropped from h: sqrt(2 h / g) (1 + e) / (1 - e), in 2-D and 3-D, on planes, faces, segments and fixed balls.
TEST(RestingContact, of_a_bouncing_ball_is_recognised_on_every_wall) {
  for (const double e : {0.1, 0.5, 0.9, 0.99})
    for (int kind = 0; kind < 4; ++kind)
      for (int d = kind == 2 ? 2 : 1; d <= (kind == 2 ? 2 : 3); ++d) {
        Scene scene = open_space(d);
        scene.collision.restitution = e;
        Coordinates x(std::size_t(d), 0.0), g(std::size_t(d), 0.0), up(std::size_t(d), 0.0);
        g.back() = -2.0;
        up.back() = 1.0;
        scene.motion.acceleration = g;
        if (kind == 0) scene.walls = {plane(x, up)};
        if (kind == 1) {
          scene.space.kind = SpaceKind::box;
          scene.space.lower = Coordinates(std::size_t(d), -5.0);
          scene.space.lower.back() = 0.0;
          scene.space.upper = Coordinates(std::size_t(d), 5.0);
        }
        if (kind == 2) scene.walls = {segment({-5.0, 0.0}, {5.0, 0.0})};
        x.back() = 0.5 + 1.0;
        scene.balls = {ball(x, {})};
        if (kind == 3) {
          x.back() = -0.5;
          scene.balls.push_back(fixed_ball(x));
        }
        const Result result = watched_run(scene, {.events = 100'000, .until = 1e4, .stride = 17});
        SCOPED_TRACE("e " + std::to_string(e) + ", kind " + std::to_string(kind) + ", " + std::to_string(d) + "-D");
        expect_named(result, {0});
        EXPECT_NEAR(result.summary.time, (1 + e) / (1 - e), 1e-9);
        EXPECT_NEAR(result.balls[0].position.back(), 0.5, 1e-9);
      }
}

// A stack of three on a floor, dropped together, and a ball that rolls along the floor as it comes to rest.
TEST(RestingContact, of_a_stack_and_of_a_rolling_ball) {
  for (const double e : {0.3, 0.8}) {
    Scene scene = open_space(2);
    scene.collision.restitution = e;
    scene.motion.acceleration = {0.0, -1.0};
    scene.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
    scene.balls = {ball({0.0, 1.5}, {0.3, 0.0}), ball({0.0, 2.5}, {0.3, 0.0}), ball({0.0, 3.5}, {0.3, 0.0})};
    const Result stack = watched_run(scene, {.events = 200'000, .until = 1e4, .stride = 101});
    expect_named(stack, {0});
    scene.balls.resize(1);
    const Result one = watched_run(scene, {.events = 200'000, .until = 1e4, .stride = 101});
    expect_named(one, {0});
    EXPECT_EQ(one.balls[0].velocity[0], 0.3) << "nothing acts along the floor";
  }
}

// Perfectly plastic on a floor: one impact, and it rests at once.
TEST(RestingContact, of_a_plastic_ball_begins_at_its_first_impact) {
  Scene scene = open_space(2);
  scene.collision.restitution = 0.0;
  scene.motion.acceleration = {0.0, -2.0};
  scene.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
  scene.balls = {ball({0.0, 1.5}, {})};
  const Result result = watched_run(scene, {.events = 10'000, .until = 1e3});
  expect_named(result, {0});
  EXPECT_EQ(result.summary.time, 1.0);
  EXPECT_DOUBLE_EQ(result.summary.energy.dissipated, 2.0);
}

// At rest on a floor under gravity from the start, elastic or not: the contact never ends.
TEST(RestingContact, from_the_start) {
  for (const double e : {1.0, 0.5}) {
    Scene scene = open_space(2);
    scene.collision.restitution = e;
    scene.motion.acceleration = {0.0, -2.0};
    scene.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
    scene.balls = {ball({0.0, 0.5}, {})};
    const Result result = watched_run(scene, {.events = 10'000, .until = 1e3});
    expect_named(result, {0});
    EXPECT_EQ(result.summary.time, 0.0);
  }
}

// Elastic balls never come to rest: a thousand bounces of two stacked ones are no collapse.
TEST(RestingContact, is_none_for_elastic_balls) {
  Scene scene = open_space(1);
  scene.motion.acceleration = {-1.0};
  scene.walls = {plane({0.0}, {1.0})};
  scene.balls = {ball({1.5}, {}, 0.5, 3.0), ball({4.0}, {}, 0.5, 1.0)};
  const Result result = watched_run(scene, {.events = scaled_count(20'000), .stride = 57, .energy_error = 1e-13});
  EXPECT_EQ(result.stop, Stop::events);
}

}  // namespace
}  // namespace carom
