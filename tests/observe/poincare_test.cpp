// Sections of motions so simple that every crossing is known.

#include "carom/observe/poincare.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "observe/measure.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using testing::ball;

using Rows = std::vector<std::vector<double>>;

Rows crossings(const Scene& scene) {
  Rows rows;
  Simulation simulation(scene);
  Observers observers(scene, simulation);
  observers.stream("poincare", [&](std::span<const double> row) { rows.emplace_back(row.begin(), row.end()); });
  simulation.run(observers.sink());
  observers.end(simulation);
  return rows;
}

void section(Scene& scene, Coordinates point, Coordinates normal) {
  scene.observe.poincare.emplace();
  scene.observe.poincare->point = std::move(point);
  scene.observe.poincare->normal = std::move(normal);
}

// A point goes to and fro between x = 0 and 4 at speed 1 from x = 1, drifting up: x = 2 is crossed to the right at 1, 9, ...
TEST(Poincare, counts_one_direction) {
  Scene scene = testing::box({0, 0}, {4, 1000});
  scene.balls = {ball({1, 1}, {1, 0.5}, 0)};
  scene.run.until = 30.0;
  section(scene, {2, 0}, {3, 0});
  const Rows rows = crossings(scene);
  ASSERT_EQ(rows.size(), 4u);  // 1, 9, 17, 25
  for (std::size_t k = 0; k < 4; ++k) {
    const double t = 1 + 8 * static_cast<double>(k);
    EXPECT_NEAR(rows[k][3], t, 1e-14);
    EXPECT_NEAR(rows[k][0], -(1 + t / 2), 1e-14);  // along (0, -1)
    EXPECT_EQ(rows[k][1], -0.5);
  }
  EXPECT_NEAR(testing::measure(scene)["poincare.rate"], 4 / 30.0, 1e-15);
}

// The line is where the ball bounces: every crossing is counted once, by the flight that comes to the line.
TEST(Poincare, on_a_wall) {
  Scene scene = testing::box({0, 0}, {4, 1000});
  scene.balls = {ball({1, 1}, {1, 0.5}, 0)};
  scene.run.until = 30.0;
  section(scene, {4, 0}, {1, 0});
  EXPECT_EQ(crossings(scene).size(), 4u);  // 3, 11, 19, 27
}

// Thrown up at 2 under g = 1, bouncing on the floor: the height 1.5 is crossed upwards at 2 - sqrt(4 - 3) = 1, then each 4.
TEST(Poincare, of_a_bouncing_ball) {
  Scene scene = testing::box({0, 0}, {1000, 1000});
  scene.motion.acceleration = {0, -1};
  scene.balls = {ball({1, 0}, {1, 2}, 0)};
  scene.run.until = 14.0;
  section(scene, {0, 1.5}, {0, 1});
  const Rows rows = crossings(scene);
  ASSERT_EQ(rows.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(rows[k][3], 1 + 4 * static_cast<double>(k), 1e-12);
  section(scene, {0, 1.5}, {0, -1});  // and downwards at 3
  EXPECT_NEAR(crossings(scene)[0][3], 3, 1e-13);
  section(scene, {0, 2.5}, {0, 1});  // above its top
  EXPECT_TRUE(crossings(scene).empty());
}

// In a periodic cell of 3 by 2 a ball at (1, 0.25) goes through every image of x = 0.5.
TEST(Poincare, of_a_line_and_its_images) {
  Scene scene = testing::box({0, 0}, {3, 2});
  scene.space.kind = SpaceKind::periodic;
  scene.balls = {ball({0, 0.5}, {1, 0.25}, 0)};
  scene.run.until = 13.0;
  section(scene, {0.5, 0}, {1, 0});
  const Rows rows = crossings(scene);
  ASSERT_EQ(rows.size(), 5u);  // 0.5, 3.5, 6.5, 9.5, 12.5
  for (std::size_t k = 0; k < 5; ++k) {
    const double t = 0.5 + 3 * static_cast<double>(k), y = 0.5 + t / 4;
    EXPECT_NEAR(rows[k][3], t, 1e-13);
    EXPECT_NEAR(std::remainder(rows[k][0] + y, 2.0), 0, 1e-13);
  }
}

// A flight that turns: from the flight alone, since a magnetic field needs no wall. x = 2 sin t, y = 2 (1 - cos t): the line
// y = 3 is crossed upwards at acos(-1/2), and after each turn; the velocity along (1, 0) is then 2 cos t = -1.
TEST(Poincare, of_a_turning_flight) {
  Subject subject;
  subject.magnetic = 1;
  subject.mass = {1};
  subject.free = 1;
  PoincareSpec spec;
  spec.point = {0, 3};
  spec.normal = {0, 2};
  RowOutlet outlet;
  Rows rows;
  outlet.lead_to([&](std::span<const double> row) { rows.emplace_back(row.begin(), row.end()); });
  Poincare poincare(spec, outlet, subject);
  Flight f;
  f.velocity = {2, 0, 0};
  f.magnetic = 1;
  f.end = f.duration = 15;
  poincare.flight(f);
  ASSERT_EQ(rows.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const double t = std::acos(-0.5) + static_cast<double>(k) * 2 * std::acos(-1.0);
    EXPECT_NEAR(rows[k][3], t, 1e-14);
    EXPECT_NEAR(rows[k][0], 2 * std::sin(t), 1e-13);
    EXPECT_NEAR(rows[k][1], -1, 1e-13);
  }
  f.magnetic = -1;  // y = -2 (1 - cos t)
  rows.clear();
  poincare.flight(f);
  EXPECT_TRUE(rows.empty());
}

}  // namespace
}  // namespace carom
