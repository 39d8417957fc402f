// Where on a wall a ball hits it: curvature and arclength in the record of a collision.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

Collision first_hit(const Scene& scene) {
  const Result result = run(scene, 1);
  return result.log.empty() ? Collision{} : result.log.front();
}

// A walk round the box with the inside to the left goes along y-, x+, y+, x-; each face counts from where the walk comes to it.
TEST(WallPlace, of_the_faces_of_a_box) {
  struct Aim {
    Coordinates velocity;
    double arclength;
  };
  for (const Aim& aim : {Aim{{0.0, -1.0}, 2.0}, Aim{{1.0, 0.0}, 1.0}, Aim{{0.0, 1.0}, 8.0}, Aim{{-1.0, 0.0}, 4.0}}) {
    Scene scene = box({-1.0, 2.0}, {9.0, 7.0});
    scene.balls = {ball({1.0, 3.0}, aim.velocity, 0.25)};
    const Collision c = first_hit(scene);
    EXPECT_EQ(c.arclength, aim.arclength);
    EXPECT_EQ(c.curvature, 0.0);
  }
}

TEST(WallPlace, of_a_plane_and_a_segment) {
  Scene scene = open_space(2);
  scene.walls = {plane({1.0, 5.0}, {0.0, -2.0})};
  scene.balls = {ball({-2.0, 0.0}, {0.0, 1.0}, 0.25)};
  EXPECT_EQ(first_hit(scene).arclength, 3.0) << "under a ceiling the walk goes to the left";
  scene.walls = {segment({0.0, 0.0}, {4.0, 0.0})};
  for (const double side : {1.0, -1.0}) {
    scene.balls = {ball({1.5, side}, {0.0, -side}, 0.25)};
    EXPECT_EQ(first_hit(scene).arclength, 1.5);
    EXPECT_EQ(first_hit(scene).curvature, 0.0);
  }
  scene.balls = {ball({5.0, 0.0}, {-1.0, 0.0}, 0.25)};
  EXPECT_EQ(first_hit(scene).curvature, std::numeric_limits<double>::infinity()) << "its end";
}

TEST(WallPlace, of_a_circle_from_either_side) {
  const double pi = std::numbers::pi, R = 2.0;
  Scene scene = open_space(2);
  scene.walls = {circle({1.0, 1.0}, R, WallSide::inside)};
  scene.balls = {ball({1.0, 1.0}, {0.0, -1.0}, 0.25)};
  EXPECT_EQ(first_hit(scene).curvature, -1 / R);
  EXPECT_NEAR(first_hit(scene).arclength, 1.5 * pi * R, 1e-14);
  scene.walls[0].side = WallSide::outside;
  scene.balls = {ball({-5.0, 1.0}, {1.0, 0.0}, 0.25)};
  EXPECT_EQ(first_hit(scene).curvature, 1 / R);
  EXPECT_NEAR(first_hit(scene).arclength, pi * R, 1e-14);
}

TEST(WallPlace, has_no_arclength_in_space) {
  Scene scene = open_space(3);
  scene.walls = {circle({0.0, 0.0, 0.0}, 4.0, WallSide::inside)};
  scene.balls = {ball({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5)};
  EXPECT_EQ(first_hit(scene).curvature, -0.25);
  EXPECT_EQ(first_hit(scene).arclength, 0.0);
}

}  // namespace
}  // namespace carom
