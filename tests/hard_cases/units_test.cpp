// Row 16: a table of any size, in any units. Powers of two as units of length, time and mass round nothing, so the log of a
// scene scaled by 2^k is the log, scaled, bit for bit. (tests/sim/symmetry_test.cpp takes random boxes to 2^100; here all
// kinds of walls, gravity and restitution, to 2^300.) Other factors round the inputs, and the first hits agree to rounding.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

/// Everything at once: gravity, dissipation, planes, segments, a polygon, pillars, fixed and infinite balls, points.
Scene menagerie() {
  Scene scene = box({-8.0, -6.0}, {8.0, 6.0});
  scene.motion.acceleration = {0.125, -0.75};
  scene.space.restitution = 1.0;
  scene.collision.restitution = 0.99;
  scene.walls = {segment({-6.0, -4.5}, {-3.0, -3.0}), polygon({{3.0, 1.0}, {5.5, 1.5}, {4.0, 3.5}}),
                 circle({0.0, 4.0}, 0.75, WallSide::outside), plane({-7.5, 0.0}, {1.0, 0.125})};
  for (WallSpec& w : scene.walls) w.restitution = 1.0;
  Dice dice(161);
  for (int i = 0; i < 5; ++i) {
    const double vx = dice.between(-1.0, 1.0), vy = dice.between(-1.0, 1.0), radius = i == 4 ? 0.0 : dice.between(0.1, 0.4);
    const double mass = dice.between(0.5, 4.0);
    scene.balls.push_back(ball({-2.5 + i, 0.3 * i - 0.5}, {vx, vy}, radius, mass));
  }
  scene.balls.push_back(fixed_ball({0.0, -3.0}, 0.625));
  return scene;
}

struct Factors {
  double length = 1.0, time = 1.0, mass = 1.0;
  [[nodiscard]] double speed() const { return length / time; }
};

Scene in_units(Scene scene, const Factors& f) {
  const auto stretch = [](Coordinates& c, double by) {
    for (Number& x : c) x = x * by;
  };
  for (BallSpec& b : scene.balls) {
    stretch(b.position, f.length);
    stretch(b.velocity, f.speed());
    b.radius = b.radius * f.length;
    b.mass = b.mass * f.mass;
  }
  for (WallSpec& w : scene.walls) {
    for (Coordinates* c : {&w.from, &w.to, &w.point, &w.centre}) stretch(*c, f.length);
    for (Coordinates& c : w.vertices) stretch(c, f.length);
    stretch(w.velocity, f.speed());
    w.radius = w.radius * f.length;
  }
  stretch(scene.space.lower, f.length);
  stretch(scene.space.upper, f.length);
  stretch(scene.motion.acceleration, f.speed() / f.time);
  return scene;
}

Collision in_units(Collision c, const Factors& f) {
  c.offset *= f.time;
  for (Collision::Party* p : {&c.ball, &c.partner}) {
    for (double& x : p->position) x *= f.length;
    for (double& v : p->velocity_before) v *= f.speed();
    for (double& v : p->velocity_after) v *= f.speed();
  }
  c.impulse *= f.mass * f.speed();
  c.gap *= f.length;
  c.dissipated *= f.mass * f.speed() * f.speed();
  c.injected *= f.mass * f.speed() * f.speed();
  return c;
}

TEST(Units, of_any_power_of_two_give_the_scaled_log) {
  const Result one = watched_run(menagerie(), {.events = 500, .stride = 10, .energy_error = 1e-13});
  ASSERT_EQ(one.log.size(), 500u);
  std::vector<Factors> all;
  for (int k = -300; k <= 300; k += 50) {
    const double two_to_k = std::ldexp(1.0, k);
    all.push_back({two_to_k, 1.0, 1.0});
    all.push_back({1.0, two_to_k, 1.0});
    all.push_back({1.0, 1.0, two_to_k});
    all.push_back({two_to_k, two_to_k, 1.0});
  }
  for (const Factors& f : all) {
    const Result other = watched_run(in_units(menagerie(), f), {.events = 500, .stride = 50, .energy_error = 1e-13});
    std::vector<Collision> expected;
    for (const Collision& c : one.log) expected.push_back(in_units(c, f));
    ASSERT_EQ(difference(expected, other.log), "") << "length " << f.length << " time " << f.time << " mass " << f.mass;
    EXPECT_TRUE(same_bits(one.summary.energy.relative_error, other.summary.energy.relative_error));
    EXPECT_EQ(one.summary.events.ties, other.summary.events.ties);
  }
}

// A table of atoms, in metres, and of galaxies: the first hits are the same ones.
TEST(Units, of_any_other_size_give_the_same_first_hits) {
  const Result one = run(menagerie(), 12);
  for (const double length : {5.29177e-11, 1e-3, 299792458.0, 3.0857e22}) {
    const Result other = watched_run(in_units(menagerie(), {length, 3.0, 1.0}), {.events = 12});
    ASSERT_EQ(other.log.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_EQ(one.log[i].ball.number, other.log[i].ball.number);
      EXPECT_EQ(one.log[i].partner.number, other.log[i].partner.number);
      EXPECT_NEAR(other.log[i].time / 3.0 / one.log[i].time, 1.0, 1e-9);
    }
  }
}

// Large tables with small balls: a circle 1e8 and a box 1e12 times as large as the ball. Hits stay on the wall to the
// rounding of its coordinates, and what a circle conserves is conserved.
TEST(Units, of_a_table_much_larger_than_its_balls) {
  for (const double size : {1e2, 1e5, 1e8, 1e12}) {
    Scene scene = open_space(2);
    scene.walls = {circle({0.0, 0.0}, size, WallSide::inside)};
    scene.balls = {ball({0.25 * size, 0.0}, {0.6 * size, 0.8 * size}, 1.0)};
    const Result result = watched_run(scene, {.events = 400, .stride = 10, .energy_error = 1e-14});
    ASSERT_EQ(result.log.size(), 400u);
    EXPECT_LE(result.summary.exactness.max_gap_error, 2e-15 * size);
    const BallState& b = result.balls[0];
    const double spin = (b.position[0] * b.velocity[1] - b.position[1] * b.velocity[0]) / (size * size);
    EXPECT_NEAR(spin, 0.2, 1e-12) << size;
  }
}

}  // namespace
}  // namespace carom
