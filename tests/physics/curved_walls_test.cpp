// Balls between curved walls: against circles, against geometry computed another way, and by what is conserved.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "carom/core/error.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;
using std::numbers::pi;

WallSpec arc(Coordinates centre, double radius, double from, double to) {
  WallSpec w;
  w.kind = WallKind::arc;
  w.centre = std::move(centre);
  w.radius = radius;
  w.from_angle = from;
  w.to_angle = to;
  return w;
}
WallSpec ellipse(double a, double b) {
  WallSpec w;
  w.kind = WallKind::ellipse;
  w.centre = {0.0, 0.0};
  w.axes = {a, b};
  return w;
}
WallSpec curve(std::vector<Number> cosines) {
  WallSpec w;
  w.kind = WallKind::curve;
  w.centre = {0.0, 0.0};
  w.cosines = std::move(cosines);
  return w;
}
WallSpec parabola(double vertex, double angle) {
  WallSpec w;
  w.kind = WallKind::parabola;
  w.centre = {vertex, 0.0};
  w.angle = angle;
  w.focal_length = 1.0;
  w.half_width = 1.0;
  return w;
}
std::vector<WallSpec> rounded_square() {
  std::vector<WallSpec> walls{segment({-0.5, -1.0}, {0.5, -1.0}), segment({1.0, -0.5}, {1.0, 0.5}),
                              segment({0.5, 1.0}, {-0.5, 1.0}), segment({-1.0, 0.5}, {-1.0, -0.5})};
  for (int k = 0; k < 4; ++k) {
    const double x = k == 0 || k == 1 ? 0.5 : -0.5, y = k == 1 || k == 2 ? 0.5 : -0.5;
    walls.push_back(arc({x, y}, 0.5, (k - 1) * pi / 2, k * pi / 2));
  }
  return walls;
}

Scene with_walls(std::vector<WallSpec> walls, double radius, double pull = 0) {
  Scene scene = open_space(2);
  scene.walls = std::move(walls);
  scene.balls = {ball({0.1, 0.2}, {0.6, 0.77}, radius)};
  if (pull != 0) scene.motion.acceleration = {0.0, -pull};
  return scene;
}

// A circle in two halves is a circle: the joints are met by nobody.
TEST(Arcs, that_make_a_circle_are_one) {
  for (const double radius : {0.0, 0.25}) {
    const Result whole = run(with_walls({circle({0.0, 0.0}, 1.0, WallSide::inside)}, radius), 1000);
    const Result halves = run(with_walls({arc({0.0, 0.0}, 1.0, 0.0, pi), arc({0.0, 0.0}, 1.0, pi, 2 * pi)}, radius), 1000);
    ASSERT_EQ(halves.log.size(), 1000u);
    for (std::size_t i = 0; i < 1000; ++i) {
      EXPECT_NEAR(halves.log[i].ball.position[0], whole.log[i].ball.position[0], 1e-10);
      EXPECT_NEAR(halves.log[i].ball.position[1], whole.log[i].ball.position[1], 1e-10);
      EXPECT_EQ(halves.log[i].curvature, -1.0);
    }
    EXPECT_EQ(halves.summary.exactness.singular, 0);
  }
}

/// Foot of (p, q) on the ellipse by the multiplier of Lagrange, bisected: (a^2 p / (t + a^2), b^2 q / (t + b^2)).
double distance_to_ellipse(double p, double q, double a, double b) {
  long double low = -std::min(a, b) * std::min(a, b), high = a * std::abs(p) + b * std::abs(q);
  const auto foot = [&](long double t) {
    return std::pair{a * a * std::abs(p) / (t + a * a), b * b * std::abs(q) / (t + b * b)};
  };
  for (int i = 0; i < 200; ++i) {
    const long double t = (low + high) / 2;
    const auto [x, y] = foot(t);
    ((x / a) * (x / a) + (y / b) * (y / b) > 1 ? low : high) = t;
  }
  const auto [x, y] = foot(low);
  return static_cast<double>(std::hypot(x - std::abs(p), y - std::abs(q)));
}

// A ball in an ellipse turns back where its centre is its radius away from it, and never comes nearer on the way.
TEST(Ellipse, turns_balls_back_at_their_radius) {
  const double a = 2.0, b = 1.0;
  for (const double radius : {0.1, 0.3, 0.55}) {  // the last is above the smallest radius of curvature, b^2/a
    const Result r = run(with_walls({ellipse(a, b)}, radius), 300);
    ASSERT_EQ(r.log.size(), 300u);
    for (std::size_t i = 1; i < r.log.size(); ++i) {
      const auto &from = r.log[i - 1].ball.position, &to = r.log[i].ball.position;
      EXPECT_NEAR(distance_to_ellipse(to[0], to[1], a, b), radius, 1e-13);
      for (const double s : {0.25, 0.5, 0.75})
        EXPECT_GE(distance_to_ellipse(from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1]), a, b), radius - 1e-13);
    }
    EXPECT_LE(r.summary.energy.relative_error.value, 1e-14);
    EXPECT_LE(r.summary.exactness.max_gap_error.value, 1e-13);
  }
}

// The product of the angular momenta about the two foci is conserved: each hit rounds it by some 2e-16, up as often as down.
TEST(Ellipse, keeps_the_product_of_angular_momenta) {
  const double focus = std::sqrt(3.0);
  double low = HUGE_VAL, high = -HUGE_VAL;
  Scene scene = with_walls({ellipse(2.0, 1.0)}, 0.0);
  scene.balls = {ball({2 * std::cos(0.3), std::sin(0.3)}, {std::cos(2.5), std::sin(2.5)}, 0.0)};
  const std::int64_t hits = scaled_count(100'000);
  Simulation simulation(scene);
  simulation.advance(std::nullopt, hits, [&](const Collision& c) {
    const auto &x = c.ball.position, &v = c.ball.velocity_after;
    const double product = ((x[0] - focus) * v[1] - x[1] * v[0]) * ((x[0] + focus) * v[1] - x[1] * v[0]);
    low = std::min(low, product / (v[0] * v[0] + v[1] * v[1]));
    high = std::max(high, product / (v[0] * v[0] + v[1] * v[1]));
  });
  EXPECT_NEAR(low, 0.8305520941916194, 1e-12);
  EXPECT_LE(high - low, 1e-12);
}

// Curvature a b / (a^2 sin^2 u + b^2 cos^2 u)^(3/2), and 4 s from the tip of a cardioid r = s (1 + cos theta) to its cusp.
TEST(CurvedWalls, tell_curvature_and_arclength) {
  Scene scene = with_walls({ellipse(2.0, 1.0)}, 0.0);
  scene.balls = {ball({0.0, 0.0}, {0.0, 1.0}, 0.0)};
  EXPECT_NEAR(run(scene, 1).log[0].curvature, -0.25, 1e-14);  // at the end of the short axis: -b/a^2
  scene.balls = {ball({0.0, 0.0}, {1.0, 0.0}, 0.25)};
  EXPECT_NEAR(run(scene, 1).log[0].curvature, -2.0, 1e-13);   // -a/b^2
  scene.walls = {curve({1.0, 1.0})};
  scene.balls = {ball({0.5, 0.0}, {-0.5, 0.5}, 0.0)};
  const Collision c = run(scene, 1).log[0];
  const double theta = std::atan2(c.ball.position[1], c.ball.position[0]);
  EXPECT_NEAR(c.arclength, 4 * std::sin(theta / 2), 1e-12);
  EXPECT_NEAR(c.curvature, -0.75 / std::cos(theta / 2), 1e-12);
}

struct Place {
  const char* name;
  std::vector<WallSpec> walls;
};
std::vector<Place> places() {
  return {{"rounded square", rounded_square()},
          {"two parabolas", {parabola(-0.25, 0.0), parabola(0.25, pi)}},
          {"ellipse", {ellipse(2.0, 1.0)}},
          {"cardioid", {curve({1.0, 1.0})}},
          {"wavy curve", {curve({1.0, 0.0, 0.1, 0.05})}}};
}

// Elastic walls keep the energy, whatever they look like; balls stay inside; another search and queue give the same log.
TEST(CurvedWalls, keep_energy_and_hold_points_and_balls) {
  for (const Place& place : places())
    for (const double radius : {0.0, 0.05})
      for (const double pull : {0.0, 1.0, -1.0}) {  // -1: a field, which turns by 1 a unit of time
        Scene scene = with_walls(place.walls, radius, std::max(pull, 0.0));
        if (pull < 0) scene.motion.magnetic = 1.0;
        scene.balls[0].position = {0.05, 0.2};
        const std::int64_t hits = scaled_count(1000);
        const Result r = run(scene, hits);
        EXPECT_EQ(r.log.size(), static_cast<std::size_t>(hits)) << place.name << ' ' << radius << ' ' << pull;
        EXPECT_LE(r.summary.energy.relative_error.value, 1e-13) << place.name;
        EXPECT_EQ(r.summary.exactness.clamped, 0) << place.name;
        for (const Collision& c : r.log) EXPECT_LT(std::hypot(c.ball.position[0], c.ball.position[1]), 2.1) << place.name;
        Simulation other = Simulation::reference(scene);
        std::vector<Collision> log;
        other.advance(std::nullopt, 100, [&](const Collision& c) { log.push_back(c); });
        EXPECT_EQ(difference({r.log.begin(), r.log.begin() + 100}, log), "") << place.name;
      }
}

// A point aimed at a joint without a corner, and beside it, is turned back like anywhere else, and stays inside.
TEST(CurvedWalls, have_joints_that_let_nothing_out) {
  const double joints[][2] = {{0.5, -1.0}, {1.0, -0.5}, {1.0, 0.5}, {-0.5, 1.0}, {-1.0, -0.5}};
  for (const auto& joint : joints)
    for (const double aside : {0.0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-8, -1e-8})
      for (const double pull : {0.0, 0.5}) {
        Scene scene = with_walls(rounded_square(), 0.0, pull);
        const double dx = joint[0] - 0.1, dy = joint[1] - 0.2;  // there after a time 1
        scene.balls[0].velocity = {dx - aside * dy, dy + aside * dx + pull / 2};
        const Result r = run(scene, 100);
        EXPECT_EQ(r.log.size(), 100u) << joint[0] << ' ' << joint[1] << ' ' << aside << ' ' << pull;
        EXPECT_EQ(r.summary.exactness.singular, 0);
        for (const Collision& c : r.log)
          EXPECT_LE(std::max(std::abs(c.ball.position[0]), std::abs(c.ball.position[1])), 1 + 1e-12);
      }
}

// A point that leaves a wall almost along it comes back to it a little further on, and never gets out.
TEST(CurvedWalls, hold_points_that_run_along_them) {
  for (const bool wavy : {false, true})
    for (const double up : {1e-2, 1e-4, 1e-6})
      for (const double field : {0.0, 0.3}) {
        Scene scene = with_walls({wavy ? curve({1.0, 0.0, 0.02}) : ellipse(2.0, 1.0)}, 0.0);
        if (field != 0) scene.motion.magnetic = field;
        scene.balls = {ball({0.0, (wavy ? 0.98 : 1.0) - up}, {1.0, 0.0}, 0.0)};
        const std::int64_t hits = scaled_count(500);
        const Result r = run(scene, hits);
        EXPECT_EQ(r.log.size(), static_cast<std::size_t>(hits)) << wavy << ' ' << up << ' ' << field;
        for (const Collision& c : r.log) {
          const double p = c.ball.position[0], q = c.ball.position[1], out = std::hypot(p, q);
          const double form = wavy ? out - (1 + 0.02 * std::cos(2 * std::atan2(q, p))) : p * p / 4 + q * q - 1;
          ASSERT_LE(std::abs(form), 1e-12) << wavy << ' ' << up << ' ' << field;
        }
      }
}

// The same table across the edges of a periodic cell.
TEST(CurvedWalls, have_joints_that_let_nothing_out_in_a_periodic_space) {
  const double joints[][2] = {{0.5, -1.0}, {1.0, -0.5}, {1.0, 0.5}, {-0.5, 1.0}, {-1.0, -0.5}};
  for (const auto& joint : joints)
    for (const double aside : {0.0, 1e-16, -1e-16, 1e-12, 1e-8}) {
      Scene scene = with_walls(rounded_square(), 0.0);
      scene.space.kind = SpaceKind::periodic;
      scene.space.lower = {0.0, 0.0};
      scene.space.upper = {3.0, 3.0};
      const double dx = joint[0] - 0.1, dy = joint[1] - 0.2;
      scene.balls[0].velocity = {dx - aside * dy, dy + aside * dx};
      const Result r = run(scene, 100);
      EXPECT_EQ(r.log.size(), 100u) << joint[0] << ' ' << joint[1] << ' ' << aside;
      for (const Collision& c : r.log)
        for (std::size_t k = 0; k < 2; ++k)
          EXPECT_LE(std::abs(c.ball.position[k] + 3.0 * static_cast<double>(c.ball.image[k])), 1 + 1e-12);
    }
}

TEST(CurvedWalls, refuse_a_start_on_their_wrong_side) {
  Scene scene = with_walls({ellipse(2.0, 1.0)}, 0.0);
  scene.balls[0].position = {1.9, 0.9};
  EXPECT_THROW(Simulation{scene}, InputError);
  scene = with_walls({curve({1.0, 1.0})}, 0.25);
  scene.balls[0].position = {1.8, 0.1};
  EXPECT_THROW(Simulation{scene}, InputError) << "it reaches across";
  scene = with_walls(rounded_square(), 0.25);
  scene.balls[0].position = {0.8, 0.8};
  EXPECT_THROW(Simulation{scene}, InputError) << "an arc";
}

}  // namespace
}  // namespace carom
