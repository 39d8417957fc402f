// All that a scene may hold, in every method: gravity, fixed and infinitely heavy balls, moving walls, circles, points,
// periods.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "sim/fixed_step/stepping.hpp"

namespace carom {
namespace {

using namespace testing;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Soft contacts are of first order in dt / t_c; all else is exact up to rounding.
double tolerance(const std::string& method) { return method == "penalty" ? 0.05 : 1e-12; }

// Semi-implicit Euler: v_n = -g n dt, x_n = x_0 - g dt^2 n (n + 1) / 2. Velocity Verlet: the parabola itself.
TEST(StepScenes, gravity) {
  Scene scene = open_space(2);
  scene.motion.acceleration = {0.0, -10.0};
  scene.balls = {ball({0.0, 0.0}, {1.0, 0.0}), ball({5.0, 0.0}, {0.0, 0.0})};
  scene.balls[1].fixed = true;
  for (const std::string& method : every_method) {
    const Stepped result = run_steps(scene, 0.125, method, 8);
    EXPECT_NEAR(result.balls[0].velocity[1], -10.0, 1e-13) << method;
    EXPECT_NEAR(result.balls[0].position[0], 1.0, 1e-13) << method;
    EXPECT_NEAR(result.balls[0].position[1], method == "penalty" ? -5.0 : -10.0 * 0.125 * 0.125 * 36, 1e-13) << method;
    EXPECT_EQ(result.balls[1].position[1], 0.0) << method << ": fixed balls do not fall";
    EXPECT_EQ(result.time, 1.0);
  }
}

// Against an infinite mass that moves at V, u becomes 2 V - u; it does not notice.
TEST(StepScenes, heavy_and_fixed_balls) {
  for (const std::string& method : every_method) {
    Scene scene = open_space(2);
    scene.balls = {ball({-2.0, 0.0}, {3.0, 0.0}, 0.5, infinite), ball({0.0, 0.0}, {-1.0, 0.0})};
    Stepped result = run_steps(scene, 1e-3, method, 1000);
    EXPECT_EQ(result.collisions(), 1) << method;
    EXPECT_EQ(result.balls[0].velocity[0], 3.0) << method;
    EXPECT_NEAR(result.balls[1].velocity[0], 7.0, 5 * tolerance(method)) << method;

    scene.balls = {ball({-2.0, 0.0}, {3.0, 0.0}), ball({0.0, 0.0}, {0.0, 0.0})};
    scene.balls[1].fixed = true;
    result = run_steps(scene, 1e-3, method, 1000);
    EXPECT_NEAR(result.balls[0].velocity[0], -3.0, 5 * tolerance(method)) << method;
    EXPECT_EQ(result.balls[1].position[0], 0.0) << method;
  }
}

TEST(StepScenes, moving_walls) {
  for (const std::string& method : every_method) {
    Scene scene = open_space(2);
    scene.walls = {plane({-2.0, 0.0}, {2.0, 0.0})};
    scene.walls[0].velocity = {1.0, 0.0};
    scene.balls = {ball({0.0, 0.0}, {0.0, 0.5})};
    Stepped result = run_steps(scene, 1e-3, method, 2500);  // from t = 1.5 on it flies ahead of the wall
    EXPECT_EQ(result.collisions(), 1) << method;
    EXPECT_NEAR(result.balls[0].velocity[0], 2.0, 5 * tolerance(method)) << method;
    EXPECT_NEAR(result.balls[0].position[0], 2.0, method == "penalty" ? 0.1 : 5e-3) << method;

    WallSpec bat;
    bat.kind = WallKind::segment;
    bat.from = {2.0, -1.0};
    bat.to = {2.0, 1.0};
    bat.velocity = {-1.0, 0.0};
    scene.walls = {bat};
    scene.balls[0].velocity = {1.0, 0.0};
    result = run_steps(scene, 1e-3, method, 2000);
    EXPECT_EQ(result.collisions(), 1) << method;
    EXPECT_NEAR(result.balls[0].velocity[0], -3.0, 5 * tolerance(method)) << method;
  }
}

// Inside a circle of radius 1 a ball of radius 0.1 along a diameter hits every 1.8, from outside once.
TEST(StepScenes, circles_and_spheres) {
  for (const std::string& method : every_method)
    for (int d = 2; d <= 3; ++d) {
      Coordinates centre(static_cast<std::size_t>(d), 0.0), velocity = centre, outside = centre;
      velocity[0] = 1.0;
      outside[0] = -2.0;
      Scene scene = open_space(d);
      scene.walls = {circle(centre, 1.0, WallSide::inside)};
      scene.balls = {ball(centre, velocity, 0.1)};
      Stepped result = run_steps(scene, 1e-3, method, 5000);  // at 0.9, 2.7, 4.5
      EXPECT_EQ(result.collisions(), 3) << method << " in " << d << "-D";
      EXPECT_NEAR(result.balls[0].velocity[0], -1.0, 3 * tolerance(method)) << method;

      scene.walls = {circle(centre, 1.0, WallSide::outside)};
      scene.balls = {ball(outside, velocity, 0.1)};
      result = run_steps(scene, 1e-3, method, 2000);
      EXPECT_EQ(result.collisions(), 1) << method;
      EXPECT_NEAR(result.balls[0].velocity[0], -1.0, tolerance(method)) << method;
    }
}

// Walls are numbered as in the event-driven mode: those of the scene, then the faces x-, x+, y-, ...
TEST(StepScenes, walls_have_the_numbers_of_the_event_driven_mode) {
  Scene scene = box({0.0, 0.0}, {4.0, 4.0});
  scene.walls = {plane({3.0, 0.0}, {-1.0, 0.0})};
  scene.balls = {ball({1.0, 2.0}, {1.0, 0.0}), ball({1.5, 1.0}, {0.0, -1.0}, 0.25), ball({1.0, 3.3}, {-1.0, 0.0}, 0.25)};
  const Result exact = run_until(scene, 2.9);
  ASSERT_GE(exact.log.size(), 4u);
  for (const std::string& method : every_method) {
    const Stepped result = run_steps(scene, 1e-3, method, 2900);
    std::size_t k = 0;
    for (const StepContact& c : result.contacts) {
      if (!(c.impulse > 0)) continue;
      ASSERT_LT(k, exact.log.size()) << method;
      EXPECT_EQ(c.kind, exact.log[k].kind) << method;
      EXPECT_EQ(c.ball, exact.log[k].ball.number) << method;
      EXPECT_EQ(c.partner, exact.log[k].partner.number) << method;
      EXPECT_NEAR(c.time, exact.log[k].time, method == "penalty" ? 0.1 : 0.01) << method;
      ++k;
    }
    EXPECT_EQ(k, exact.log.size()) << method;
  }
}

// A point between two faces; and, for what is swept, in a triangle of two-sided walls that it would slip through.
TEST(StepScenes, points_and_walls) {
  for (const std::string& method : every_method)
    for (int d = 1; d <= 3; ++d) {
      Scene scene = box(Coordinates(static_cast<std::size_t>(d), 0.0), Coordinates(static_cast<std::size_t>(d), 1.0));
      Coordinates v(static_cast<std::size_t>(d), 0.0);
      v[0] = 1.0;
      scene.balls = {ball(Coordinates(static_cast<std::size_t>(d), 0.5), v, 0.0)};
      const Stepped result = run_steps(scene, 1e-3, method, 3000);
      EXPECT_EQ(result.collisions(), 3) << method << " in " << d << "-D";
    }
  Scene billiard = open_space(2);
  WallSpec triangle;
  triangle.kind = WallKind::polygon;
  triangle.vertices = {{0.0, 0.0}, {4.0, 0.0}, {1.0, 3.0}};
  billiard.walls = {triangle};
  billiard.balls = {ball({1.5, 1.0}, {1.0, 0.37}, 0.0)};
  const Result exact = run_until(billiard, 50.0);
  for (const char* method : {"swept:substeps", "swept"}) {
    const Stepped result = run_steps(billiard, 0.01, method, 5000);
    EXPECT_EQ(result.collisions(), static_cast<std::int64_t>(exact.log.size())) << method;
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(result.balls[0].position[k], exact.balls[0].position[k], 1e-9) << method;
  }
}

// Under gravity a point falls back to a two-sided wall again and again and never through it.
TEST(StepScenes, a_point_bounces_on_a_line) {
  Scene scene = open_space(2);
  scene.motion.acceleration = {0.0, -10.0};
  WallSpec floor;
  floor.kind = WallKind::segment;
  floor.from = {-100.0, 0.3};
  floor.to = {100.0, 0.1};
  scene.walls = {floor};
  scene.collision.restitution = 0.7;
  scene.balls = {ball({0.0, 1.0}, {0.1, 0.0}, 0.0)};
  for (const char* method : {"swept", "swept:substeps"}) {
    const auto s = stepper(scene, 0.01, method);
    for (int n = 0; n < 3000; ++n) {
      s->step({});
      const auto b = s->balls()[0];
      ASSERT_GT(b.position[1] - (0.2 - 0.001 * b.position[0]), -1e-12) << method << " in step " << n;
    }
  }
}

// Through the periods: images are counted, and a meeting across the boundary happens.
TEST(StepScenes, periodic_space) {
  Scene scene = open_space(2);
  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {0.0, 0.0};
  scene.space.upper = {3.0, 2.0};
  scene.balls = {ball({0.2, 1.0}, {-1.0, 0.0}, 0.25), ball({2.0, 1.0}, {0.0, 0.0}, 0.25)};
  const Result exact = run_until(scene, 6.0);
  for (const std::string& method : every_method) {
    const Stepped result = run_steps(scene, 1e-3, method, 6000);
    EXPECT_EQ(result.collisions(), static_cast<std::int64_t>(exact.log.size())) << method;
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(result.balls[i].image, exact.balls[i].image) << method;
      const double far = result.balls[i].unwrapped_position[0];
      EXPECT_NEAR(far, exact.balls[i].unwrapped_position[0], method == "penalty" ? 0.2 : 0.01) << method;
      EXPECT_NEAR(result.balls[i].position[0] + 3.0 * double(result.balls[i].image[0]), far, 1e-12) << method;
      EXPECT_GE(result.balls[i].position[0], 0.0);
      EXPECT_LT(result.balls[i].position[0], 3.0);
    }
  }
}

// What overlaps is taken apart, half and half by inverse mass.
TEST(StepScenes, corrections_take_overlaps_back) {
  Scene scene = open_space(1);
  scene.balls = {ball({-0.6}, {1.0}, 0.5, 1.0), ball({0.5}, {0.0}, 0.5, 3.0)};
  scene.collision.restitution = 0.0;  // after the impact they go on together, at 1/4
  const auto overlap = [&](const char* method, std::int64_t steps) {
    const Stepped r = run_steps(scene, 0.25, method, steps);
    return 1.0 - (r.balls[1].position[0] - r.balls[0].position[0]);
  };
  EXPECT_NEAR(overlap("discrete:correction=none", 1), 0.15, 1e-15);
  EXPECT_NEAR(overlap("discrete:correction=none", 5), 0.15, 1e-15);
  EXPECT_NEAR(overlap("discrete", 1), 0.0, 1e-15);
  EXPECT_NEAR(overlap("discrete:correction=baumgarte:slop=0", 3), 0.15 * 0.8 * 0.8 * 0.8, 1e-15);
  EXPECT_NEAR(overlap("discrete:correction=baumgarte:slop=0:iterations=3", 1), 0.15 * 0.8 * 0.8 * 0.8, 1e-15);
  EXPECT_NEAR(overlap("discrete:correction=baumgarte:fraction=1:slop=0.1", 1), 0.05, 1e-15);
  EXPECT_NEAR(run_steps(scene, 0.25, "discrete", 1).balls[0].position[0], -0.35 - 0.15 * 0.75, 1e-15);
}

// Slower than the threshold there is no restitution.
TEST(StepScenes, restitution_threshold) {
  for (const std::string method : {"discrete", "swept", "swept:substeps", "speculative"})
    for (const double threshold : {0.99, 1.01}) {
      Scene scene = box({0.0}, {10.0});
      scene.balls = {ball({2.0}, {-1.0})};
      const Stepped r = run_steps(scene, 0.01, method + ":threshold=" + std::to_string(threshold), 200);
      EXPECT_NEAR(r.balls[0].velocity[0], threshold < 1 ? 1.0 : 0.0, 1e-12) << method;
    }
}

}  // namespace
}  // namespace carom
