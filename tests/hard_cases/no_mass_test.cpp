// Row 20: a mass of 0 has no mechanics and is refused; two infinite masses that meet have none either, and the run stops
// there (moving ones: tests/sim/stop_test.cpp). Fixed balls may touch and overlap each other: they never meet.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

const double infinite_mass = std::numeric_limits<double>::infinity();

TEST(Mass, of_nothing_is_refused) {
  for (const double mass : {0.0, -0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), -infinite_mass}) {
    Scene scene = open_space(2);
    scene.balls = {ball({0.0, 0.0}, {}, 0.5, mass)};
    EXPECT_EQ(refusals(scene).size(), 1u) << mass;
  }
}

// An infinite mass against a fixed ball, in every dimension; named, at the moment that they meet.
TEST(Mass, infinite_on_both_sides_stops_the_run) {
  for (int d = 1; d <= 3; ++d) {
    Scene scene = open_space(d);
    Coordinates x(std::size_t(d), 0.0), v(std::size_t(d), 0.0);
    v[0] = 2.0;
    scene.balls.push_back(ball(x, v, 0.5, infinite_mass));
    x[0] = 4.0;
    scene.balls.push_back(fixed_ball(x));
    const Result result = watched_run(scene, {.until = 10.0});
    EXPECT_EQ(result.stop, Stop::collapse);
    ASSERT_TRUE(result.summary.stopped.has_value());
    EXPECT_EQ(result.summary.stopped->balls, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(result.summary.stopped->time, 1.5);
  }
}

// Two that separate, or that never meet, do no harm; nor do fixed balls that overlap each other.
TEST(Mass, infinite_on_both_sides_may_pass) {
  Scene scene = open_space(2);
  scene.balls = {ball({0.0, 0.0}, {1.0, 0.0}, 0.5, infinite_mass), ball({2.0, 1.5}, {-1.0, 0.0}, 0.5, infinite_mass),
                 fixed_ball({10.0, 10.0}), fixed_ball({10.25, 10.0}), ball({8.0, 10.0}, {1.0, 0.0})};
  const Result result = watched_run(scene, {.until = 20.0});
  EXPECT_EQ(result.stop, Stop::no_events_left);
  EXPECT_EQ(result.log.size(), 1u) << "the last ball turns at the first fixed one";
}

// Squeezed between a piston of infinite mass and a wall: the speed grows without bound as the gap closes, 2 V a cycle. In
// the end there is no room; the run must stop by itself, or go on counting hits that come ever faster, but never lose the
// ball.
TEST(Mass, squeezed_between_two_infinite_ones) {
  Scene scene = open_space(1);
  scene.walls = {plane({0.0}, {1.0})};
  scene.balls = {ball({0.75}, {0.25}), ball({4.0}, {-1.0}, 0.5, infinite_mass)};
  const Result result = watched_run(scene, {.events = 2000});
  EXPECT_GT(std::abs(result.balls[0].velocity[0]), 100.0);
  EXPECT_TRUE(std::isfinite(result.balls[0].velocity[0]));
  EXPECT_LE(result.summary.time, 2.5);
}

}  // namespace
}  // namespace carom
