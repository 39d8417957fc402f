// Row 18: the result must not depend on how often one looks. tests/sim/looking_test.cpp slices boxes of balls; here the
// states that are more than a position: sides and contacts of points at segments, bodies that stick, merged balls, moving
// walls, gravity, and runs that end in a collapse.

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

void expect_no_trace(const char* name, const Scene& scene, double until) {
  const Result blind = run_until(scene, until);
  ASSERT_GT(blind.log.size(), 10u) << name;
  Simulation simulation(scene);
  std::vector<Collision> seen;
  const auto sink = [&](const Collision& c) { seen.push_back(c); };
  Stop stop = Stop::until;
  for (int i = 1; i <= 499 && stop == Stop::until; ++i) {
    stop = simulation.advance(Number(i == 499 ? until : until * i / 499), std::nullopt, sink);
    EXPECT_EQ(simulation.audit(AuditBy::every_pair).overlaps, 0) << name;
    (void)simulation.summary();
    if (i % 20 == 0) simulation.restore(simulation.state());
    if (i % 7 == 0) simulation.return_to_last_event();
  }
  EXPECT_EQ(difference(blind.log, seen), "") << name;
  EXPECT_EQ(stop, blind.stop) << name;
  const Summary s = simulation.summary();
  EXPECT_TRUE(same_bits(s.energy.final, blind.summary.energy.final)) << name;
  EXPECT_TRUE(same_bits(s.energy.relative_error, blind.summary.energy.relative_error)) << name;
  EXPECT_EQ(s.events.ties, blind.summary.events.ties) << name;
  EXPECT_EQ(s.exactness.clamped, 0) << name;
}

TEST(LookingTwice, leaves_no_trace) {
  Scene points = open_space(2);
  points.walls = {polygon({{0.0, 0.0}, {2.0, 0.1}, {1.7, 1.9}, {1.0, 0.9}, {0.1, 1.5}})};
  points.balls = {ball({0.5, 0.3}, {0.3, 0.777}, 0.0), ball({0.6, 0.3}, {-0.4, 0.2}, 0.0)};
  expect_no_trace("points among segments", points, 200.0);

  Scene falling = open_space(2);
  falling.motion.acceleration = {0.0, -1.0};
  falling.walls = {segment({-1.0, 0.0}, {3.0, 0.5}), segment({3.0, 0.5}, {3.0, 9.0}), segment({-1.0, 9.0}, {-1.0, 0.0})};
  falling.balls = {ball({0.5, 2.0}, {0.3, 0.0}, 0.1), ball({1.5, 3.0}, {-0.1, 0.0}, 0.3, 2.0), fixed_ball({1.0, 1.0}, 0.2)};
  expect_no_trace("gravity", falling, 60.0);

  Scene piston = mixed_box(2, 9, 8.0, 181);
  piston.walls = {plane({0.0, 0.0}, {1.0, 0.0})};
  piston.walls[0].velocity = {-0.25, 0.0};
  expect_no_trace("a wall that draws back", piston, 20.0);

  for (const LawKind law : {LawKind::stick, LawKind::merge}) {
    Scene joining = mixed_box(2, 25, 16.0, 182);
    joining.space = SpaceSpec{};
    for (BallSpec& b : joining.balls)
      for (std::size_t k = 0; k < 2; ++k) b.velocity[k] = 0.3 * b.velocity[k] - 0.2 * (b.position[k] - 8.0);
    joining.collision.law = law;
    expect_no_trace(law == LawKind::stick ? "stick" : "merge", joining, 30.0);
  }

  Scene bouncing = open_space(2);
  bouncing.collision.restitution = 0.8;
  bouncing.motion.acceleration = {0.0, -1.0};
  bouncing.walls = {plane({0.0, 0.0}, {0.0, 1.0})};
  bouncing.balls = {ball({0.0, 2.0}, {0.1, 0.0})};
  expect_no_trace("a collapse", bouncing, 100.0);
}

}  // namespace
}  // namespace carom
