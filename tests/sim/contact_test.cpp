// Contact: touching at the start, touching after a plastic impact, grazing, corners, and contacts that do not end.

#include <gtest/gtest.h>

#include <algorithm>

#include "carom/core/error.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

// Two touching balls.

Result touching_pair(double radius, Coordinates v0, Coordinates v1, double e = 1.0) {
  Scene scene = open_space(static_cast<int>(v0.size()));
  scene.collision.restitution = e;
  scene.run.start = 3.0;
  Coordinates x0(v0.size(), 0.0), x1(v0.size(), 0.0);
  x0[0] = -radius;
  x1[0] = radius;
  scene.balls = {ball(x0, v0, radius), ball(x1, v1, radius)};
  return run(scene, 100);
}

TEST(TouchingPair, meets_at_once_if_closing_and_never_if_not) {
  for (const double R : {0.5, 0.1, 1.0 / 3.0}) {
    const Result closing = touching_pair(R, {1.0, 0.0}, {0.0, 0.0});
    ASSERT_EQ(closing.log.size(), 1u);
    EXPECT_EQ(closing.log[0].time, 3.0);
    EXPECT_EQ(closing.balls[0].velocity[0], 0.0);
    EXPECT_EQ(closing.balls[1].velocity[0], 1.0);
    EXPECT_EQ(touching_pair(R, {-1.0, 0.0}, {0.0, 0.0}).log.size(), 0u) << "separating";
    EXPECT_EQ(touching_pair(R, {0.0, 0.0}, {0.0, 0.0}).log.size(), 0u) << "at rest";
    EXPECT_EQ(touching_pair(R, {0.3, 0.7}, {0.3, 0.7}).log.size(), 0u) << "together";
    EXPECT_EQ(touching_pair(R, {0.0, 1.0}, {0.0, -1.0}).log.size(), 0u) << "one rolls off the other";
    EXPECT_EQ(touching_pair(R, {1.0, 5.0}, {0.0, -1.0}).log.size(), 1u) << "oblique";
    EXPECT_EQ(touching_pair(R, {2.0, 0.0, 1.0}, {0.0, 0.0, 0.0}).log.size(), 1u) << "in space";
    EXPECT_EQ(touching_pair(R, {1.0}, {0.0}).log.size(), 1u) << "on a line";
    EXPECT_EQ(touching_pair(R, {1.0}, {1.0}).log.size(), 0u);
    EXPECT_EQ(touching_pair(R, {-1.0}, {1.0}).log.size(), 0u);
    EXPECT_EQ(touching_pair(R, {1.0, 0.0}, {0.0, 0.0}, 0.0).log.size(), 1u) << "plastic: they go on together";
  }
}

// In contact as well as the coordinates can say: each is rounded once. They touch by right: one hit, now, and no overlap.
TEST(TouchingPair, in_any_direction) {
  Dice dice(5);
  for (int i = 0; i < 500; ++i) {
    const double r0 = dice.between(0.1, 1.0), r1 = dice.between(0.1, 1.0);
    const long double angle = dice.between(0.0, 6.3), sigma = static_cast<long double>(r0) + r1;
    const long double across = sigma * std::cos(angle), up = sigma * std::sin(angle);
    Scene scene = open_space(2);
    scene.collision.restitution = i % 2 == 0 ? 1.0 : 0.0;
    const double x = dice.between(-1.0, 1.0), y = dice.between(-1.0, 1.0);
    scene.balls = {ball({x, y}, {double(across), double(up)}, r0),
                   ball({double(x + across), double(y + up)}, {0.0, 0.0}, r1, 2.0)};
    try {
      const Result result = run(scene, 100);
      EXPECT_EQ(result.log.size(), 1u) << i;
      EXPECT_EQ(result.log[0].time, 0.0);
      EXPECT_EQ(result.summary.exactness.clamped, 0);
    } catch (const InputError& e) {
      ADD_FAILURE() << e.what() << ": the gap is a few roundings of the coordinates, case " << i;
    }
  }
}

// Plastic impacts.

// e = 0: the normal velocities become equal up to rounding, of either sign. The pair must not meet again.
TEST(Plastic, exactly_one_collision) {
  Dice dice(6);
  for (int i = 0; i < 2000; ++i) {
    const int d = 1 + i % 3;
    Scene scene = open_space(d);
    scene.collision.restitution = 0.0;
    Coordinates x0, x1, v0, v1;
    for (int k = 0; k < d; ++k) {
      x0.push_back(k == 0 ? -2.0 : dice.between(-0.2, 0.2));
      x1.push_back(k == 0 ? 2.0 : dice.between(-0.2, 0.2));
      v0.push_back(k == 0 ? dice.between(0.1, 3.0) : 0.0);
      v1.push_back(k == 0 ? dice.between(-3.0, -0.1) : 0.0);
    }
    scene.balls = {ball(x0, v0, 0.5, dice.between(0.1, 10.0)),
                   ball(x1, v1, dice.between(0.1, 1.0), dice.between(0.1, 10.0))};
    const Result result = run_until(scene, 1e4);
    ASSERT_EQ(result.log.size(), 1u) << d << "-D, case " << i;
    EXPECT_LE(result.summary.energy.relative_error, 1e-15);
  }
}

TEST(Plastic, a_wall_takes_the_normal_velocity_and_leaves_the_rest) {
  Scene scene = box({0.0, 0.0}, {10.0, 10.0});
  scene.collision.restitution = 0.0;
  scene.balls = {ball({5.0, 5.0}, {1.0, 0.25})};
  const Result result = run_until(scene, 1000.0);
  EXPECT_EQ(result.log.size(), 2u) << "the wall, then the corner";
  EXPECT_EQ(result.balls[0].velocity, (std::vector<Number>{0.0, 0.0}));
  EXPECT_EQ(result.balls[0].position, (std::vector<Number>{9.5, 9.5}));
  EXPECT_NEAR(result.summary.energy.dissipated, 0.5 * (1 + 0.0625), 1e-15);
}

// Any inclined plane: the normal velocity left by rounding must not bring the ball back to it.
TEST(Plastic, one_hit_on_an_inclined_wall) {
  Dice dice(8);
  for (int i = 0; i < 500; ++i) {
    Scene scene = open_space(2);
    scene.collision.restitution = 0.0;
    scene.walls.push_back(plane({0.0, 0.0}, {dice.between(-1.0, 1.0), dice.between(0.1, 1.0)}));
    const Coordinates n = scene.walls[0].normal;
    const double size = std::hypot(n[0].value, n[1].value), far = dice.between(2.0, 5.0);
    const double along = dice.between(-1.0, 1.0);
    scene.balls = {ball({n[0] / size * far, n[1] / size * far}, {-n[0] + along * n[1], -n[1] - along * n[0]}, 0.5)};
    EXPECT_EQ(run_until(scene, 1e3).log.size(), 1u) << i;
  }
}

// Grazing.

TEST(Grazing, one_ulp_decides) {
  const auto hits = [](double b, int d) {
    Scene scene = open_space(d);
    Coordinates x(std::size_t(d), 0.0), v(std::size_t(d), 0.0);
    x[0] = -5.0;
    x[1] = b;
    v[0] = 1.0;
    scene.balls = {ball(x, v), ball(Coordinates(std::size_t(d), 0.0), {})};
    const Result result = run_until(scene, 20.0);
    EXPECT_LE(result.summary.energy.relative_error, 1e-16);
    EXPECT_EQ(result.summary.exactness.clamped, 0);
    return result.log.size();
  };
  for (const int d : {2, 3}) {
    EXPECT_EQ(hits(1.0, d), 0u) << "touching without turning negative is no event";
    EXPECT_EQ(hits(std::nextafter(1.0, 2.0), d), 0u);
    EXPECT_EQ(hits(std::nextafter(1.0, 0.0), d), 1u);
    EXPECT_EQ(hits(1.0 - 1e-9, d), 1u);
  }
}

TEST(Grazing, along_a_wall_is_no_hit) {
  Scene scene = box({0.0, 0.0}, {10.0, 10.0});
  scene.balls = {ball({5.0, 0.5}, {1.0, 0.0})};  // rolls on the lower face, without a gap
  const Result result = run(scene, 7);
  for (const Collision& c : result.log) EXPECT_NE(c.normal[0], 0.0) << "only x- and x+ are hit";
  EXPECT_EQ(result.log.size(), 7u);
  EXPECT_EQ(result.balls[0].position[1], 0.5);
}

// Walls at the start.

std::size_t hits_at_start(Coordinates x, Coordinates v) {
  Scene scene = box({0.0, 0.0}, {10.0, 10.0});
  scene.balls = {ball(std::move(x), std::move(v))};
  Simulation simulation(scene);
  std::size_t hits = 0;
  simulation.advance(Number(0.0), std::nullopt, [&](const Collision&) { ++hits; });
  EXPECT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0);
  simulation.advance(Number(100.0));
  EXPECT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0);
  return hits;
}

TEST(StartOnWall, acts_at_once_if_pressed_and_never_if_not) {
  EXPECT_EQ(hits_at_start({0.5, 5.0}, {-1.0, 0.3}), 1u);
  EXPECT_EQ(hits_at_start({0.5, 5.0}, {1.0, 0.3}), 0u);
  EXPECT_EQ(hits_at_start({0.5, 5.0}, {0.0, 0.3}), 0u);
  EXPECT_EQ(hits_at_start({0.5, 5.0}, {0.0, 0.0}), 0u) << "at rest on the wall";
  EXPECT_EQ(hits_at_start({0.5, 0.5}, {-1.0, -1.0}), 2u) << "in the corner, into it";
  EXPECT_EQ(hits_at_start({0.5, 0.5}, {-1.0, 1.0}), 1u);
  EXPECT_EQ(hits_at_start({9.5, 9.5}, {1.0, 1e-100}), 2u);
  EXPECT_EQ(hits_at_start({9.5, 9.5}, {0.0, 0.0}), 0u);
}

TEST(Corner, at_45_degrees_both_walls_are_hit_at_one_instant) {
  for (const double speed : {1.0, 0.3, 7.7}) {
    Scene scene = box({0.0, 0.0}, {10.0, 10.0});
    scene.balls = {ball({5.0, 5.0}, {speed, speed})};
    const Result result = run(scene, 40);
    ASSERT_EQ(result.log.size(), 40u);
    for (std::size_t i = 0; i < 40; i += 2) {
      EXPECT_EQ(result.log[i].epoch, result.log[i + 1].epoch);
      EXPECT_EQ(result.log[i].offset, result.log[i + 1].offset);
      EXPECT_FALSE(result.log[i].tie);
      EXPECT_TRUE(result.log[i + 1].tie) << "the ball's previous collision was now, with another wall";
      EXPECT_LT(result.log[i].partner.number, result.log[i + 1].partner.number) << "in the order of the walls' numbers";
      EXPECT_EQ(result.log[i + 1].ball.velocity_after[0], result.log[i + 1].ball.velocity_after[1]);
    }
    EXPECT_EQ(result.summary.events.ties, 20);
    EXPECT_EQ(result.summary.energy.relative_error, 0.0);
  }
}

TEST(Corner, of_a_cube) {
  Scene scene = box({0.0, 0.0, 0.0}, {4.0, 4.0, 4.0});
  scene.balls = {ball({2.0, 2.0, 2.0}, {-1.0, -1.0, -1.0})};
  const Result result = run(scene, 9);
  EXPECT_EQ(result.summary.events.ties, 6);
  EXPECT_EQ(result.balls[0].velocity, (std::vector<Number>{1.0, 1.0, 1.0})) << "turned round three times";
}

// Many balls in contact.

TEST(Rack, fifteen_touching_balls_and_a_cue) {
  for (const double aside : {0.0, 1e-9, 0.2, 0.45})
    for (const double e : {1.0, 0.95}) {
      Scene scene = rack_and_cue(aside);
      scene.collision.restitution = e;
      scene.space.restitution = 1.0;
      Simulation simulation(scene);
      ASSERT_EQ(simulation.advance(Number(1.0)), Stop::until) << "nothing moves before the cue ball comes";
      EXPECT_EQ(simulation.counts().collisions(), 0);
      for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(simulation.advance(std::nullopt, 3), Stop::events) << "aside " << aside << ", e " << e;
        ASSERT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0) << "aside " << aside << ", e " << e;
      }
      EXPECT_EQ(simulation.summary().exactness.clamped, 0);
      EXPECT_LE(simulation.summary().energy.relative_error, 1e-15);
    }
}

// A ball at the end of a touching row is hit: with e = 1 only the last one leaves, in 2-D along any axis.
TEST(Row, passes_the_impulse_on) {
  for (const bool upwards : {false, true}) {
    Scene scene = open_space(2);
    for (int i = 0; i < 8; ++i) {
      const double along = i == 0 ? -3.0 : i;
      scene.balls.push_back(
          ball(upwards ? Coordinates{0.25, along} : Coordinates{along, 0.25}, i > 0     ? Coordinates{}
                                                                              : upwards ? Coordinates{0.0, 1.0}
                                                                                        : Coordinates{1.0, 0.0}));
    }
    const Result result = run(scene, 100);
    EXPECT_EQ(result.log.size(), 7u);
    EXPECT_EQ(result.summary.events.ties, 6);
    EXPECT_EQ(result.balls[7].velocity[upwards ? 1 : 0], 1.0);
    for (int i = 0; i < 7; ++i) EXPECT_EQ(result.balls[i].velocity[upwards ? 1 : 0], 0.0);
  }
}

// Points at one place of a line: only neighbours in the order meet. The three come together at t = 1, and what follows is
// the limit of small gaps: 0 and 1, then 1 and 2, then 0 and 1 again, until nobody approaches.
TEST(TripleHit, of_points_on_a_line_goes_between_neighbours) {
  for (const double e : {1.0, 0.9, 0.5}) {
    Scene scene = open_space(1);
    scene.collision.restitution = e;
    scene.balls = {ball({-1.0}, {1.0}, 0.0), ball({0.0}, {0.0}, 0.0, 2.0), ball({1.0}, {-1.0}, 0.0)};
    const Result result = run(scene, 100);
    for (const Collision& c : result.log)
      EXPECT_EQ(c.partner.number, c.ball.number + 1)
          << "e " << e << ": ball " << c.ball.number << " reached through its neighbour";
    const auto& b = result.balls;
    EXPECT_LE(b[0].velocity[0], b[1].velocity[0]);
    EXPECT_LE(b[1].velocity[0], b[2].velocity[0]);
    EXPECT_LE(result.summary.energy.relative_error, 1e-15);
  }
}

// Contacts without end.

// A heavy ball presses a plastic one against a wall: infinitely many impacts at one instant.
TEST(Persistent, a_plastic_ball_between_a_ball_and_a_wall) {
  for (const double heavy : {1.0, 3.0, 100.0, 1e6})
    for (int d = 1; d <= 3; ++d) {
      Scene scene = open_space(d);
      scene.collision.restitution = 0.0;
      Coordinates x(std::size_t(d), 0.0), n(std::size_t(d), 0.0);
      n[0] = 1.0;
      scene.walls = {plane(x, n)};
      x[0] = 0.5;
      scene.balls.push_back(ball(x, {}));
      x[0] = 4.0;
      n[0] = -1.0;
      scene.balls.push_back(ball(x, n, 0.5, heavy));
      const Result result = run(scene, 100'000);
      EXPECT_EQ(result.stop, Stop::collapse) << d << "-D, mass " << heavy << ", " << result.log.size() << " collisions";
      if (result.stop != Stop::collapse) continue;
      ASSERT_TRUE(result.summary.stopped.has_value());
      const auto& balls = result.summary.stopped->balls;
      EXPECT_NE(std::find(balls.begin(), balls.end(), 0u), balls.end()) << "the ball at the wall is named";
      EXPECT_LT(result.log.size(), 50'000u);
      EXPECT_EQ(result.summary.stopped->time, 2.5);
    }
}

// Granular crowds end one way or the other, whatever the restitution.
TEST(Persistent, no_granular_gas_hangs) {
  for (const double e : {0.0, 0.1, 0.5}) {
    Scene scene = mixed_box(2, 16, 8.0, 12);
    scene.collision.restitution = e;
    scene.space.restitution = e;
    const Result result = run(scene, scaled_count(50'000));
    EXPECT_EQ(result.summary.exactness.clamped, 0);
    EXPECT_LE(result.summary.energy.relative_error, 1e-15) << "e " << e;
    for (const BallState& b : result.balls)
      for (const double v : b.velocity) EXPECT_TRUE(std::isfinite(v));
  }
}

// Elastic sequences are never taken for a collapse, however fast: Galperin's wedge with 31415 hits is tested elsewhere;
// here a ball in a closing gap of two walls' width 1e-9.
TEST(Persistent, a_rattling_elastic_ball_is_no_collapse) {
  Scene scene = box({0.0}, {1.0 + 1e-9});
  scene.balls = {ball({0.5}, {1.0})};
  const Result result = run(scene, 20'000);
  EXPECT_EQ(result.stop, Stop::events);
  EXPECT_EQ(std::abs(result.balls[0].velocity[0]), 1.0);
}

// Nor is a granular gas that only cools: speeds fall for ever, over many decades, without a contact.
TEST(Persistent, cooling_is_no_collapse) {
  Scene scene = box({0.0, 0.0}, {20.0, 20.0});
  scene.collision.restitution = 1.0;
  scene.space.restitution = 0.5;
  scene.balls = {ball({5.0, 5.0}, {1.0, 0.3})};
  const Result result = run(scene, 50);
  EXPECT_EQ(result.stop, Stop::events) << "each hit halves a component, and the flights grow longer";
  EXPECT_GT(result.summary.time, 1e7);
}

}  // namespace
}  // namespace carom
