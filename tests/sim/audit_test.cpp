// The plain truth about overlaps, asked every few events.

#include "carom/sim/audit.hpp"

#include <gtest/gtest.h>

#include "carom/motion/free_flight.hpp"
#include "carom/world/build.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

void expect_no_overlap(const char* name, const Scene& scene, int audits, std::int64_t events) {
  Simulation simulation(scene);
  for (int i = 0; i < audits; ++i) {
    const Stop stop = simulation.advance(std::nullopt, events);
    const Audit truth = simulation.audit(AuditBy::every_pair);
    ASSERT_EQ(truth.overlaps, 0) << name << ": ball " << truth.ball << " and " << truth.partner << " by " << truth.deepest
                                 << " after " << simulation.counts().collisions();
    // Between events too, where the motion is only looked at.
    simulation.advance(Number(simulation.time() + 1e-3), 1);
    ASSERT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0) << name;
    ASSERT_EQ(simulation.audit(AuditBy::grid).overlaps, 0) << name;
    if (stop != Stop::events) break;
  }
  const Summary s = simulation.summary();
  EXPECT_EQ(s.exactness.clamped, 0) << name;
  EXPECT_LE(s.energy.relative_error, 1e-14) << name;
}

TEST(Audit, no_overlap_in_any_scene) {
  const int audits = static_cast<int>(scaled_count(300));
  expect_no_overlap("dense disks", mixed_box(2, 36, 12.0, 1, 0.9, 1.0), audits, 17);
  expect_no_overlap("disks of many sizes", mixed_box(2, 25, 12.0, 2, 0.02, 1000.0), audits, 17);
  expect_no_overlap("spheres", mixed_box(3, 27, 9.0, 3, 0.7), audits, 17);
  expect_no_overlap("rods", rods(15, 4), audits, 17);
  expect_no_overlap("rack", rack_and_cue(), audits, 3);
  for (const double e : {0.99, 0.9, 0.7}) {
    Scene scene = mixed_box(2, 16, 12.0, 5);
    scene.collision.restitution = e;
    expect_no_overlap("granular disks", scene, audits, 5);
  }
}

// A place near 0 that was reached from afar is rounded as coordinates afar are: that is no overlap.
TEST(Audit, rounding_is_that_of_the_whole_way) {
  Dice dice(6);
  for (int i = 0; i < 100; ++i) {
    Scene scene = box({0.0}, {8.0});
    const double x = dice.between(4.0, 7.9), v = dice.between(-2.0, -0.5);
    scene.balls = {ball({x}, {v}, 0.01)};
    Simulation simulation(scene);
    simulation.advance(std::nullopt, 1);
    ASSERT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0) << "from " << x << " at " << v;
  }
}

// The audit itself can see: the same balls, moved on without their collisions, overlap each other and the walls.
TEST(Audit, finds_what_an_engine_would_have_missed) {
  Scene scene = box({-10.0, -10.0}, {10.0, 10.0});
  scene.balls = {ball({-2.0, 0.0}, {1.0, 0.0}), ball({2.0, 0.0}, {-1.0, 0.0}), ball({0.0, 9.0}, {0.0, 1.0})};
  const World<double, 2> world = build<double, 2>(scene);
  const FreeFlight<double, 2> flight;
  const auto at = [&](double t) { return clock_time<double>(Number(t), world.units.time); };
  for (const AuditBy by : {AuditBy::every_pair, AuditBy::grid}) {
    EXPECT_EQ(audit(flight, world, at(0.25), by).overlaps, 0);
    EXPECT_EQ(audit(flight, world, at(0.75), by).overlaps, 1) << "the wall only";
    EXPECT_EQ(audit(flight, world, at(1.5 + 1e-12), by).overlaps, 2) << "by 2e-12 of two balls";
    const Audit deep = audit(flight, world, at(2.0), by);
    EXPECT_EQ(deep.overlaps, 2);
    EXPECT_TRUE(deep.with_wall);
    EXPECT_EQ(deep.ball, 2u);
    EXPECT_NEAR(std::ldexp(deep.deepest, world.units.length), 1.5, 1e-12);
  }
}

}  // namespace
}  // namespace carom
