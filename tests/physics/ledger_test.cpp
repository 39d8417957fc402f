// The books of a run: what was dissipated and injected, what stays, and what is said to stay.

#include <gtest/gtest.h>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

double kinetic(const std::vector<BallState>& balls) {
  double e = 0;
  for (const BallState& b : balls)
    for (const double v : b.velocity)
      if (std::isfinite(b.mass)) e += 0.5 * b.mass * v * v;
  return e;
}

TEST(Ledger, dissipated_is_the_drop_of_the_kinetic_energy) {
  for (int d = 1; d <= 3; ++d)
    for (const double e : {0.99, 0.5}) {
      if (d == 1 && e < 0.9) continue;  // on a line eight such rods collapse
      Scene scene = d == 1 ? rods(8, 4) : mixed_box(d, d == 2 ? 12 : 20, 8.0, 17);
      scene.collision.restitution = e;
      Simulation simulation(scene);
      const double before = kinetic(simulation.balls());
      double booked = 0;
      ASSERT_EQ(simulation.advance(std::nullopt, 500, [&](const Collision& c) { booked += c.dissipated; }), Stop::events);
      const Summary s = simulation.summary();
      EXPECT_GT(s.energy.dissipated, 0.05 * before);
      EXPECT_NEAR(s.energy.dissipated, before - kinetic(simulation.balls()), 1e-13 * before);
      EXPECT_NEAR(s.energy.dissipated, booked, 1e-13 * before);
      EXPECT_NEAR(s.energy.initial, before, 1e-14 * before);
      EXPECT_NEAR(s.energy.final, kinetic(simulation.balls()), 1e-14 * before);
      EXPECT_EQ(s.energy.injected, 0.0);
      EXPECT_LE(s.energy.relative_error, 1e-15);
    }
}

// A ball of infinite mass keeps its velocity and works on the others.
TEST(Ledger, an_infinite_mass_injects_what_the_others_gain) {
  for (int d = 1; d <= 3; ++d)
    for (const double e : {1.0, 0.6}) {
      Scene scene = open_space(d);
      scene.collision.restitution = e;
      Dice dice(31);
      Coordinates x(std::size_t(d), 0.0), v(std::size_t(d), 0.0);
      x[0] = -10.0;
      v[0] = 2.0;
      scene.balls.push_back(ball(x, v, 1.0, std::numeric_limits<double>::infinity()));
      for (int i = 0; i < 6; ++i) {
        for (int k = 0; k < d; ++k) {
          x[k] = k == 0 ? 2.0 * i : dice.between(-0.3, 0.3);
          v[k] = dice.between(-0.1, 0.1);
        }
        scene.balls.push_back(ball(x, v, 0.5, dice.between(0.5, 3.0)));
      }
      Simulation simulation(scene);
      const double before = kinetic(simulation.balls());
      simulation.advance(Number(20.0), 1000);
      const Summary s = simulation.summary();
      ASSERT_GT(s.events.ball_ball, 5) << d << "-D";
      EXPECT_GT(s.energy.injected, 1.0);
      EXPECT_NEAR(kinetic(simulation.balls()) + s.energy.dissipated, before + s.energy.injected, 1e-13 * s.energy.injected);
      EXPECT_LE(s.energy.relative_error, 1e-15);
      EXPECT_EQ(simulation.ball(0).velocity[0], 2.0);
      EXPECT_FALSE(s.momentum.relative_error.has_value());
      EXPECT_FALSE(s.angular_momentum.relative_error.has_value());
    }
}

TEST(Ledger, momentum_is_judged_only_where_it_is_conserved) {
  Scene open = open_space(2);
  open.balls = {ball({0.0, 0.0}, {1.0, 0.0}), ball({3.0, 0.3}, {-1.0, 0.2})};
  EXPECT_TRUE(run_until(open, 5.0).summary.momentum.relative_error.has_value());
  Scene walled = open;
  walled.walls.push_back(plane({-50.0, 0.0}, {1.0, 0.0}));
  EXPECT_FALSE(run_until(walled, 5.0).summary.momentum.relative_error.has_value());
  EXPECT_FALSE(run_until(walled, 5.0).summary.angular_momentum.relative_error.has_value());
  Scene boxed = open;
  boxed.space.kind = SpaceKind::box;
  boxed.space.lower = {-10.0, -10.0};
  boxed.space.upper = {10.0, 10.0};
  EXPECT_FALSE(run_until(boxed, 5.0).summary.momentum.relative_error.has_value());
  Scene pinned = open;
  pinned.balls[1].velocity = {};
  pinned.balls[1].fixed = true;
  EXPECT_FALSE(run_until(pinned, 5.0).summary.momentum.relative_error.has_value());
  Scene resting = open_space(2);
  resting.balls = {ball({0.0, 0.0}, {})};
  EXPECT_EQ(run_until(resting, 5.0).summary.momentum.relative_error, 0.0) << "0/0 is 0";
  EXPECT_EQ(run_until(resting, 5.0).summary.energy.relative_error, 0.0);
}

// A cloud of balls that falls in on itself, in open space.
TEST(Ledger, momentum_and_angular_momentum_are_conserved_in_open_space) {
  for (int d = 2; d <= 3; ++d)
    for (const double e : {1.0, 0.7}) {
      Dice dice(41);
      Scene scene = open_space(d);
      scene.collision.restitution = e;
      const int row = 3;
      for (int i = 0; i < (d == 2 ? 9 : 27); ++i) {
        Coordinates x, v;
        for (int k = 0, place = i; k < d; ++k, place /= row) {
          x.push_back(4.0 * (place % row - 1) + 100.0 + dice.between(-0.5, 0.5));
          v.push_back(-0.5 * (x.back().value - 100.0) + dice.between(-0.2, 0.2) + 0.01);
        }
        scene.balls.push_back(ball(x, v, dice.between(0.5, 1.3), dice.between(0.5, 4.0)));
      }
      const Result result = run_until(scene, 50.0);
      ASSERT_GT(result.log.size(), 15u);
      ASSERT_TRUE(result.summary.momentum.relative_error && result.summary.angular_momentum.relative_error);
      EXPECT_LE(*result.summary.momentum.relative_error, 1e-15);
      EXPECT_LE(*result.summary.angular_momentum.relative_error, 1e-14);
      EXPECT_EQ(result.summary.angular_momentum.initial.size(), d == 2 ? 1u : 3u);
      EXPECT_LE(result.summary.energy.relative_error, 1e-15);
    }
}

// What the books say of each collision is what its velocities say.
TEST(Ledger, each_collision_balances) {
  Scene scene = mixed_box(3, 20, 8.0, 23);
  scene.collision.restitution = 0.8;
  const Result result = run(scene, 400);
  for (const Collision& c : result.log) {
    double before = 0, after = 0;
    const auto add = [&](const Collision::Party& p, double mass) {
      for (std::size_t k = 0; k < 3; ++k) {
        before += 0.5 * mass * p.velocity_before[k] * p.velocity_before[k];
        after += 0.5 * mass * p.velocity_after[k] * p.velocity_after[k];
      }
    };
    add(c.ball, result.balls[c.ball.number].mass);
    if (c.kind == EventKind::ball_ball) add(c.partner, result.balls[c.partner.number].mass);
    EXPECT_NEAR(before - after, c.dissipated, 1e-14 * before);
    EXPECT_GE(c.dissipated, 0.0);
  }
}

}  // namespace
}  // namespace carom
