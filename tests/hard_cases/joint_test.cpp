// Row 8: joints of segments and of a polygon's edges. A ray aimed at a vertex, or beside it by 1e-16 .. 1e-8, from any
// side, must not get through: whether it runs to the left or to the right of the vertex is one sign for both edges. Long
// runs inside polygons are in tests/sim/whole_integrator_test.cpp (Polygon).

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

/// A star of 14 vertices, every other one reflex; turned, so that no coordinate is round.
std::vector<Coordinates> star(double turn) {
  std::vector<Coordinates> vertices;
  for (int k = 0; k < 14; ++k) {
    const double angle = turn + 2 * 3.141592653589793 * k / 14, r = k % 2 == 0 ? 2.0 : 1.25;
    vertices.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return vertices;
}

/// The same outline as a polygon, or as segments that share their ends.
std::vector<WallSpec> outline(const std::vector<Coordinates>& vertices, bool one_wall) {
  if (one_wall) return {polygon(vertices)};
  std::vector<WallSpec> walls;
  for (std::size_t k = 0; k < vertices.size(); ++k)
    walls.push_back(segment(vertices[k], vertices[(k + 1) % vertices.size()]));
  return walls;
}

/// Crossing number.
bool inside(const std::vector<Coordinates>& vertices, double x, double y) {
  bool in = false;
  for (std::size_t k = 0, last = vertices.size() - 1; k < vertices.size(); last = k++) {
    const double xa = vertices[k][0], ya = vertices[k][1], xb = vertices[last][0], yb = vertices[last][1];
    if ((ya > y) != (yb > y) && x < (xb - xa) * (y - ya) / (yb - ya) + xa) in = !in;
  }
  return in;
}

const double offsets[] = {0.0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-8, -1e-8};

// Points inside: after each hit the middle of the flight to the next one must be inside too.
TEST(Joint, lets_no_ray_out) {
  for (const double turn : {0.0, 0.1, 0.77})
    for (const bool one_wall : {true, false}) {
      const std::vector<Coordinates> vertices = star(turn);
      Scene scene = open_space(2);
      scene.walls = outline(vertices, one_wall);
      Dice dice(81);
      for (const Coordinates& vertex : vertices)
        for (const double offset : offsets) {
          const double x = dice.between(-0.4, 0.4), y = dice.between(-0.4, 0.4);
          const double dx = vertex[0] - x, dy = vertex[1] - y, length = std::hypot(dx, dy);
          scene.balls = {ball({x, y}, {(dx - offset * dy / length) / length, (dy + offset * dx / length) / length}, 0.0)};
          const Result result = watched_run(scene, {.events = 12});
          ASSERT_EQ(result.log.size(), 12u) << "it got out: turn " << turn << " offset " << offset;
          for (std::size_t k = 0; k + 1 < result.log.size(); ++k) {
            const auto &a = result.log[k].ball.position, &b = result.log[k + 1].ball.position;
            if (std::hypot(a[0] - b[0], a[1] - b[1]) < 1e-6) continue;  // along an edge or into a corner
            ASSERT_TRUE(inside(vertices, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2)) << "turn " << turn << " offset " << offset;
          }
        }
    }
}

// From outside: no ray gets in.
TEST(Joint, lets_no_ray_in) {
  for (const double turn : {0.0, 0.1, 0.77}) {
    const std::vector<Coordinates> vertices = star(turn);
    Scene scene = open_space(2);
    scene.walls = outline(vertices, true);
    for (const Coordinates& vertex : vertices)
      for (const double offset : offsets)
        for (const double angle : {-0.3, 0.0, 0.2}) {
          const double c = std::cos(angle), s = std::sin(angle);
          const double dx = -(c * vertex[0] - s * vertex[1]), dy = -(s * vertex[0] + c * vertex[1]);
          scene.balls = {ball({vertex[0] - 3 * dx - offset * dy, vertex[1] - 3 * dy + offset * dx}, {dx, dy}, 0.0)};
          const Result result = watched_run(scene, {.events = 50});
          EXPECT_EQ(result.stop, Stop::no_events_left);
          EXPECT_GE(result.log.size(), 1u) << "it got in, or through: turn " << turn << " offset " << offset;
          const BallState& b = result.balls[0];
          EXPECT_FALSE(inside(vertices, b.position[0] + 1e-3 * b.velocity[0], b.position[1] + 1e-3 * b.velocity[1]));
        }
  }
}

// Disks aimed at every joint of a closed chain: they stay within.
TEST(Joint, lets_no_disk_out) {
  for (const double radius : {1e-12, 1e-3, 0.3})
    for (const bool one_wall : {true, false}) {
      const std::vector<Coordinates> vertices = star(0.1);
      Scene scene = open_space(2);
      scene.walls = outline(vertices, one_wall);
      for (const Coordinates& vertex : vertices)
        for (const double offset : offsets) {
          const double length = std::hypot(vertex[0].value, vertex[1].value);
          scene.balls = {
              ball({0.0, 0.0},
                   {(vertex[0] - offset * vertex[1] / length) / length, (vertex[1] + offset * vertex[0] / length) / length},
                   radius)};
          const Result result = watched_run(scene, {.events = 40});
          ASSERT_EQ(result.log.size(), 40u);
          EXPECT_TRUE(inside(vertices, result.balls[0].position[0], result.balls[0].position[1]));
        }
    }
}

// Under gravity the path is a parabola; a point that falls on a joint of a floor of segments does not fall through.
TEST(Joint, of_a_floor_holds_what_falls) {
  for (const double offset : offsets)
    for (const double slope : {0.0, 0.3, -0.7})
      for (const double radius : {0.0, 0.1}) {
        Scene scene = open_space(2);
        scene.motion.acceleration = {0.0, -1.0};
        for (int k = -3; k < 3; ++k)
          scene.walls.push_back(segment({double(k), k % 2 == 0 ? 0.0 : slope}, {k + 1.0, k % 2 == 0 ? slope : 0.0}));
        scene.balls = {ball({offset, 2.0}, {0.0, 0.0}, radius)};
        const Result result = watched_run(scene, {.until = 2.5});
        ASSERT_GE(result.log.size(), 1u) << "offset " << offset << " slope " << slope;
        EXPECT_GT(result.log[0].ball.velocity_after[1], result.log[0].ball.velocity_before[1]);
        EXPECT_LE(std::abs(result.log[0].ball.position[1]), 0.11);
      }
}

// Ends that nearly meet are a mistake that lets a point out: named with both walls and the gap. The same numbers, or a gap
// that can be seen, are meant.
TEST(Joint, that_nearly_meets_is_refused) {
  for (const double gap : {0.0, 1e-16, 1e-9, 0.9e-6, 1.1e-6, 0.01}) {
    Scene scene = open_space(2);
    scene.walls = {segment({0.0, 0.0}, {1.0, 0.0}), segment({1.0, gap}, {1.0, 1.0})};
    scene.balls = {ball({0.5, 0.5}, {0.0, 0.0}, 0.0)};
    const std::vector<std::string> texts = refusals(scene);
    ASSERT_EQ(texts.size(), gap > 0 && gap < 1e-6 ? 1u : 0u) << gap;
    if (gap == 1e-9) {
      EXPECT_NE(texts[0].find("wall 0 and wall 1 do not meet: their ends are 1e-09 apart"), std::string::npos) << texts[0];
    }
  }
}

}  // namespace
}  // namespace carom
