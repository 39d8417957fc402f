// Row 4: the break of a rack whose balls touch. The gaps are 0 as asked, no spacing is invented. Under the sequential rule
// simultaneous impacts are taken one after the other in the order of the balls' numbers, and counted as ties. That the
// audits stay clean is in tests/sim/contact_test.cpp (Rack); here: what the rule does, and what it is not.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

TEST(RackedBreak, keeps_energy_and_momentum_and_counts_its_ties) {
  Scene scene = rack_and_cue();
  scene.space = SpaceSpec{};
  const Result result = watched_run(scene, {.until = 100.0});
  const Result later = watched_run(scene, {.until = 1e9});
  EXPECT_EQ(later.stop, Stop::no_events_left) << "in open space the balls fly apart";
  EXPECT_EQ(later.log.size(), result.log.size());
  EXPECT_GT(result.summary.events.ties, 10);
  EXPECT_LE(result.summary.momentum.relative_error.value(), 1e-15);
  EXPECT_LE(result.summary.angular_momentum.relative_error.value(), 1e-13);
  EXPECT_EQ(result.log[0].time, 5.0 / 3.0) << "the cue ball has 5 to go";
}

// The break is the same whatever runs it: the rule is part of the order of events, not of the search or the queue.
TEST(RackedBreak, follows_one_rule) {
  const Scene scene = rack_and_cue(1e-9);
  const Result one = run(scene, 400);
  std::vector<Collision> log;
  Simulation other = Simulation::reference(scene);
  other.advance(std::nullopt, 400, [&](const Collision& c) { log.push_back(c); });
  EXPECT_EQ(difference(one.log, log), "");
}

// A straight break of a mirror-symmetric rack: one impact after the other favours a side, by design and counted. With any
// gap at all, however small, each hit has its own moment and order.
TEST(RackedBreak, with_gaps_has_few_ties) {
  for (const double gap : {1e-9, 1e-6}) {
    Scene scene = rack_and_cue(0.01);
    scene.lattices[0].gap = gap;
    scene.space = SpaceSpec{};
    const Result result = watched_run(scene, {.until = 100.0});
    EXPECT_EQ(result.summary.events.ties, 0) << gap;
    EXPECT_GE(result.log.size(), 14u);
  }
}

}  // namespace
}  // namespace carom
