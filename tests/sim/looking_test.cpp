// Looking never writes: sinks, samples, slices and summaries leave no trace in what follows; nor does the hour of the
// start.

#include <gtest/gtest.h>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

std::vector<double> final_bits(Simulation& simulation) {
  std::vector<double> all{simulation.time()};
  for (const BallState& b : simulation.balls()) {
    all.insert(all.end(), b.position.begin(), b.position.end());
    all.insert(all.end(), b.velocity.begin(), b.velocity.end());
  }
  return all;
}

std::vector<std::pair<const char*, Scene>> scenes() {
  Scene granular = mixed_box(2, 16, 12.0, 9);
  granular.collision.restitution = 0.95;
  return {{"disks", mixed_box(2, 20, 15.0, 10, 0.2, 20.0)},
          {"spheres", mixed_box(3, 12, 10.0, 11)},
          {"rods", rods(9, 12)},
          {"granular", granular},
          {"rack", rack_and_cue(0.05)}};
}

TEST(Looking, many_slices_and_all_questions_change_nothing) {
  const double until = 40.0;
  for (const auto& [name, scene] : scenes()) {
    Simulation blind(scene);
    ASSERT_EQ(blind.advance(Number(until)), Stop::until) << name;
    const std::vector<double> expected = final_bits(blind);
    const Summary expected_summary = blind.summary();

    std::vector<Collision> whole, sliced, counted;
    Simulation seen(scene);
    seen.advance(Number(until), std::nullopt, [&](const Collision& c) { whole.push_back(c); });
    EXPECT_EQ(final_bits(seen), expected) << name << ": a sink left a trace";

    Simulation slices(scene);
    const int parts = 997;
    for (int i = 1; i <= parts; ++i) {
      slices.advance(Number(i == parts ? until : until * i / parts), std::nullopt,
                     [&](const Collision& c) { sliced.push_back(c); });
      (void)slices.summary();
      (void)slices.balls();
      if (i % 50 == 0) (void)slices.audit(AuditBy::every_pair);
    }
    EXPECT_EQ(final_bits(slices), expected) << name << ": a slice left a trace";
    EXPECT_EQ(difference(whole, sliced), "") << name;

    Simulation steps(scene);  // one collision at a time, and the rest by time
    while (steps.advance(Number(until), 1, [&](const Collision& c) { counted.push_back(c); }) == Stop::events)
      (void)steps.ball(0);
    EXPECT_EQ(final_bits(steps), expected) << name << ": stopping after each collision left a trace";
    EXPECT_EQ(difference(whole, counted), "") << name;

    const Summary s = slices.summary();
    EXPECT_TRUE(same_bits(s.energy.final, expected_summary.energy.final));
    EXPECT_TRUE(same_bits(s.energy.dissipated, expected_summary.energy.dissipated));
    EXPECT_TRUE(same_bits(s.energy.relative_error, expected_summary.energy.relative_error));
    EXPECT_EQ(s.events.ball_ball, expected_summary.events.ball_ball);
    EXPECT_EQ(s.events.ties, expected_summary.events.ties);
    EXPECT_EQ(s.exactness.repredicted, expected_summary.exactness.repredicted);
  }
}

// The clock counts epochs: a start at 2^40 of them, or before 0, changes the epoch column and nothing else.
TEST(Looking, the_hour_of_the_start_does_not_matter) {
  for (auto& [name, scene] : scenes()) {
    const std::vector<Collision> log = run(scene, 500).log;
    const double L = Simulation(scene).epoch_length();
    for (const double epochs : {0x1p40, 12345.0, -0x1p40, -1.0, 0x1p52}) {
      Scene late = scene;
      late.run.start = epochs * L;
      const Result result = run(late, 500);
      EXPECT_EQ(difference(log, result.log, static_cast<std::int64_t>(epochs)), "")
          << name << ", start at epoch " << epochs;
    }
  }
}

// Half an epoch is no whole number of them: offsets are rounded anew, by a tick, and the physics follows within rounding.
TEST(Looking, any_other_start_changes_rounding_only) {
  const Scene scene = mixed_box(2, 5, 10.0, 13);
  Scene late = scene;
  late.run.start = 1e9 + 1.0 / 3.0;
  const std::vector<Collision> a = run(scene, 10).log, b = run(late, 10).log;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].ball.number, b[i].ball.number);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(a[i].ball.position[k], b[i].ball.position[k], 1e-10);
  }
}

}  // namespace
}  // namespace carom
