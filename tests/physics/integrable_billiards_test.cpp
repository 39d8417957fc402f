// Billiards whose orbits are known in closed form: the circle and the rectangle.

#include <gtest/gtest.h>

#include <numbers>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

constexpr double pi = std::numbers::pi;

double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * pi)); }

// L = x v_y - y v_x = sin(alpha) is conserved; the hits advance by pi - 2 alpha, and all chords are equal.
void expect_circle(double radius_of_ball) {
  Scene scene = open_space(2);
  scene.walls.push_back(circle({0.0, 0.0}, 1.0 + radius_of_ball, WallSide::inside));
  scene.balls.push_back(ball({0.2, -0.1}, {std::cos(0.6), std::sin(0.6)}, radius_of_ball));
  const double L = 0.195462056169975, theta0 = 0.403271427996762, step = 2.748135509583317, chord = 1.961422529286136;
  const Result result = run(scene, 1001);
  ASSERT_EQ(result.log.size(), 1001u);
  for (std::size_t k = 0; k <= 1000; ++k) {
    const Collision& c = result.log[k];
    const double theta = std::atan2(c.ball.position[1], c.ball.position[0]);
    EXPECT_LE(angle_between(theta, theta0 + double(k) * step), 1e-10) << "hit " << k;
    EXPECT_NEAR(std::hypot(c.ball.position[0], c.ball.position[1]), 1.0, 1e-13);
    EXPECT_NEAR(c.ball.position[0] * c.ball.velocity_after[1] - c.ball.position[1] * c.ball.velocity_after[0], L, 1e-13);
    EXPECT_NEAR(c.time - (k > 0 ? result.log[k - 1].time : c.time - chord), chord, 2e-12);
  }
  const auto& last = result.log[1000].ball.position;
  EXPECT_LE(angle_between(std::atan2(last[1], last[0]), 2.78680177384), 1e-10);
  EXPECT_LE(result.summary.energy.relative_error, 1e-14);
}

TEST(CircleBilliard, hits_advance_by_a_constant_angle) { expect_circle(0.0); }
TEST(CircleBilliard, a_disk_sees_a_smaller_circle) { expect_circle(0.25); }

// Along the wall: chords of 2e-6 to 2e-2, a hundred thousand hits; the angle of incidence is conserved.
TEST(CircleBilliard, whispering_gallery) {
  for (const double alpha : {1e-2, 1e-4, 1e-6}) {  // between path and wall
    Scene scene = open_space(2);
    scene.walls.push_back(circle({0.0, 0.0}, 1.0, WallSide::inside));
    // From the middle of a chord: at distance cos(alpha) from the centre, tangentially.
    scene.balls.push_back(ball({std::cos(alpha), 0.0}, {0.0, 1.0}, 0.0));
    const std::int64_t hits = scaled_count(100'000);
    const Result result = run(scene, hits);
    ASSERT_EQ(result.stop, Stop::events) << "alpha " << alpha;
    // 1 - cos(alpha) is known to u only, so alpha to u / alpha.
    const double known = 1e-15 / alpha + 1e-12;
    const double flight = result.log.back().time - result.log.front().time;
    EXPECT_NEAR(flight / (2 * std::sin(alpha) * double(hits - 1)), 1.0, 10 * known / alpha) << "alpha " << alpha;
    EXPECT_EQ(result.summary.exactness.clamped, 0);
    EXPECT_LE(result.summary.exactness.max_gap_error, 2e-16 * std::sqrt(double(hits)) + 1e-15);
    EXPECT_LE(result.summary.energy.relative_error, 1e-13);
  }
}

// Exactly along the wall there is no chord: the ball presses against the wall for ever, and that is said.
TEST(CircleBilliard, motion_along_the_wall_is_named) {
  Scene scene = open_space(2);
  scene.walls.push_back(circle({0.0, 0.0}, 1.0, WallSide::inside));
  scene.balls.push_back(ball({1.0, 0.0}, {0.0, 1.0}, 0.0));
  Simulation simulation(scene);
  const Stop stop = simulation.advance(Number(1.0), 100'000);
  EXPECT_EQ(stop, Stop::collapse) << "a ball that presses against a wall for ever must be named, not counted without end";
  EXPECT_EQ(simulation.summary().energy.relative_error, 0.0);
}

// Reflections fold the line x0 + v t into [0, L]: a triangle wave.
double fold(double x, double length) {
  double y = std::fmod(x, 2 * length);
  if (y < 0) y += 2 * length;
  return y <= length ? y : 2 * length - y;
}

void expect_rectangle(double radius_of_ball, double until, double x, double y, std::int64_t hits_x, std::int64_t hits_y) {
  const double R = radius_of_ball;
  Scene scene = box({-R, -R}, {1.0 + R, 0.6 + R});
  scene.balls.push_back(ball({0.3, 0.21}, {std::sqrt(2.0), 1.0}, R));
  Simulation simulation(scene);
  std::int64_t across_x = 0, across_y = 0;
  simulation.advance(Number(until), std::nullopt, [&](const Collision& c) {
    (simulation.wall_label(c.partner.number)[0] == 'x' ? across_x : across_y) += 1;
  });
  EXPECT_EQ(across_x, hits_x);
  EXPECT_EQ(across_y, hits_y);
  const BallState b = simulation.ball(0);
  EXPECT_NEAR(b.position[0], x, 1e-10 * until);
  EXPECT_NEAR(b.position[1], y, 1e-10 * until);
  EXPECT_NEAR(b.position[0], fold(0.3 + std::sqrt(2.0) * until, 1.0), 1e-13 * until);
  EXPECT_NEAR(b.position[1], fold(0.21 + until, 0.6), 1e-13 * until);
  EXPECT_EQ(std::abs(b.velocity[0]), std::sqrt(2.0)) << "a face reverses one component, exactly";
  EXPECT_EQ(std::abs(b.velocity[1]), 1.0);
}

TEST(RectangleBilliard, unfolds_to_a_straight_line) {
  for (const double R : {0.0, 0.125}) {
    expect_rectangle(R, 100.0, 0.27864376269049, 0.59, 141, 167);
    expect_rectangle(R, 1e4, 0.4356237309512, 0.59, 14142, 16667);
  }
}

}  // namespace
}  // namespace carom
