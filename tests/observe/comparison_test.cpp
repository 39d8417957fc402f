// The exact run as a course, and a stepper beside it.

#include "carom/observe/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "carom/sim/fixed_step.hpp"
#include "observe/loop_stepper.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

/// The course of a scene up to a time.
struct Exact {
  Simulation start;
  Course course;
  Enclosures enclosures;

  Exact(const Scene& scene, double until)
      : start(scene), course(scene, start), enclosures(scene, course.subject(), std::vector<Triple>(course.balls())) {
    Simulation simulation(scene);
    simulation.advance(Number(until), std::nullopt, [this](const Collision& c) { course.add(c); });
  }
};

Comparison compare_with(const Exact& exact, Stepper& stepper, double dt, std::int64_t steps) {
  ComparisonSettings settings;
  settings.dt = dt;
  settings.steps = steps;
  return compare(exact.course, exact.enclosures, stepper, settings);
}

Comparison compare_loop(const Scene& scene, double dt, std::int64_t steps, double gain = 1.0) {
  const Exact exact(scene, dt * static_cast<double>(steps + 2));
  LoopStepper stepper(exact.start, dt, gain);
  return compare_with(exact, stepper, dt, steps);
}

Comparison compare_discrete(const Scene& scene, double dt, std::int64_t steps) {
  const Exact exact(scene, dt * static_cast<double>(steps + 2));
  const auto stepper = make_stepper(scene, {.dt = dt, .method = parse_step_method("discrete")});
  return compare_with(exact, *stepper, dt, steps);
}

Scene two_balls(double gap, double speed, double radius, double aside = 0.0, double until = 1.0) {
  Scene scene = open_space(2);
  const double x = 0.5 * gap + radius;
  scene.balls = {ball({-x, 0}, {speed, 0}, radius), ball({x, aside}, {-speed, 0}, radius, 2.0)};
  scene.run.until = until;
  return scene;
}

// The course gives back what the simulation says, in every space, at any time.
TEST(Course, is_where_the_simulation_is) {
  Scene gas = mixed_box(2, 12, 9.0, 3);
  gas.space.kind = SpaceKind::periodic;
  Scene falling = mixed_box(3, 8, 8.0, 4);
  falling.motion.acceleration = {0, 0, -0.5};
  falling.balls[0].fixed = true;
  falling.balls[0].velocity = {0, 0, 0};
  for (const Scene& scene : {mixed_box(2, 12, 9.0, 2), gas, falling}) {
    const double until = 12.0;
    const Exact exact(scene, until);
    ASSERT_GT(exact.course.meetings().size(), 20u);
    EXPECT_EQ(exact.course.meetings_until(until), static_cast<std::int64_t>(exact.course.meetings().size()));
    Simulation again(scene);
    for (double t = 0.0; t <= until; t += 0.37) {
      again.advance(Number(t));
      for (const BallState& b : again.balls()) {
        const Place place = exact.course.at(b.index, t);
        for (std::size_t k = 0; k < b.velocity.size(); ++k) {
          EXPECT_NEAR(place.position[k], b.unwrapped_position[k], 1e-13) << "t = " << t << ", ball " << b.index;
          EXPECT_NEAR(place.velocity[k], b.velocity[k], 1e-13) << "t = " << t << ", ball " << b.index;
        }
      }
    }
  }
}

TEST(Course, knows_what_is_kept) {
  EXPECT_TRUE(Exact(two_balls(1, 1, 0.5), 1.0).course.keeps_energy());
  EXPECT_TRUE(Exact(two_balls(1, 1, 0.5), 1.0).course.keeps_momentum());
  EXPECT_FALSE(Exact(mixed_box(2, 4, 5.0, 1), 1.0).course.keeps_momentum()) << "there are walls";
  Scene lossy = two_balls(1, 1, 0.5);
  lossy.collision.restitution = 0.5;
  EXPECT_FALSE(Exact(lossy, 1.0).course.keeps_energy());
  EXPECT_TRUE(Exact(lossy, 1.0).course.keeps_momentum());
}

// Radius 0.01 and a step of 1: at the ends of the steps the balls are 1 apart before and 1 apart behind each other.
TEST(Compare, sees_what_passes_through) {
  const Comparison c = compare_loop(two_balls(1.0, 100.0, 0.01), 0.01, 10);
  EXPECT_EQ(c.collisions, 0);
  EXPECT_EQ(c.tally.missed, 1);
  EXPECT_EQ(c.tally.missed_pairs, 1);
  EXPECT_EQ(c.tally.spurious, 0);
  ASSERT_TRUE(c.diverged_at_collision.has_value());
  EXPECT_EQ(*c.diverged_at_collision, 1);
  EXPECT_EQ(*c.diverged_at, 0.01);
  EXPECT_LE(c.energy_error, 1e-15);
  EXPECT_EQ(c.averaged_from, 0.01);
  EXPECT_EQ(c.exact.collision_rate, 0.0) << "the collision was before";
  EXPECT_NEAR(c.exact.kinetic_energy, 15000, 1e-9);
  EXPECT_NEAR(c.here.kinetic_energy, 15000, 1e-9);
}

// With small steps the same loop sees it: at most one step late, overlapping by at most one step's way.
TEST(Compare, sees_a_late_collision) {
  const double dt = 1e-5;
  const Comparison c = compare_loop(two_balls(1.0, 100.0, 0.01), dt, 1000);
  EXPECT_EQ(c.collisions, 1);
  EXPECT_EQ(c.tally.missed, 0);
  EXPECT_EQ(c.tally.spurious, 0);
  EXPECT_FALSE(c.diverged_at_collision.has_value());
  EXPECT_GE(c.deepest_overlap, 0.0);
  EXPECT_LE(c.deepest_overlap, 200.0 * dt);
  EXPECT_GT(c.position_error, 0.0);
  EXPECT_LE(c.position_error, 300.0 * dt) << "a ball goes on at 100, and off at up to 200, one step late";
  EXPECT_LE(c.energy_error, 1e-15);
  EXPECT_EQ(c.averaged_from, 0.0);
  EXPECT_NEAR(c.exact.collision_rate, 1.0 / c.time, 1e-9);
  EXPECT_NEAR(c.here.ball_impulse_rate, c.exact.ball_impulse_rate, 1e-9 * c.exact.ball_impulse_rate);
  EXPECT_EQ(c.here.wall_impulse_rate, 0.0);
}

// An oblique hit: found up to a step late, at a normal that is off by O(dt). Averaged over where in the step the contact
// falls, the error at a fixed time later is proportional to dt.
void expect_first_order(const std::function<Comparison(const Scene&, double, std::int64_t)>& compared) {
  const auto mean_error = [&](double dt) {
    const int offsets = 200;
    const double until = 0.5;
    double sum = 0;
    for (int k = 0; k < offsets; ++k) {
      const Comparison c =
          compared(two_balls(0.2 + 2 * dt * (k + 0.5) / offsets, 1.0, 0.1, 0.07), dt, std::lround(until / dt));
      EXPECT_EQ(c.tally.missed + c.tally.spurious + c.escaped, 0);
      EXPECT_EQ(c.collisions, 1);
      sum += c.position_error;
    }
    return sum / offsets;
  };
  const double slope = std::log2(mean_error(0.01) / mean_error(0.0025)) / 2;
  EXPECT_NEAR(slope, 1.0, 0.1);
}

TEST(Compare, error_falls_with_the_step) {
  expect_first_order([](const Scene& scene, double dt, std::int64_t steps) { return compare_loop(scene, dt, steps); });
  expect_first_order(compare_discrete);
}

// An impulse 10 % too large: energy is off by the balance (momentum is not), by hand.
TEST(Compare, energy_off_is_that_of_the_velocities) {
  const Scene scene = two_balls(0.5, 1.0, 0.1);
  const Comparison c = compare_loop(scene, 1e-4, 4000, 1.1);
  // Masses 1 and 2 meet at 2: J = 2 mu 2 = 8/3; with 1.1 J: v1 = 1 - 1.1 8/3, v2 = -1 + 1.1 4/3.
  const double v1 = 1 - 1.1 * 8 / 3, v2 = -1 + 1.1 * 4 / 3;
  EXPECT_NEAR(c.energy_error, (0.5 * v1 * v1 + v2 * v2 - 1.5) / 1.5, 1e-9);
  EXPECT_LE(c.momentum_error, 1e-15);
}

// Dissipation that the exact run has too is no error. The loop is elastic: after the impact it has lost nothing.
TEST(Compare, dissipation_is_compared_with_that_of_the_exact_run) {
  Scene scene = two_balls(0.5, 1.0, 0.1);
  scene.collision.restitution = 0.5;
  const Comparison half = compare_loop(scene, 1e-4, 4000, 0.75);  // (1 + e)/2 of the elastic impulse is what e = 1/2 gives
  EXPECT_LE(half.energy_error, 1e-14);
  const Comparison elastic = compare_loop(scene, 1e-4, 3000);
  EXPECT_FALSE(elastic.diverged_at_collision.has_value());
  EXPECT_NEAR(elastic.energy_error, 0.5 * (2.0 / 3) * 0.75 * 4 / 1.5, 1e-9) << "mu (1 - e^2) g^2 / 2 over 3/2";
}

TEST(Compare, reports_errors_in_time_and_stops_when_told) {
  const Scene scene = two_balls(0.5, 1.0, 0.1);
  const Exact exact(scene, 2.0);
  LoopStepper stepper(exact.start, 1e-4);
  std::atomic<bool> interrupt{false};
  ComparisonSettings settings;
  settings.dt = 1e-4;
  settings.steps = 10000;
  settings.interrupt = &interrupt;
  std::vector<double> times;
  settings.position_error = [&](double time, double error) {
    times.push_back(time);
    EXPECT_GE(error, 0.0);
  };
  settings.slice = [&](double share) {
    if (share >= 0.5) interrupt = true;
  };
  const Comparison c = compare(exact.course, exact.enclosures, stepper, settings);
  EXPECT_TRUE(c.interrupted);
  EXPECT_EQ(c.steps, 5000);
  ASSERT_GE(times.size(), 500u);
  EXPECT_LE(times.size(), 502u);
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
}

}  // namespace
}  // namespace carom
