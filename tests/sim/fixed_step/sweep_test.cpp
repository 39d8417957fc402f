// With all contacts of a step taken in order, and without forces, sweeping is the event-driven mode up to rounding.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/fixed_step/stepping.hpp"

namespace carom {
namespace {

using namespace testing;

/// Agrees with the exact log, of `least` collisions or more, but for rounding errors, which grow by `growth` a collision.
void expect_the_exact_log(const Scene& scene, double until, std::int64_t steps, std::size_t least, double growth) {
  const Result exact = run_until(scene, until);
  const Stepped stepped = run_steps(scene, until / static_cast<double>(steps), "swept:substeps", steps);
  ASSERT_GE(exact.log.size(), least);
  ASSERT_EQ(stepped.contacts.size(), exact.log.size()) << steps << " steps";
  double tolerance = 1e-13 + 3e-16 * static_cast<double>(steps);  // a rounding of the position in every step
  for (std::size_t k = 0; k < exact.log.size(); ++k) {
    const StepContact& c = stepped.contacts[k];
    ASSERT_EQ(c.kind, exact.log[k].kind) << k;
    ASSERT_EQ(c.ball, exact.log[k].ball.number) << k;
    ASSERT_EQ(c.partner, exact.log[k].partner.number) << k;
    ASSERT_EQ(c.feature, exact.log[k].feature) << k;
    EXPECT_NEAR(c.time, exact.log[k].time, tolerance) << k;
    EXPECT_NEAR(c.impulse, exact.log[k].impulse, tolerance) << k;
    tolerance *= growth;
  }
  for (std::size_t i = 0; i < exact.balls.size(); ++i)
    for (std::size_t k = 0; k < exact.balls[i].velocity.size(); ++k) {
      EXPECT_NEAR(stepped.balls[i].unwrapped_position[k], exact.balls[i].unwrapped_position[k], tolerance);
      EXPECT_NEAR(stepped.balls[i].velocity[k], exact.balls[i].velocity[k], tolerance);
    }
}

// Curved bodies part two paths at each collision, so rounding errors grow; the length of a step plays no part.
TEST(Substeps, two_and_three_disks_in_a_box) {
  for (const std::int64_t steps : {3, 40, 5000}) {
    expect_the_exact_log(mixed_box(2, 2, 4.0, 31), 60.0, steps, 30, 1.8);
    expect_the_exact_log(mixed_box(2, 3, 4.0, 33), 12.0, steps, 30, 1.8);
    expect_the_exact_log(mixed_box(3, 3, 4.0, 34), 10.0, steps, 30, 1.8);
  }
}

TEST(Substeps, rods_on_a_line) {
  for (const std::int64_t steps : {7, 1000}) expect_the_exact_log(rods(3, 35), 30.0, steps, 40, 1.1);
  // Points: whether one is left or right of another is told by their approach where they coincide.
  Scene points = box({0.0}, {1.0});
  points.balls = {ball({0.2}, {1.0}, 0.0, 1.0), ball({0.5}, {-0.34}, 0.0, 2.7), ball({0.7}, {0.13}, 0.0, 1.3)};
  for (const std::int64_t steps : {7, 1000}) expect_the_exact_log(points, 20.0, steps, 40, 1.1);
}

// 1 kg, 10000 kg and a wall: 314 collisions, most of them within a moment [Galperin2003].
TEST(Substeps, count_the_digits_of_pi) {
  Scene scene = open_space(1);
  scene.walls = {plane({0.0}, {1.0})};
  scene.balls = {ball({2.0}, {0.0}, 0.5, 1.0), ball({4.0}, {-1.0}, 0.5, 1e4)};
  EXPECT_EQ(run_steps(scene, 100.0, "swept:substeps:limit=1000", 1).collisions(), 314);
  EXPECT_EQ(run_steps(scene, 0.01, "swept:substeps", 10000).collisions(), 314);
}

TEST(Substeps, three_disks_in_a_periodic_cell) {
  Scene scene = mixed_box(2, 3, 4.0, 36);
  scene.space.kind = SpaceKind::periodic;
  for (const std::int64_t steps : {5, 400}) expect_the_exact_log(scene, 20.0, steps, 20, 2.0);
}

TEST(Substeps, a_stadium_of_planes_circles_and_segments) {
  Scene scene = open_space(2);
  scene.walls = {plane({0.0, -2.0}, {0.2, 1.0}), circle({0.0, 0.0}, 3.0, WallSide::inside),
                 circle({0.5, 0.2}, 0.4, WallSide::outside)};
  WallSpec fence;
  fence.kind = WallKind::segment;
  fence.from = {-1.0, -0.5};
  fence.to = {-1.5, 1.5};
  scene.walls.push_back(fence);
  scene.balls = {ball({1.6, 0.0}, {0.3, 1.0}, 0.2)};
  for (const std::int64_t steps : {5, 400}) expect_the_exact_log(scene, 30.0, steps, 12, 2.5);
}

// A ball that has had its contacts of a step flies on; the next step takes it back in.
TEST(Substeps, a_ball_has_as_many_contacts_as_the_limit_says) {
  Scene scene = box({0.0}, {3.0});
  scene.balls = {ball({1.0}, {1.0})};
  const Stepped one = run_steps(scene, 100.0, "swept:substeps:limit=4", 1);
  EXPECT_EQ(one.collisions(), 4);
  EXPECT_NEAR(one.balls[0].position[0], 0.5 + (100.0 - 7.5), 1e-12) << "at 1.5, 3.5, 5.5 and 7.5, and on";
  const Stepped two = run_steps(scene, 100.0, "swept:substeps:limit=4", 2);
  EXPECT_EQ(two.collisions(), 8);
  EXPECT_EQ(std::abs(two.balls[0].velocity[0]), 1.0);
}

// One contact in a step: in a step that takes the ball through the box 50 times it bounces once, and is then outside; the
// next step takes it back in.
TEST(SweptOnce, has_one_contact_a_ball_and_step) {
  Scene scene = box({0.0}, {3.0});
  scene.balls = {ball({1.0}, {1.0})};
  const Stepped result = run_steps(scene, 10.0, "swept", 2);
  EXPECT_EQ(result.collisions(), 2);
  EXPECT_NEAR(result.balls[0].position[0], 4.0, 1e-14) << "1 -> 2.5 -> -6, and there at once -6 -> 4";
}

}  // namespace
}  // namespace carom
