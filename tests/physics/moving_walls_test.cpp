// Walls that move and swing: exact sequences, independent high precision, and the energy that they put in.

#include <gtest/gtest.h>

#include <functional>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;
using Digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

WallSpec swinging(WallSpec wall, Coordinates amplitude, double omega, double phase = 0.0) {
  wall.oscillation = OscillationSpec{std::move(amplitude), omega, phase};
  return wall;
}

WallSpec moving(WallSpec wall, Coordinates velocity) {
  wall.velocity = std::move(velocity);
  return wall;
}

WallSpec segment(Coordinates from, Coordinates to) {
  WallSpec w;
  w.kind = WallKind::segment;
  w.from = std::move(from);
  w.to = std::move(to);
  return w;
}

WallSpec polygon(std::vector<Coordinates> vertices) {
  WallSpec w;
  w.kind = WallKind::polygon;
  w.vertices = std::move(vertices);
  return w;
}

// Between a wall at rest and one that comes nearer at V: after n hits of it the speed is v + 2 n V, and (distance at a hit)
// (speed before it + V) is the same at all hits.
TEST(ApproachingPlanes, speed_and_adiabatic_invariant_are_exact) {
  Scene scene = open_space(1);
  scene.walls.push_back(plane({0.0}, {1.0}));
  scene.walls.push_back(moving(plane({1.0}, {-1.0}), {-0.001}));
  scene.balls.push_back(ball({0.25}, {0.5}, 0.0));
  const Result result = run(scene, 401);
  double invariant = 0;
  int n = 0;
  for (const Collision& c : result.log) {
    if (c.partner.number != 1) continue;
    const double speed = c.ball.velocity_before[0], product = c.ball.position[0] * (speed + 0.001);
    if (n == 0) invariant = product;
    EXPECT_NEAR(product, invariant, 1e-14);
    EXPECT_NEAR(speed, 0.5 + 0.002 * n, 1e-14);
    ++n;
  }
  EXPECT_EQ(n, 201);
  const double gained = 0.5 * (std::pow(0.5 + 0.002 * n, 2) - 0.25);
  EXPECT_NEAR(result.summary.energy.injected, gained, 1e-13);
  EXPECT_LE(result.summary.energy.relative_error, 1e-15);
}

// Seen from a wall of infinite mass at speed V that hits a ball at rest, the ball leaves at V: it flies at 2 V.
TEST(MovingWalls, a_circle_and_a_polygon_kick_a_ball_at_rest) {
  for (const bool round : {true, false}) {
    Scene scene = open_space(2);
    const WallSpec wall = round ? circle({-3.0, 0.0}, 1.0, WallSide::outside)
                                : polygon({{-3.0, -1.0}, {-2.0, -1.0}, {-2.0, 2.0}, {-3.0, 2.0}});
    scene.walls.push_back(moving(wall, {0.75, 0.0}));
    scene.balls.push_back(ball({0.0, 0.0}, {0.0, 0.0}, 0.5));
    const Result result = run(scene, 10);
    ASSERT_EQ(result.log.size(), 1u) << round;
    EXPECT_EQ(result.log[0].time, 2.0);
    EXPECT_EQ(result.log[0].ball.velocity_after[0], 1.5);
    EXPECT_EQ(result.log[0].ball.velocity_after[1], 0.0);
    EXPECT_EQ(result.summary.energy.injected, 1.125);
  }
}

// A ball is pushed out of a closed polygon that flies past only by its edges: a point inside stays inside.
TEST(MovingWalls, a_polygon_carries_a_point_along) {
  Scene scene = open_space(2);
  scene.walls.push_back(moving(polygon({{-1.0, -1.0}, {1.0, -1.0}, {1.5, 1.0}, {-1.0, 1.2}}), {0.3, -0.2}));
  scene.balls.push_back(ball({0.1, 0.2}, {0.9, 0.7}, 0.0));
  const Result result = run(scene, scaled_count(20'000));
  const double t = result.summary.time;
  EXPECT_NEAR(result.balls[0].position[0], 0.3 * t + 0.25, 1.26);
  EXPECT_NEAR(result.balls[0].position[1], -0.2 * t + 0.1, 1.11);
  EXPECT_LE(result.summary.energy.relative_error, 1e-13);
}

/// First t > from at which f is 0, for an f > 0 just after `from`: by steps that are short beside its changes, then halving.
Digits first_zero(const std::function<Digits(Digits)>& f, const Digits& from, const Digits& step) {
  Digits low = from, high = from;
  do {
    low = high;
    high += step;
  } while (f(high) > 0);
  for (int k = 0; k < 190; ++k) {
    const Digits middle = (low + high) / 2;
    (f(middle) > 0 ? low : high) = middle;
  }
  return low;
}

// The Fermi-Ulam model: a ball between a wall at rest and one that swings, hit by hit in 60 digits.
TEST(FermiUlam, follows_the_exact_sequence) {
  const double amplitude = 0.05, omega = 2.0, phase = 0.3;
  Scene scene = open_space(1);
  scene.walls.push_back(plane({0.0}, {1.0}));
  scene.walls.push_back(swinging(plane({1.0}, {-1.0}), {amplitude}, omega, phase));
  scene.balls.push_back(ball({0.5}, {1.0}, 0.0));
  const Result result = run(scene, 40);
  ASSERT_EQ(result.log.size(), 40u);
  const auto wall = [&](const Digits& t) { return Digits(1 + Digits(amplitude) * sin(Digits(Digits(omega) * t + Digits(phase)))); };
  Digits t = 0, x = 0.5, v = 1;
  for (const Collision& c : result.log) {
    if (v < 0) {
      t -= x / v;
      x = 0;
      v = -v;
    } else {
      // Before the wall can be there at all nothing happens; a wall that has just been hit runs away or is left behind.
      const Digits start = t;
      t = first_zero([&](const Digits& s) { return Digits(wall(s) - (x + v * (s - start))); }, t + Digits(1e-9), Digits(1e-3));
      x = wall(t);
      v = 2 * Digits(amplitude) * omega * cos(Digits(Digits(omega) * t + Digits(phase))) - v;
    }
    EXPECT_NEAR(c.time, static_cast<double>(t), 1e-10);
    EXPECT_NEAR(c.ball.velocity_after[0], static_cast<double>(v), 1e-9);
  }
  EXPECT_LE(result.summary.energy.relative_error, 1e-14);
  EXPECT_NE(result.summary.energy.injected, 0.0);
}

/// The distance of a moving point from a swinging wall's place at t.
struct Course {
  double x[2], v[2], g;
  double amplitude[2], omega, phase;

  [[nodiscard]] Digits at(int k, const Digits& t) const {
    const Digits fall = k == 1 ? Digits(Digits(g) * t * t / 2) : Digits(0);
    return Digits(x[k]) + v[k] * t + fall - Digits(amplitude[k]) * sin(Digits(Digits(omega) * t + phase));
  }
};

// First hits of one ball on one swinging wall, straight and falling, beside a search in 60 digits.
TEST(SwingingWalls, first_hits_are_those_of_a_fine_search) {
  Dice dice(11);
  int hits = 0;
  for (int n = 0; n < 32; ++n) {
    const int kind = n % 4;
    const double radius = kind == 3 ? 0.0 : 0.2;
    Course c{{dice.between(-1, 1), 3.0}, {dice.between(-0.4, 0.4), dice.between(-1, -0.3)}, n % 2 == 0 ? 0.0 : -0.5,
             {dice.between(-0.4, 0.4), dice.between(-0.4, 0.4)}, dice.between(0.5, 8), dice.between(0, 6)};
    Scene scene = open_space(2);
    if (c.g != 0) scene.motion.acceleration = {0.0, c.g};
    const Coordinates amplitude{c.amplitude[0], c.amplitude[1]};
    if (kind == 0) scene.walls.push_back(swinging(plane({0.0, 0.0}, {0.0, 1.0}), amplitude, c.omega, c.phase));
    if (kind == 1) scene.walls.push_back(swinging(circle({0.0, 0.0}, 1.0, WallSide::outside), amplitude, c.omega, c.phase));
    if (kind >= 2) scene.walls.push_back(swinging(segment({-3.0, 0.0}, {3.0, 0.0}), amplitude, c.omega, c.phase));
    scene.balls.push_back(ball({c.x[0], c.x[1]}, {c.v[0], c.v[1]}, radius));
    const auto distance = [&](const Digits& t) {
      const Digits x = c.at(0, t), y = c.at(1, t);
      if (kind == 1) return Digits(sqrt(Digits(x * x + y * y)) - 1 - radius);
      return Digits(y - radius);
    };
    const Result result = run(scene, 1);
    if (result.log.empty()) {
      EXPECT_EQ(kind, 1) << "no ball misses a floor that is wide enough: " << n;
      for (double t = 0; t < 20; t += 0.01) EXPECT_GT(distance(t), 0) << n;
      continue;
    }
    ++hits;
    const Digits exact = first_zero(distance, 0, Digits(2.5e-3));
    EXPECT_NEAR(result.log[0].time, static_cast<double>(exact), 1e-13) << n;
  }
  EXPECT_GT(hits, 25);
}

// Inside a swinging circle, and in a swinging closed polygon, a ball stays; energy goes in and out and is booked.
TEST(SwingingWalls, keep_a_ball_inside) {
  for (const bool round : {true, false}) {
    Scene scene = open_space(2);
    const WallSpec wall = round ? circle({0.0, 0.0}, 1.0, WallSide::inside)
                                : polygon({{-1.0, -1.0}, {1.0, -1.0}, {1.2, 0.9}, {-0.8, 1.0}});
    scene.walls.push_back(swinging(wall, {0.1, 0.05}, 3.0, 0.4));
    scene.balls.push_back(ball({0.1, 0.2}, {0.9, 0.7}, round ? 0.1 : 0.0));
    const Result result = run(scene, scaled_count(20'000));
    EXPECT_EQ(result.stop, Stop::events);
    EXPECT_LE(std::abs(result.balls[0].position[0].value), 1.4) << round;
    EXPECT_LE(std::abs(result.balls[0].position[1].value), 1.2) << round;
    EXPECT_LE(result.summary.energy.relative_error, 1e-12);
    EXPECT_LE(result.summary.exactness.max_gap_error, 1e-12);
    EXPECT_EQ(result.summary.exactness.clamped, 0);
  }
}

// A ball on a shaken plate under gravity, elastic and not: it may come to chatter, which is named, and never hangs or sinks.
TEST(SwingingWalls, a_ball_bounces_on_a_shaken_plate) {
  for (const double e : {1.0, 0.9, 0.5}) {
    Scene scene = open_space(1);
    scene.motion.acceleration = {-1.0};
    scene.collision.restitution = e;
    scene.walls.push_back(swinging(plane({0.0}, {1.0}), {0.05}, 7.0));
    scene.balls.push_back(ball({0.8}, {0.0}, 0.1));
    Simulation simulation(scene);
    const Stop stop = simulation.advance(std::nullopt, scaled_count(20'000));
    EXPECT_TRUE(stop == Stop::events || (e < 1 && stop == Stop::collapse)) << e;
    EXPECT_GE(simulation.ball(0).position[0], -0.06) << e;
    EXPECT_LE(simulation.summary().energy.relative_error, 1e-12) << e;
  }
}

// A clap of the hands: a wall that passes another, and a start far from the time 0.
TEST(SwingingWalls, depend_on_the_time_of_the_clock) {
  Scene scene = open_space(1);
  scene.walls.push_back(swinging(plane({0.0}, {1.0}), {0.5}, 2.0));
  scene.balls.push_back(ball({2.0}, {-1.0}, 0.0));
  const double early = run(scene, 1).log.at(0).time;
  scene.run.start = 1e6;
  const double late = run(scene, 1).log.at(0).time;
  EXPECT_NEAR(2.0 - early, 0.5 * std::sin(2 * early), 1e-14);
  EXPECT_NEAR(2.0 - (late - 1e6), 0.5 * std::sin(2 * late), 1e-9) << "time is 1e6, rounded to 1e-10";
  EXPECT_GT(std::abs(late - 1e6 - early), 1e-3);
}

TEST(SwingingWalls, have_the_same_log_under_every_search_and_queue) {
  Scene scene = mixed_box(2, 25, 12.0, 3);
  scene.walls.push_back(swinging(segment({-1.0, -2.0}, {13.0, -2.0}), {0.0, 2.2}, 2.0, 4.0));
  scene.walls.push_back(swinging(circle({-3.0, 6.0}, 2.0, WallSide::outside), {1.5, 0.0}, 1.0, 4.0));
  scene.walls.push_back(moving(polygon({{13.0, 0.0}, {14.0, 1.0}, {13.0, 12.0}}), {-0.1, 0.05}));
  const std::int64_t events = scaled_count(2000);
  scene.engine.search = SearchKind::all_pairs;
  const Result first = run(scene, events);
  ASSERT_EQ(first.log.size(), std::size_t(events));
  EXPECT_NE(first.summary.energy.injected, 0.0);
  EXPECT_LE(first.summary.energy.relative_error, 1e-13);
  EXPECT_EQ(first.summary.exactness.clamped, 0);
  scene.engine.search = SearchKind::cells;
  scene.engine.queue = QueueKind::calendar;
  EXPECT_EQ(difference(first.log, run(scene, events).log), "");
  Simulation reference = Simulation::reference(scene);
  std::vector<Collision> log;
  for (int k = 0; k < 5; ++k) {
    reference.advance(std::nullopt, events / 5, [&](const Collision& c) { log.push_back(c); });
    EXPECT_EQ(reference.audit(AuditBy::every_pair).overlaps, 0) << k;
  }
  EXPECT_EQ(difference(first.log, log), "");
}

// A wall that swings in its own plane does nothing.
TEST(SwingingWalls, along_themselves_do_nothing_to_a_ball_over_the_middle) {
  Scene still = open_space(2), swings = open_space(2);
  still.walls.push_back(plane({0.0, 0.0}, {0.0, 1.0}));
  swings.walls.push_back(swinging(plane({0.0, 0.0}, {0.0, 1.0}), {0.7, 0.0}, 5.0));
  for (Scene* s : {&still, &swings}) s->balls.push_back(ball({0.3, 2.0}, {0.4, -1.0}, 0.5));
  EXPECT_NEAR(run(still, 2).log.at(0).time, run(swings, 2).log.at(0).time, 1e-15);
  EXPECT_EQ(run(swings, 2).log.size(), 1u);
  EXPECT_EQ(run(swings, 2).log.at(0).ball.velocity_after, run(still, 2).log.at(0).ball.velocity_after);
}

}  // namespace
}  // namespace carom
