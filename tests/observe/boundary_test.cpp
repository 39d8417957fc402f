// The boundary as one line, and what is measured on it, for orbits that are known in closed form.

#include "carom/observe/boundary.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "observe/measure.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using testing::ball;
using testing::measure;
using testing::Measured;

constexpr double pi = std::numbers::pi;

using Rows = std::vector<std::vector<double>>;

/// What streams to the table `name`.
Rows streamed(const Scene& scene, const std::string& name) {
  Rows rows;
  Simulation simulation(scene);
  Observers observers(scene, simulation);
  observers.stream(name, [&](std::span<const double> row) { rows.emplace_back(row.begin(), row.end()); });
  simulation.run(observers.sink());
  observers.end(simulation);
  return rows;
}

/// Reference: a point in the unit circle from (0.2, -0.1) at the angle 0.6. Impact parameter L = sin alpha =
/// 0.195462056169975; it hits at theta_0 = 0.403271427996762, then pi - 2 alpha = 2.748135509583317 further each time.
Scene circle(std::int64_t events) {
  Scene scene = testing::open_space(2);
  scene.balls = {ball({0.2, -0.1}, {std::cos(0.6), std::sin(0.6)}, 0)};
  scene.walls = {testing::circle({0, 0}, 1, WallSide::inside)};
  scene.run.events = events;
  return scene;
}

TEST(BoundaryMap, of_a_circle) {
  Scene scene = circle(1000);
  scene.observe.boundary_map.emplace();
  const Rows rows = streamed(scene, "boundary_map");
  ASSERT_EQ(rows.size(), 1000u);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double theta = std::fmod(0.403271427996762 + static_cast<double>(k) * 2.748135509583317, 2 * pi);
    EXPECT_NEAR(std::remainder(rows[k][0] - theta, 2 * pi), 0, 1e-11);
    EXPECT_NEAR(rows[k][1], 0.195462056169975, 1e-12);
    EXPECT_EQ(rows[k][2], 0);
    EXPECT_EQ(rows[k][4], 0);
  }
  scene.observe.after_events = 990;
  EXPECT_EQ(streamed(scene, "boundary_map").size(), 10u);
}

TEST(RotationNumber, of_a_circle) {
  Scene scene = circle(1001);
  scene.observe.rotation_number = scene.observe.caustic = true;
  const Measured m = measure(scene);
  EXPECT_NEAR(m["rotation_number"], 2.748135509583317 / (2 * pi), 1e-13);
  EXPECT_NEAR(m["caustic.invariant"], 0.195462056169975, 1e-14);
  EXPECT_LT(m["caustic.spread"], 1e-12);
  // Backwards it goes round the other way.
  for (Number& v : scene.balls[0].velocity) v = -v.value;
  EXPECT_NEAR(measure(scene)["rotation_number"], 1 - 2.748135509583317 / (2 * pi), 1e-13);
}

// In a box of 3 by 1, from its middle into the corner at 4 along the boundary: the face x+ is hit before y+ at that instant.
TEST(BoundaryMap, of_the_faces_of_a_box) {
  Scene scene = testing::box({-1, 2}, {2, 3});
  scene.balls = {ball({0.5, 2.5}, {3, 1}, 0)};
  scene.run.events = 8;
  scene.observe.boundary_map.emplace();
  scene.observe.rotation_number = true;
  const Rows rows = streamed(scene, "boundary_map");
  ASSERT_EQ(rows.size(), 8u);
  const double sine_x = 1 / std::sqrt(10), sine_y = 3 / std::sqrt(10);
  EXPECT_EQ(rows[0][2], 1);
  EXPECT_NEAR(rows[0][0], 3 + 1, 1e-15);
  EXPECT_NEAR(std::abs(rows[0][1]), sine_x, 1e-15);
  EXPECT_EQ(rows[1][2], 3);
  EXPECT_NEAR(std::abs(rows[1][1]), sine_y, 1e-15);
}

// A disk of radius 1/2 between two fixed ones and inside a triangle: pieces in the order of the walls, then the rims.
TEST(Boundary, is_made_of_walls_and_then_rims) {
  Scene scene = testing::open_space(2);
  WallSpec triangle, segment;
  triangle.kind = WallKind::polygon;
  triangle.vertices = {{0, 0}, {3, 0}, {0, 4}};
  segment.kind = WallKind::segment;
  segment.from = {10, 0};
  segment.to = {10, 2};
  scene.walls = {triangle, segment, testing::circle({20, 0}, 0.5, WallSide::outside)};
  scene.balls = {ball({1, 1}, {1, 0}, 0.1), ball({5, 5}, {}, 2)};
  scene.balls[1].fixed = true;
  const Simulation simulation(scene);
  const Boundary boundary(scene, simulation);
  ASSERT_EQ(boundary.pieces().size(), 6u);
  const std::vector<double> lengths = {3, 5, 4, 2, pi, 4 * pi};
  double begin = 0;
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    EXPECT_DOUBLE_EQ(boundary.pieces()[k].length, lengths[k]);
    EXPECT_DOUBLE_EQ(boundary.pieces()[k].begin, begin);
    begin += lengths[k];
  }
  EXPECT_EQ(boundary.pieces()[5].wall, 4u);
}

TEST(Boundary, knows_the_lengths_of_curves) {
  WallSpec w;
  w.kind = WallKind::ellipse;
  w.axes = {2, 1};
  EXPECT_NEAR(wall_length(w, 0), 9.688448220547675, 1e-14);  // 8 E(sqrt(3)/2)
  w.axes = {1, 2};
  EXPECT_NEAR(wall_length(w, 0), 9.688448220547675, 1e-14);
  w.axes = {1.5, 1.5};
  EXPECT_DOUBLE_EQ(wall_length(w, 0), 3 * pi);
  w.kind = WallKind::curve;  // r = 1 + cos theta: 8
  w.cosines = {1, 1};
  EXPECT_NEAR(wall_length(w, 0), 8, 1e-10);
  w.kind = WallKind::parabola;  // y^2 = 4 x, |y| <= 2: 2 (sqrt(2) + asinh 1)
  w.focal_length = 1;
  w.half_width = 2;
  EXPECT_DOUBLE_EQ(wall_length(w, 0), 2 * (std::sqrt(2) + std::asinh(1)));
  w.kind = WallKind::arc;
  w.radius = 2;
  w.from_angle = 3;
  w.to_angle = 1;
  EXPECT_DOUBLE_EQ(wall_length(w, 0), 2 * (2 * pi - 2));
}

// A point among fixed disks: the sine is that of the angle at the rim, the arclength that of the point hit.
TEST(BoundaryMap, of_fixed_balls) {
  Scene scene = testing::open_space(2);
  scene.balls = {ball({0, 0.6}, {1, 0}, 0), ball({4, 0}, {}, 1)};
  scene.balls[1].fixed = true;
  scene.run.events = 1;
  scene.observe.boundary_map.emplace();
  const Rows rows = streamed(scene, "boundary_map");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(rows[0][0], pi - std::asin(0.6), 1e-15);
  EXPECT_NEAR(rows[0][1], 0.6, 1e-15);  // the wall is on its right hand
  EXPECT_EQ(rows[0][2], 1);
}

// In a square every orbit that is not along an axis hits x and y faces as |vx| to |vy|. There are about as many words as
// their length squared, so what a symbol says decreases towards 0; beside a disk it does not.
TEST(WallSequence, of_a_square_and_of_a_square_with_a_disk) {
  Scene scene = testing::box({0, 0}, {1, 1});
  scene.balls = {ball({0.3, 0.2}, {1, std::sqrt(2)}, 0)};
  scene.run.events = 20'000;
  scene.observe.wall_sequence.emplace();
  const Measured square = measure(scene);
  for (const std::size_t k : {0u, 2u}) {
    EXPECT_NEAR(square["wall_sequence.share[" + std::to_string(k) + "]"], std::sqrt(2) / (2 * (1 + std::sqrt(2))), 1e-3);
    EXPECT_NEAR(square["wall_sequence.share[" + std::to_string(k + 1) + "]"], 1 / (2 * (1 + std::sqrt(2))), 1e-3);
  }
  EXPECT_LT(square["wall_sequence.entropy"], 0.35);
  EXPECT_GE(square["wall_sequence.entropy"], 0);
  scene.walls = {testing::circle({0.5, 0.5}, 0.25, WallSide::outside)};
  scene.balls[0].position = {0.1, 0.2};
  const Measured sinai = measure(scene);
  EXPECT_GT(sinai["wall_sequence.entropy"], square["wall_sequence.entropy"] + 0.25);
  const Rows rows = streamed(scene, "wall_sequence");
  ASSERT_EQ(rows.size(), 20'000u);
  for (const auto& row : rows) EXPECT_TRUE(row[1] >= 0 && row[1] < 5 && row[4] == 0);
}

// Chaos fills the boundary map; a periodic orbit has as many cells as points.
TEST(PhaseSpacePortion, of_chaos_and_of_a_periodic_orbit) {
  Scene scene = testing::box({0, 0}, {1, 1});
  scene.balls = {ball({0.1, 0.2}, {1, std::sqrt(2)}, 0)};
  scene.walls = {testing::circle({0.5, 0.5}, 0.25, WallSide::outside)};
  scene.run.events = 60'000;
  scene.observe.phase_space_portion.emplace();
  scene.observe.phase_space_portion->bins = 20;
  EXPECT_GT(measure(scene)["phase_space_portion"], 0.97);
  scene.walls.clear();
  scene.balls[0] = ball({0.5, 0}, {1, 1}, 0);
  scene.balls[0].position = {0.5, 0.23};  // four impacts
  EXPECT_DOUBLE_EQ(measure(scene)["phase_space_portion"], 4.0 / 400);
}

TEST(Boundary, is_refused_where_there_is_none) {
  const auto refused = [](const Scene& scene) {
    try {
      const Simulation simulation(scene);
      const Observers observers(scene, simulation);
    } catch (const InputError& error) {
      return error.problems().front().why;
    }
    return std::string();
  };
  Scene scene = testing::open_space(2);
  scene.balls = {ball({0, 1}, {1, 0}, 0)};
  scene.observe.boundary_map.emplace();
  EXPECT_EQ(refused(scene), "there are neither walls nor fixed balls");
  scene.walls = {testing::plane({0, 0}, {0, 1})};
  EXPECT_EQ(refused(scene), "a plane has no end");
  scene.walls = {testing::circle({0, 0}, 3, WallSide::inside)};
  EXPECT_EQ(refused(scene), "");
  scene.observe.caustic = true;
  EXPECT_EQ(refused(scene), "");
  scene.walls.push_back(testing::circle({0.5, 0}, 0.25, WallSide::outside));
  EXPECT_EQ(refused(scene), "the walls are neither circles about one centre nor one ellipse");
  scene = testing::mixed_box(3, 2, 4.0, 1);
  scene.observe.boundary_map.emplace();
  EXPECT_EQ(refused(scene), "arclengths are those of two dimensions");
}

}  // namespace
}  // namespace carom
