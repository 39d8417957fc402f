// Balls against thin plates: what is seen of them, and what goes through.

#include <cmath>

#include <gtest/gtest.h>

#include "sim/fixed_step/stepping.hpp"

namespace carom {
namespace {

using namespace testing;

constexpr double radius = 0.05;

/// An upright plate of thickness w at x = 0..w.
WallSpec plate(double w) {
  WallSpec wall;
  if (w == 0) {
    wall.kind = WallKind::segment;
    wall.from = {0.0, -5.0};
    wall.to = {0.0, 5.0};
  } else {
    wall.kind = WallKind::polygon;
    wall.vertices = {{0.0, -5.0}, {w, -5.0}, {w, 5.0}, {0.0, 5.0}};
  }
  return wall;
}

struct Shares {
  double unseen = 0, through = 0;
};

/// Of balls that fly at the plate in steps whose normal part is `length`, over `starts` places of the first step.
Shares shot_at(double w, double length, const std::string& method, int starts) {
  Shares shares;
  for (int n = 0; n < starts; ++n) {
    Scene scene = open_space(2);
    scene.walls = {plate(w)};
    scene.balls = {ball({-2.0 - length * (n + 0.5) / starts, 0.1}, {1.0, 0.3}, radius)};
    const Stepped result = run_steps(scene, length, method, static_cast<std::int64_t>(std::ceil(3.0 / length)));
    shares.unseen += result.contacts.empty();
    shares.through += result.balls[0].position[0] > w;
  }
  shares.unseen /= starts;
  shares.through /= starts;
  return shares;
}

// A step sees the plate where the centre is from a before it to a behind it: over w + 2 a. So it tunnels unseen if and only
// if |v_n| dt > w + 2 a, with probability 1 - (w + 2 a) / (|v_n| dt).
TEST(Plate, discrete_tunnels_unseen_beyond_thickness_and_two_radii) {
  for (const double w : {0.0, 0.02, 0.08}) {
    const double zone = w + 2 * radius;
    for (const double share : {0.5, 0.99, 1.01, 1.25, 2.0, 4.0})
      EXPECT_NEAR(shot_at(w, share * zone, "discrete", 400).unseen, std::max(0.0, 1 - 1 / share), 1.5 / 400)
          << "w = " << w << ", step = " << share << " (w + 2 a)";
  }
}

// A wall without thickness acts towards the side that the centre is on, so it turns back only who is seen before the
// centre has passed: balls go through from |v_n| dt > a on.
TEST(Plate, discrete_goes_through_a_line_from_one_radius_on) {
  for (const double share : {0.5, 0.99, 1.01, 1.5, 3.0})
    EXPECT_NEAR(shot_at(0.0, share * radius, "discrete", 400).through, std::max(0.0, 1 - 1 / share), 1.5 / 400) << share;
}

TEST(Plate, continuous_methods_let_nothing_through) {
  for (const char* method : {"swept", "swept:substeps", "speculative"})
    for (const double length : {0.03, 0.3, 1.7})
      for (const double w : {0.0, 0.02}) EXPECT_EQ(shot_at(w, length, method, 50).through, 0.0) << method << " " << length;
}

// Once through, a ball is not pushed back to where it came from: it stays on the side of its centre.
TEST(Plate, keeps_the_side_of_the_centre) {
  for (const std::string& method : every_method)
    for (const double side : {-1.0, 1.0}) {
      Scene scene = open_space(2);
      scene.walls = {plate(0.0)};
      scene.balls = {ball({side * 0.2, 0.0}, {-side, 0.0}, radius)};
      const Stepped result = run_steps(scene, 0.001, method, 1000);
      EXPECT_EQ(result.collisions(), 1) << method;
      EXPECT_NEAR(result.balls[0].velocity[0], side, 0.02) << method;
      EXPECT_GT(side * result.balls[0].position[0], radius) << method;
    }
}

// Beside its end a plate is met at the end, and a ball that grazes the flat side near it does not feel it as a bump.
TEST(Plate, its_ends_are_points) {
  for (const std::string& method : every_method) {
    Scene scene = open_space(2);
    scene.walls = {plate(0.0)};
    scene.balls = {ball({0.0, 6.0}, {0.0, -1.0}, radius)};
    Stepped result = run_steps(scene, 0.001, method, 2000);
    EXPECT_EQ(result.collisions(), 1) << method;
    EXPECT_NEAR(result.balls[0].velocity[1], 1.0, 0.02) << method;
    ASSERT_FALSE(result.contacts.empty());
    EXPECT_EQ(result.contacts[0].kind, EventKind::ball_wall);
    EXPECT_EQ(result.contacts[0].feature, 2) << "edge 0, then the ends 1 (from) and 2 (to)";

    scene.balls = {ball({-0.3, 4.6}, {0.2, 0.3}, radius)};  // meets the flat side 0.03 below the end, on its way to it
    result = run_steps(scene, 0.001, method, 3000);
    EXPECT_EQ(result.collisions(), 1) << method;
    EXPECT_EQ(result.contacts[0].feature, 0) << method;
    EXPECT_NEAR(result.balls[0].velocity[1], 0.3, 1e-12) << method;
  }
}

}  // namespace
}  // namespace carom
