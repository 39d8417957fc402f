// On which side of the walls a ball is: every kind of wall that closes.

#include "carom/observe/enclosures.hpp"

#include <gtest/gtest.h>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

bool escaped(Scene scene, const Triple& start, const Triple& end, double elapsed = 0.0) {
  Subject subject;
  subject.dimension = scene.dimension;
  subject.space = scene.space.kind;
  for (std::size_t k = 0; k < scene.space.upper.size(); ++k) subject.edge[k] = scene.space.upper[k] - scene.space.lower[k];
  return Enclosures(scene, subject, {start}).escaped(0, end, elapsed);
}

WallSpec polygon(std::vector<Coordinates> vertices) {
  WallSpec w;
  w.kind = WallKind::polygon;
  w.vertices = std::move(vertices);
  return w;
}

WallSpec segment(Coordinates from, Coordinates to) {
  WallSpec w;
  w.kind = WallKind::segment;
  w.from = std::move(from);
  w.to = std::move(to);
  return w;
}

TEST(Enclosures, of_a_box_are_its_faces) {
  for (int d = 1; d <= 3; ++d) {
    const Scene scene = box(Coordinates(static_cast<std::size_t>(d), -1.0), Coordinates(static_cast<std::size_t>(d), 2.0));
    EXPECT_FALSE(escaped(scene, {}, {1.9, d > 1 ? -0.9 : 0, d > 2 ? 1.9 : 0}));
    for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k)
      for (const double x : {-1.1, 2.1}) {
        Triple end{};
        end[k] = x;
        EXPECT_TRUE(escaped(scene, {}, end)) << d << "-D, axis " << k << ", " << x;
      }
  }
}

TEST(Enclosures, a_plane_keeps_its_balls_and_may_move) {
  Scene scene = open_space(2);
  scene.walls = {plane({1, 0}, {2, 0})};
  EXPECT_FALSE(escaped(scene, {3, 0}, {1.1, 50}));
  EXPECT_TRUE(escaped(scene, {3, 0}, {0.9, 50}));
  scene.walls[0].velocity = {0.5, 0};
  EXPECT_TRUE(escaped(scene, {3, 0}, {1.9, 0}, 2.0)) << "it is at x = 2 by then";
  EXPECT_FALSE(escaped(scene, {3, 0}, {2.1, 0}, 2.0));
}

TEST(Enclosures, circles_hold_or_keep_out) {
  Scene scene = open_space(2);
  scene.walls = {circle({0, 0}, 2, WallSide::inside)};
  EXPECT_FALSE(escaped(scene, {}, {1.4, -1.4}));
  EXPECT_TRUE(escaped(scene, {}, {1.5, -1.5}));
  scene.walls = {circle({0, 0}, 2, WallSide::outside)};
  EXPECT_TRUE(escaped(scene, {3, 0}, {1.4, -1.4}));
  EXPECT_FALSE(escaped(scene, {3, 0}, {1.5, -1.5}));
}

// An L: the point (2, 2) lies in its notch, outside.
TEST(Enclosures, a_polygon_has_two_sides) {
  Scene scene = open_space(2);
  scene.walls = {polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}})};
  EXPECT_FALSE(escaped(scene, {0.5, 0.5}, {2.5, 0.5}));
  EXPECT_TRUE(escaped(scene, {0.5, 0.5}, {2, 2}));
  EXPECT_FALSE(escaped(scene, {2, 2}, {-5, -5}));
  EXPECT_TRUE(escaped(scene, {2, 2}, {0.5, 2.5}));
}

// Three segments that close up are a triangle; two of them are a corner that one can walk round.
TEST(Enclosures, segments_count_where_they_close_up) {
  Scene scene = open_space(2);
  scene.walls = {segment({0, 0}, {4, 0}), segment({0, 4}, {0, 0}), segment({4, 0}, {0, 4})};
  EXPECT_TRUE(escaped(scene, {1, 1}, {3, 3}));
  EXPECT_FALSE(escaped(scene, {1, 1}, {0.5, 3}));
  scene.walls.pop_back();
  EXPECT_FALSE(escaped(scene, {1, 1}, {-3, -3}));
}

// A round obstacle on the edge of a periodic cell is in the way on both sides of it.
TEST(Enclosures, obstacles_repeat_with_the_cell) {
  Scene scene = box({0, 0}, {10, 10});
  scene.space.kind = SpaceKind::periodic;
  scene.walls = {circle({0, 5}, 2, WallSide::outside)};
  EXPECT_TRUE(escaped(scene, {5, 5}, {1, 5}));
  EXPECT_TRUE(escaped(scene, {5, 5}, {9, 5}));
  EXPECT_FALSE(escaped(scene, {5, 5}, {7, 5}));
  EXPECT_FALSE(escaped(scene, {5, 5}, {5, 11})) << "there are no faces";
}

}  // namespace
}  // namespace carom
