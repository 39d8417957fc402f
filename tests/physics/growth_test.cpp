// Balls that grow [LubachevskyStillinger1990]: when they meet, what an impact then gives, and what compression comes to.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "carom/core/error.hpp"
#include "carom/scene/read.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

BallSpec growing(BallSpec b, double rate) {
  b.radius_growth = rate;
  return b;
}

Coordinates along_x(int dimension, double x) {
  Coordinates c(static_cast<std::size_t>(dimension), 0.0);
  c[0] = x;
  return c;
}

// Radii 1/2, a gap of 2, each growing at 1/8: they meet at gap / (2 gamma) = 8, and the surfaces part as they came, at 1/4.
// So the centres part at 1/2, each at 1/4: energy 2 (1/4)^2 / 2 = 1/16, which the impulse of 1/4 brought in at 1/4.
TEST(GrowingPair, at_rest_meets_when_growth_has_closed_the_gap) {
  for (const int d : {1, 2, 3}) {
    Scene scene = open_space(d);
    scene.balls = {growing(ball(along_x(d, 0.0), along_x(d, 0.0)), 0.125),
                   growing(ball(along_x(d, 3.0), along_x(d, 0.0)), 0.125)};
    const Result result = run(scene, 5);
    ASSERT_EQ(result.log.size(), 1u) << "they part at more than they grow";
    EXPECT_EQ(result.log[0].time, 8.0);
    EXPECT_EQ(result.log[0].impulse, 0.25);
    EXPECT_EQ(result.log[0].injected, 0.0625);
    EXPECT_EQ(result.log[0].dissipated, 0.0);
    EXPECT_EQ(result.log[0].ball.velocity_after[0], -0.25);
    EXPECT_EQ(result.log[0].partner.velocity_after[0], 0.25);
    EXPECT_EQ(result.log[0].point[0], 1.5);
    EXPECT_EQ(result.summary.energy.final, 0.0625);
    EXPECT_EQ(result.summary.energy.relative_error, 0.0);
    EXPECT_EQ(result.balls[0].radius, 1.5);
  }
}

// e = 1/2: the surfaces part at G / 2, the centres at 3 G / 2; lost: mu (1 - e^2) G^2 / 2.
TEST(GrowingPair, restitution_is_of_the_speed_of_the_surfaces) {
  Scene scene = open_space(2);
  scene.collision.restitution = 0.5;
  scene.balls = {growing(ball({0.0, 0.0}, {0.0, 0.0}), 0.125), growing(ball({3.0, 0.0}, {0.0, 0.0}), 0.125)};
  const Result result = run(scene, 1);
  EXPECT_EQ(result.log[0].partner.velocity_after[0], 3.0 / 16);
  EXPECT_EQ(result.log[0].dissipated, 3.0 / 256);
  EXPECT_EQ(result.log[0].injected, 3.0 / 64);
  EXPECT_EQ(result.summary.energy.final, 9.0 / 256);
}

// A gap of 2 that opens at 1/10 and is closed at 2/10: after 20.
TEST(GrowingPair, that_recedes_meets_if_it_grows_faster) {
  Scene scene = open_space(3);
  scene.balls = {growing(ball({0.0, 0.0, 0.0}, {-0.05, 0.0, 0.0}), 0.1),
                 growing(ball({3.0, 0.0, 0.0}, {0.05, 0.0, 0.0}), 0.1)};
  EXPECT_NEAR(run(scene, 1).log.at(0).time, 20.0, 1e-13);
  scene.balls[0].radius_growth = scene.balls[1].radius_growth = 0.05;
  EXPECT_TRUE(run(scene, 1).log.empty()) << "the gap stays as it is";
}

TEST(GrowingPair, in_contact_at_the_start_parts_at_once) {
  Scene scene = open_space(2);
  scene.balls = {growing(ball({0.0, 0.0}, {0.0, 0.0}), 0.1), growing(ball({1.0, 0.0}, {0.0, 0.0}), 0.1)};
  const Result result = run(scene, 5);
  ASSERT_EQ(result.log.size(), 1u);
  EXPECT_EQ(result.log[0].time, 0.0);
  EXPECT_NEAR(result.log[0].impulse, 0.2, 1e-16);
}

// At rest at a distance of 3/2 of the surface, growing at 1/8: after 12 it touches, and leaves at 2 gamma.
TEST(GrowingBall, meets_every_wall) {
  struct Case {
    WallSpec wall;
    Coordinates at, after;
  };
  WallSpec segment;
  segment.kind = WallKind::segment;
  segment.from = {-1.0, 0.0};
  segment.to = {1.0, 0.0};
  const std::vector<Case> cases = {{plane({0.0, 0.0}, {0.0, 2.0}), {7.0, 2.0}, {0.0, 0.25}},
                                   {segment, {0.5, 2.0}, {0.0, 0.25}},
                                   {segment, {0.5, -2.0}, {0.0, -0.25}},
                                   {segment, {3.0, 0.0}, {0.25, 0.0}},
                                   {circle({0.0, 0.0}, 3.0, WallSide::inside), {1.0, 0.0}, {-0.25, 0.0}},
                                   {circle({0.0, 0.0}, 3.0, WallSide::outside), {0.0, 5.0}, {0.0, 0.25}}};
  for (const Case& c : cases) {
    Scene scene = open_space(2);
    scene.walls = {c.wall};
    scene.balls = {growing(ball(c.at, {0.0, 0.0}), 0.125)};
    const Result result = run(scene, 1);
    ASSERT_EQ(result.log.size(), 1u);
    EXPECT_NEAR(result.log[0].time, 12.0, 1e-14);
    EXPECT_NEAR(result.log[0].ball.velocity_after[0], c.after[0], 1e-16);
    EXPECT_NEAR(result.log[0].ball.velocity_after[1], c.after[1], 1e-16);
    EXPECT_NEAR(result.summary.energy.final, 0.03125, 1e-16);
    EXPECT_LE(result.summary.energy.relative_error, 1e-15);
  }
}

// Between two walls the room 1 - 2 gamma t shrinks; the speed gains 2 gamma at each wall. Like a piston that is slow
// against the ball, v (1 - 2 gamma t) stays; from v = 1 to v = 4 the adiabatic law is good to gamma / v.
TEST(GrowingBall, in_a_shrinking_room_keeps_its_action) {
  Scene scene = box({0.0}, {2.0});
  scene.balls = {growing(ball({1.0}, {1.0}, 0.5), 1e-4)};
  const Result result = run_until(scene, 3750.0);  // radius 0.875: a quarter of the room is left
  EXPECT_NEAR(std::fabs(result.balls[0].velocity[0]), 4.0, 4 * 2e-3);
  EXPECT_LE(result.summary.energy.relative_error, 1e-13);
}

TEST(GrowingBall, ends_the_run_where_it_fills_its_space) {
  Scene scene;
  scene.dimension = 2;
  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {0.0, 0.0};
  scene.space.upper = {3.0, 2.0};
  scene.run.until = 100.0;
  scene.balls = {growing(ball({1.0, 1.0}, {0.3, 0.2}), 0.125)};
  Simulation simulation(scene);
  EXPECT_EQ(simulation.run(), Stop::collapse);  // it would touch its own image: 1/2 + t / 8 = 1
  EXPECT_EQ(simulation.time(), 4.0);
  EXPECT_EQ(simulation.summary().stopped->balls, std::vector<std::uint32_t>{0});
}

TEST(Compression, ends_at_the_packing_asked_for) {
  const Scene scene = read_scene(
      "dimension=2\n[[gas]]\ncount=100\npacking_fraction=0.3\nradius=0.5\nradius_growth=0.01\nseed=4\n"
      "[run]\nuntil_packing=0.80\nrescale_every=1000\n",
      "test");
  Simulation simulation(scene);
  std::int64_t overlaps = 0;
  while (simulation.advance(std::nullopt, 50) == Stop::events) overlaps += simulation.audit(AuditBy::every_pair).overlaps;
  const Summary summary = simulation.summary();
  EXPECT_EQ(summary.stopped_by, Stop::packing);
  EXPECT_EQ(overlaps, 0);
  EXPECT_NEAR(*summary.growth->packing_fraction, 0.80, 1e-14);
  // 100 pi r^2 / L^2 with pi / 4 100 / L^2 = 0.3: r = sqrt(0.8 / 0.3) / 2.
  EXPECT_NEAR(simulation.ball(7).radius, std::sqrt(0.8 / 0.3) / 2, 1e-14);
  EXPECT_NEAR(summary.time, (std::sqrt(0.8 / 0.3) / 2 - 0.5) / 0.01, 1e-11);
  EXPECT_LE(summary.energy.relative_error, 1e-12);
  EXPECT_EQ(summary.exactness.clamped, 0);
  EXPECT_GT(summary.events.other, 0) << "rescalings";
  EXPECT_LT(summary.energy.final / summary.energy.initial, 1.5);
  EXPECT_EQ(simulation.advance(std::nullopt, 10), Stop::packing) << "it stays there";
}

// The packing of a mixture: sum of pi (r + gamma t)^2.
TEST(Compression, keeps_the_ratio_of_sizes) {
  const Scene scene = read_scene(
      "dimension=2\n[space]\nkind='periodic'\nlower=[0,0]\nupper=[20,20]\n[[gas]]\ncount=40\nradius=0.7\n"
      "radius_growth=0.014\n[[gas]]\ncount=80\nradius=0.5\nradius_growth=0.01\n[run]\nuntil_packing=0.6\n",
      "test");
  Simulation simulation(scene);
  EXPECT_EQ(simulation.run(), Stop::packing);
  EXPECT_NEAR(simulation.ball(0).radius / simulation.ball(119).radius, 1.4, 1e-15);
  double filled = 0;
  for (const BallState& b : simulation.balls()) filled += std::numbers::pi * b.radius * b.radius / 400;
  EXPECT_NEAR(filled, 0.6, 1e-14);
}

// Slow growth is a sequence of equilibria: hard disks at 0.6 have Z = 5.3 or so; Henderson's (1 + eta^2 / 8) / (1 - eta)^2
// gives 6.53 at 0.6 and 4.0 at 0.49; what is measured is over a block before the end, and heats nothing.
TEST(Compression, passes_through_the_equation_of_state) {
  const Scene scene = read_scene(
      "dimension=2\n[[gas]]\ncount=400\npacking_fraction=0.55\nradius=0.5\nradius_growth=0.0002\nseed=2\n"
      "[run]\nuntil_packing=0.6\nrescale_every=20000\n",
      "test");
  Simulation simulation(scene);
  ASSERT_EQ(simulation.run(), Stop::packing);
  const double eta = 0.6, henderson = (1 + eta * eta / 8) / ((1 - eta) * (1 - eta));
  EXPECT_NEAR(*simulation.summary().growth->reduced_pressure, henderson, 0.1 * henderson);
}

// Fast compression of spheres jams at random close packing, 0.634 to 0.64 [Baranau2014]: here the radius grows at 0.03 of
// the thermal speed, and 2000 balls are a little off.
TEST(Compression, of_spheres_jams_at_random_close_packing) {
  const Scene scene = read_scene(
      "dimension=3\n[[gas]]\ncount=2000\npacking_fraction=0.3\nradius=0.5\nradius_growth=0.03\nseed=1\n"
      "[run]\nuntil_reduced_pressure=1e4\nrescale_every=10000\n",
      "test");
  Simulation simulation(scene);
  EXPECT_EQ(simulation.run(), Stop::pressure);
  const Summary summary = simulation.summary();
  EXPECT_GE(*summary.growth->reduced_pressure, 1e4);
  EXPECT_NEAR(*summary.growth->packing_fraction, 0.637, 0.01);
  EXPECT_EQ(simulation.audit().overlaps, 0);
  EXPECT_EQ(summary.exactness.clamped, 0);
  EXPECT_LE(summary.energy.relative_error, 1e-11);
}

TEST(Compression, that_cannot_be_is_refused) {
  const auto refused = [](const char* text) { EXPECT_THROW(Simulation(read_scene(text, "test")), InputError) << text; };
  const std::string gas = "dimension=2\n[[gas]]\ncount=20\npacking_fraction=0.3\nradius=0.5\nradius_growth=0.1\n";
  refused((gas + "[run]\nuntil_packing=0.2\n").c_str());
  refused((gas + "temperature=0\n[run]\nevents=100\nrescale_every=10\n").c_str());
  refused("dimension=2\n[[ball]]\nposition=[0,0]\nradius_growth=0.1\n[run]\nuntil_packing=0.5\n");
}

}  // namespace
}  // namespace carom
