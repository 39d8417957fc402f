// Balls on circles in a magnetic field: integrable cases in closed form, joints that do not leak, and the same events whoever
// searches for them.

#include <gtest/gtest.h>

#include <numbers>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

constexpr double pi = std::numbers::pi;

double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * pi)); }

Scene in_field(Scene scene, double omega) {
  scene.motion.magnetic = omega;
  return scene;
}

WallSpec segment(Coordinates from, Coordinates to) {
  WallSpec w;
  w.kind = WallKind::segment;
  w.from = std::move(from);
  w.to = std::move(to);
  return w;
}

WallSpec regular_polygon(int sides, double radius, double turned) {
  WallSpec w;
  w.kind = WallKind::polygon;
  for (int k = 0; k < sides; ++k) {
    const double a = turned + 2 * pi * k / sides;
    w.vertices.push_back({radius * std::cos(a), radius * std::sin(a)});
  }
  return w;
}

// The guiding centre keeps its distance d from the centre of the circle; with r = v / omega the hits advance by 2 alpha or
// 2 pi - 2 alpha, cos(alpha) = (R^2 + d^2 - r^2) / (2 R d).
void expect_advance(double omega, double radius_of_ball) {
  Scene scene = in_field(open_space(2), omega);
  scene.walls.push_back(circle({0.0, 0.0}, 1.0 + radius_of_ball, WallSide::inside));
  scene.balls.push_back(ball({0.3, 0.1}, {std::cos(1.1), std::sin(1.1)}, radius_of_ball));
  const double r = 1 / omega, cx = 0.3 - r * std::sin(1.1), cy = 0.1 + r * std::cos(1.1), d = std::hypot(cx, cy);
  const double alpha = std::acos((1 + d * d - r * r) / (2 * d));
  const Result result = run(scene, 61);
  ASSERT_EQ(result.log.size(), 61u);
  const auto angle = [&](std::size_t k) { return std::atan2(result.log[k].ball.position[1], result.log[k].ball.position[0]); };
  const double step = angle_between(angle(1) - angle(0), 2 * alpha) < 1e-9 ? 2 * alpha : 2 * pi - 2 * alpha;
  for (std::size_t k = 0; k <= 60; ++k) {
    EXPECT_LE(angle_between(angle(k), angle(0) + double(k) * step), 1e-11) << "hit " << k;
    const Collision& c = result.log[k];
    const double gx = c.ball.position[0] - r * c.ball.velocity_after[1], gy = c.ball.position[1] + r * c.ball.velocity_after[0];
    EXPECT_NEAR(std::hypot(gx, gy), d, 1e-13);
  }
  EXPECT_LE(result.summary.energy.relative_error, 1e-15);
  EXPECT_EQ(result.summary.exactness.clamped, 0);
}

TEST(MagneticCircle, hits_advance_by_a_constant_angle) {
  expect_advance(0.7, 0.0);
  expect_advance(0.7, 0.25);
  expect_advance(-0.7, 0.0);
  expect_advance(1.2, 0.0);
  expect_advance(0.01, 0.0);
}

TEST(MagneticCircle, reference_values) {
  Scene scene = in_field(open_space(2), 0.7);
  scene.walls.push_back(circle({0.0, 0.0}, 1.0, WallSide::inside));
  scene.balls.push_back(ball({0.3, 0.1}, {std::cos(1.1), std::sin(1.1)}, 0.0));
  const Result result = run(scene, 2);
  const auto& a = result.log[0].ball.position;
  const auto& b = result.log[1].ball.position;
  EXPECT_LE(angle_between(std::atan2(b[1], b[0]) - std::atan2(a[1], a[0]), 3.523330217553), 1e-12);
}

// Impacts and turns round the velocity each time: the error of the energy is a walk, about 1e-16 sqrt(n), and no slope.
TEST(MagneticCircle, energy_and_guiding_centre_stay_over_a_million_hits) {
  Scene scene = in_field(open_space(2), 0.7);
  scene.walls.push_back(circle({0.0, 0.0}, 1.0, WallSide::inside));
  scene.balls.push_back(ball({0.3, 0.1}, {std::cos(1.1), std::sin(1.1)}, 0.0));
  const std::int64_t hits = scaled_count(1'000'000);
  Simulation simulation(scene);
  ASSERT_EQ(simulation.advance(std::nullopt, hits), Stop::events);
  const Summary summary = simulation.summary();
  EXPECT_LE(summary.energy.relative_error, 1e-16 * 5 * std::sqrt(double(hits)));
  EXPECT_LE(summary.exactness.max_gap_error, 1e-14);
  const BallState b = simulation.ball(0);
  const double gx = b.position[0] - b.velocity[1] / 0.7, gy = b.position[1] + b.velocity[0] / 0.7;
  EXPECT_NEAR(std::hypot(gx, gy), 1.227405065761338, 1e-12);
}

// Above a wall with the centre of the circle at the height h < r: skips of 2 sqrt(r^2 - h^2), all of one length.
TEST(MagneticWall, skipping_orbit_along_a_plane) {
  for (const double h : {-0.6, 0.0, 0.8}) {
    Scene scene = in_field(open_space(2), 1.0);
    scene.walls.push_back(plane({0.0, 0.0}, {0.0, 1.0}));
    scene.balls.push_back(ball({0.0, h + 1.25}, {-1.0, 0.0}, 0.25));  // at the top of a circle about (0, h + 0.25)
    const double skip = 2 * std::sqrt(1 - h * h);
    const Result result = run(scene, 1001);
    ASSERT_EQ(result.log.size(), 1001u) << h;
    for (std::size_t k = 1; k <= 1000; ++k) {
      EXPECT_NEAR(std::abs(result.log[k].ball.position[0] - result.log[0].ball.position[0]), double(k) * skip, double(k) * 1.2e-13);  // half an ulp each
      EXPECT_NEAR(result.log[k].ball.position[1], 0.25, 1e-14);
    }
  }
}

// A circle that comes to no wall is flown for ever, and nothing is waited for.
TEST(MagneticWall, a_ball_that_reaches_nothing_never_hits) {
  Scene scene = in_field(box({-3.0, -3.0}, {3.0, 3.0}), 2.0);
  scene.walls.push_back(segment({1.0, -1.0}, {1.0, 1.0}));
  scene.balls.push_back(ball({0.0, 0.0}, {0.0, 1.0}, 0.1));
  scene.balls.push_back(ball({-1.5, 0.0}, {0.0, 0.5}, 0.1));
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance(std::nullopt), Stop::no_events_left);
  simulation.advance(Number(pi));  // a turn
  EXPECT_NEAR(simulation.ball(0).position[0], 0.0, 1e-15);
  EXPECT_NEAR(simulation.ball(0).position[1], 0.0, 1e-15);
  EXPECT_EQ(simulation.ball(0).velocity[1], 1.0);
}

TEST(MagneticWall, comes_round_the_end_of_a_segment_to_its_other_side) {
  // A circle of radius 1 about the end of a segment along x < 0: a point that leaves upwards from (-1, 0) comes back to it from
  // below after a turn, and so on; clockwise it passes over the end.
  Scene scene = in_field(open_space(2), -1.0);
  scene.walls.push_back(segment({-3.0, 0.0}, {0.0, 0.0}));
  scene.balls.push_back(ball({0.0, 1.0}, {1.0, 0.0}, 0.0));
  const Result result = run(scene, 3);
  ASSERT_EQ(result.log.size(), 3u);
  EXPECT_NEAR(result.log[0].time, 1.5 * pi, 1e-14);  // from below, at (-1, 0)
  EXPECT_NEAR(result.log[0].ball.position[0], -1.0, 1e-14);
  EXPECT_LT(result.log[0].ball.velocity_after[1], 0.0);
}

// r(s) of two balls of one frequency is a circle too: about a fixed ball by the law of cosines.
TEST(MagneticPair, meets_a_fixed_ball_and_a_moving_one) {
  Scene scene = in_field(open_space(2), 1.0);
  scene.balls.push_back(ball({0.0, 0.0}, {0.0, 0.0}, 0.5));
  scene.balls.back().fixed = true;
  scene.balls.push_back(ball({2.5, 0.0}, {0.0, 1.0}, 0.25));  // about (1.5, 0)
  const double cosine = (0.75 * 0.75 - 1.5 * 1.5 - 1) / (2 * 1.5);
  EXPECT_NEAR(run(scene, 1).log.at(0).time, std::acos(cosine), 1e-15);
  scene.balls[0].fixed = false;
  scene.balls[0].velocity = {0.3, -0.2};
  scene.balls[1].velocity = {0.3, 0.8};
  EXPECT_NEAR(run(scene, 1).log.at(0).time, std::acos(cosine), 2e-15);
}

/// First t at which f, > 0 before it, is 0: by steps that are short beside its changes, then halving.
template <class F>
double first_zero(F&& f, double step) {
  long double low = 0, high = 0;
  do {
    low = high;
    high += step;
  } while (f(high) > 0 && high < 1000);
  for (int k = 0; k < 100; ++k) {
    const long double middle = (low + high) / 2;
    (f(middle) > 0 ? low : high) = middle;
  }
  return double(low);
}

// A circle and the arcs that it can be made of are one table.
TEST(MagneticCircle, of_two_arcs_is_a_circle) {
  for (const double radius : {0.0, 0.1})
    for (const double omega : {0.7, -2.0}) {
      Scene whole = in_field(open_space(2), omega);
      whole.balls.push_back(ball({0.3, 0.1}, {std::cos(1.1), std::sin(1.1)}, radius));
      Scene halves = whole;
      whole.walls.push_back(circle({0.0, 0.0}, 1.0, WallSide::inside));
      for (const double from : {0.4, 0.4 + pi}) {
        WallSpec arc;
        arc.kind = WallKind::arc;
        arc.centre = {0.0, 0.0};
        arc.radius = 1.0;
        arc.from_angle = from;
        arc.to_angle = from + pi;
        halves.walls.push_back(arc);
      }
      const Result expected = run(whole, 200), found = run(halves, 200);
      ASSERT_EQ(found.log.size(), 200u);
      for (std::size_t k = 0; k < 200; ++k) {
        EXPECT_NEAR(found.log[k].time, expected.log[k].time, 1e-10) << k;
        EXPECT_NEAR(found.log[k].ball.position[0], expected.log[k].ball.position[0], 1e-10) << k;
      }
    }
}

// Walls that come across a field, to a ball on a circle of radius 1 / omega about (0, 0).
TEST(MagneticWall, that_moves_meets_a_circling_ball) {
  Dice dice(5);
  for (int n = 0; n < 30; ++n) {
    const double omega = dice.between(0.8, 6.0), speed = dice.between(0.02, 0.5), phase = dice.between(0.0, 2 * pi);
    const double radius = n % 3 == 1 ? 0.0 : 0.3;
    Scene scene = in_field(open_space(2), omega);
    WallSpec wall = n % 3 == 0   ? plane({0.0, -4.0}, {0.0, 1.0})
                    : n % 3 == 1 ? segment({-9.0, -4.0}, {9.0, -4.0})
                                 : circle({0.0, -5.0}, 1.0, WallSide::outside);
    wall.velocity = {0.0, speed};
    scene.walls.push_back(wall);
    scene.balls.push_back(ball({std::cos(phase) / omega, std::sin(phase) / omega}, {-std::sin(phase), std::cos(phase)}, radius));
    const double hit = first_zero(
        [&](long double t) {
          const long double a = phase + omega * t, y = std::sin(a) / omega - (speed * t - 4);
          return n % 3 < 2 ? y - radius : std::hypot(y + 1, std::cos(a) / omega) - 1 - radius;
        },
        1e-3);
    const Result result = run(scene, 1);
    ASSERT_EQ(result.log.size(), 1u) << n;
    EXPECT_NEAR(result.log[0].time, hit, 1e-12) << n;
    EXPECT_GT(result.summary.energy.injected, 0.0);
  }
}

TEST(MagneticWall, that_moves_past_for_good_is_done_with) {
  Scene scene = in_field(open_space(2), 2.0);
  scene.walls.push_back(circle({-9.0, 2.0}, 1.0, WallSide::outside));
  scene.walls.back().velocity = {1.0, 0.0};
  scene.walls.push_back(segment({-9.0, -2.0}, {-8.0, -2.0}));
  scene.walls.back().velocity = {1.0, 0.0};
  scene.balls.push_back(ball({0.0, 0.5}, {-1.0, 0.0}, 0.2));
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance(std::nullopt), Stop::no_events_left);
}

// A point aimed at every vertex of a closed polygon, exactly and beside it, stays inside.
TEST(MagneticJoints, do_not_leak) {
  for (const double omega : {0.3, -1.7, 6.0})
    for (const double beside : {0.0, 1e-16, -1e-16, 1e-12, 1e-8})
      for (const int sides : {3, 4, 7}) {
        Scene scene = in_field(open_space(2), omega);
        scene.walls.push_back(regular_polygon(sides, 1.0, 0.1));
        // The chord from the centre's neighbourhood to the vertex, on an arc of this curvature.
        const double start = 0.2, vx = std::cos(0.1), vy = std::sin(0.1), length = 1 - start;
        const double lean = std::asin(length * omega / 2);
        if (std::abs(length * omega / 2) >= 1) continue;
        const double aim = 0.1 - lean + beside;
        scene.balls.push_back(ball({start * vx, start * vy}, {std::cos(aim), std::sin(aim)}, 0.0));
        const Result result = run(scene, scaled_count(2000));
        for (const Collision& c : result.log) {
          const double out = std::hypot(c.ball.position[0], c.ball.position[1]);
          ASSERT_LE(out, 1 + 1e-12) << omega << ' ' << beside << ' ' << sides;
        }
        if (result.stop == Stop::collapse) continue;  // skips into a corner without end
        const BallState& b = result.balls.at(0);
        EXPECT_LE(std::hypot(b.position[0].value, b.position[1].value), 1 + 1e-12) << omega << ' ' << beside << ' ' << sides;
        EXPECT_GT(result.log.size(), 0u);
      }
}

Scene crowd(bool periodic) {
  Scene scene = in_field(mixed_box(2, 36, 12.0, 7), 0.9);
  if (periodic) scene.space.kind = SpaceKind::periodic;
  scene.balls[17].fixed = true;
  scene.balls[17].velocity = {0.0, 0.0};
  return scene;
}

TEST(MagneticCrowd, has_the_same_log_under_every_search_and_queue) {
  for (const bool periodic : {false, true}) {
    Scene scene = crowd(periodic);
    const std::int64_t events = scaled_count(1000);
    scene.engine.search = SearchKind::all_pairs;
    const Result first = run(scene, events);
    ASSERT_EQ(first.log.size(), std::size_t(events));
    for (const SearchKind search : {SearchKind::all_pairs, SearchKind::cells})
      for (const QueueKind queue : {QueueKind::heap, QueueKind::calendar}) {
        scene.engine.search = search;
        scene.engine.queue = queue;
        EXPECT_EQ(difference(first.log, run(scene, events).log), "") << periodic << int(search) << int(queue);
      }
    Simulation reference = Simulation::reference(scene);
    std::vector<Collision> log;
    reference.advance(std::nullopt, events, [&](const Collision& c) { log.push_back(c); });
    EXPECT_EQ(difference(first.log, log), "");
    EXPECT_EQ(first.summary.exactness.clamped, 0);
    EXPECT_LE(first.summary.energy.relative_error, 1e-14);
    EXPECT_FALSE(first.summary.momentum.relative_error) << "the field turns it";
    EXPECT_EQ(reference.audit(AuditBy::every_pair).overlaps, 0);
  }
}

TEST(MagneticCrowd, goes_back_when_the_field_is_turned_round_too) {
  Scene scene = crowd(false);
  Simulation simulation(scene);
  simulation.advance(Number(2.0));
  EXPECT_GT(simulation.counts().collisions(), 20);
  simulation.reverse();
  simulation.advance(Number(4.0));
  for (std::uint32_t i = 0; i < simulation.ball_count(); ++i)
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(simulation.ball(i).position[k], scene.balls[i].position[k], 1e-7) << i;
}

TEST(MagneticCrowd, balls_that_never_meet_end_the_run_in_a_periodic_space) {
  Scene scene = in_field(open_space(2), 1.0);
  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {0.0, 0.0};
  scene.space.upper = {10.0, 10.0};
  scene.balls.push_back(ball({0.5, 0.5}, {1.0, 0.0}, 0.3));  // crosses the edges of the cell
  scene.balls.push_back(ball({5.5, 5.5}, {1.0, 0.0}, 0.3));
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance(std::nullopt), Stop::no_events_left);
}

TEST(MagneticCrowd, more_digits_tell_the_same_at_first) {
  const Scene scene = crowd(false);
  const Result plain = run(scene, 25);
  Simulation precise(scene, Precision::decimal(40));
  std::size_t k = 0;
  precise.advance(std::nullopt, 25, [&](const Collision& c) {
    ASSERT_LT(k, plain.log.size());
    EXPECT_EQ(c.ball.number, plain.log[k].ball.number);
    EXPECT_EQ(c.partner.number, plain.log[k].partner.number);
    EXPECT_NEAR(c.time, plain.log[k].time, 1e-11);
    ++k;
  });
  EXPECT_EQ(k, 25u);
  EXPECT_LE(precise.summary().energy.relative_error.value, 1e-38);
}

}  // namespace
}  // namespace carom
