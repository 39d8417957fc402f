// Openings: a ball whose centre comes to one leaves, there and then, and nothing else does.

#include <cmath>

#include "hard_cases/watched_run.hpp"

namespace carom {
namespace {

using namespace testing;

WallSpec opened(WallSpec wall) {
  wall.opening = true;
  return wall;
}

/// A room of 4 by 2 whose right side has a gap from y = 0.5 to y = 1.5.
Scene room() {
  Scene scene = open_space(2);
  scene.walls = {segment({4.0, 0.5}, {4.0, 0.0}), segment({4.0, 0.0}, {0.0, 0.0}), segment({0.0, 0.0}, {0.0, 2.0}),
                 segment({0.0, 2.0}, {4.0, 2.0}), segment({4.0, 2.0}, {4.0, 1.5}),
                 opened(segment({4.0, 1.5}, {4.0, 0.5}))};
  return scene;
}

TEST(Opening, a_ball_leaves_where_its_centre_comes_to_it) {
  Scene scene = room();
  scene.balls = {ball({1.0, 1.0}, {2.0, 0.125}, 0.25), ball({1.0, 1.5}, {0.0, 0.0}, 0.1, 3.0)};
  scene.run.until = 10.0;
  Simulation simulation(scene);
  std::vector<MotionChange> told;
  simulation.watch_motion([&](const MotionChange& m) { told.push_back(m); });
  EXPECT_EQ(simulation.run(), Stop::no_events_left);
  const std::vector<Departure> left = simulation.departures();
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].ball, 0u);
  EXPECT_EQ(left[0].wall, 5u);
  EXPECT_EQ(left[0].time, 1.5);
  EXPECT_EQ(left[0].position[0], 4.0);
  EXPECT_EQ(left[0].position[1], 1.1875);
  EXPECT_EQ(left[0].velocity[0], 2.0);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_FALSE(told[0].alive);
  EXPECT_EQ(told[0].time, 1.5);
  const Summary s = simulation.summary();
  EXPECT_EQ(s.events.other, 1);
  EXPECT_EQ(s.events.collisions(), 0);
  EXPECT_EQ(simulation.balls().size(), 1u);
  // It takes its energy along: 1/2 (2^2 + 0.125^2), booked as injected below 0.
  EXPECT_EQ(s.energy.injected.value, -2.0078125);
  EXPECT_EQ(s.energy.relative_error.value, 0.0);
}

// It is the walls beside a gap that stop a ball, not the gap: one that is wider hits their ends.
TEST(Opening, does_not_let_through_what_is_too_wide) {
  Scene scene = room();
  scene.balls = {ball({2.0, 1.0}, {1.0, 0.0}, 0.6)};
  // The ends, at distance 0.5 from the axis, are met sqrt(0.36 - 0.25) before the gap; both at once: straight back.
  const Result result = watched_run(scene, {.events = 2});
  EXPECT_NEAR(result.log[0].time, 2.0 - std::sqrt(0.11), 1e-15);
  EXPECT_TRUE(Simulation(scene).departures().empty());
  scene.balls[0].radius = 0.4;
  scene.run.until = 10.0;
  EXPECT_EQ(run_until(scene, 10.0).balls.size(), 0u);
}

// Accelerated: from rest at 4 - x = 1/2 under a = 1 to the gap in a time 1; its potential leaves with it.
TEST(Opening, a_falling_ball_leaves_too) {
  Scene scene = room();
  scene.motion.acceleration = {1.0, 0.0};
  scene.balls = {ball({3.5, 1.0}, {0.0, 0.0}, 0.125)};
  scene.run.until = 5.0;
  Simulation simulation(scene);
  simulation.run();
  ASSERT_EQ(simulation.departures().size(), 1u);
  EXPECT_EQ(simulation.departures()[0].time, 1.0);
  EXPECT_EQ(simulation.departures()[0].velocity[0], 1.0);
  EXPECT_EQ(simulation.summary().energy.relative_error.value, 0.0);
}

// Aimed at the joint of a wall and an opening, or beside it: the point leaves or comes back, and is never lost outside.
TEST(Opening, a_joint_leaves_no_third_way) {
  int out = 0, back = 0;
  for (const double offset : {0.0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-8, -1e-8})
    for (const double y : {0.25, 0.4, 0.6, 1.1, 1.7})
      for (const double end : {0.5, 1.5}) {
        Scene scene = room();
        scene.balls = {ball({1.0, y}, {3.0, end - y + offset}, 0.0)};
        Simulation simulation(scene);
        simulation.advance(Number(60.0), std::nullopt);
        const bool left = simulation.departures().size() == 1;
        (left ? out : back) += 1;
        for (const BallState& b : simulation.balls()) {
          EXPECT_TRUE(b.position[0] >= 0 && b.position[0] <= 4 && b.position[1] >= 0 && b.position[1] <= 2);
        }
      }
  EXPECT_EQ(out + back, 70);
  EXPECT_GT(out, 0);
}

// A gas of disks runs out through the gap: each is inside or has left once, whoever searches; a checkpoint keeps who left.
TEST(Opening, a_gas_runs_out) {
  Scene scene = room();
  Dice dice(3);
  for (int k = 0; k < 18; ++k) {
    const double vx = dice.between(-1.0, 1.0), vy = dice.between(-1.0, 1.0);
    scene.balls.push_back(ball({0.4 + 0.6 * (k % 6), 0.4 + 0.6 * (k / 6)}, {vx, vy}, 0.125));
  }
  const Result base = watched_run(scene, {.until = 30.0, .stride = 20, .energy_error = 1e-14});
  Simulation simulation(scene);
  simulation.advance(Number(4.0), std::nullopt);
  const std::size_t before = simulation.departures().size();
  const std::string state = simulation.state();
  simulation = Simulation(scene);
  simulation.restore(state);
  EXPECT_EQ(simulation.departures().size(), before);
  simulation.advance(Number(30.0), std::nullopt);
  EXPECT_GT(before, 0u);
  EXPECT_EQ(simulation.departures().size() + simulation.balls().size(), 18u);
  EXPECT_EQ(simulation.counts().other, static_cast<std::int64_t>(simulation.departures().size()));
  EXPECT_EQ(simulation.counts().collisions(), base.summary.events.collisions());
  for (const SearchKind search : {SearchKind::all_pairs, SearchKind::cells}) {
    scene.engine.search = search;
    EXPECT_EQ(difference(base.log, run_until(scene, 30.0).log), "");
  }
}

// A circle that lets out from inside, an absorbing disk from outside, in a periodic space in any period.
TEST(Opening, may_be_a_circle) {
  Scene scene = open_space(2);
  scene.walls = {opened(circle({0.0, 0.0}, 2.0, WallSide::inside))};
  scene.balls = {ball({0.5, 0.0}, {3.0, 0.0}, 0.25)};
  Simulation out(scene);
  out.advance(Number(1.0), std::nullopt);
  EXPECT_EQ(out.departures().at(0).time, 0.5);

  scene.space.kind = SpaceKind::periodic;
  scene.space.lower = {0.0, 0.0};
  scene.space.upper = {4.0, 4.0};
  scene.walls = {opened(circle({0.0, 0.0}, 1.0, WallSide::outside))};
  scene.balls = {ball({2.0, 2.0}, {1.0, 0.25}, 0.25)};  // 2 + 2 k / 8 = 4: at x = 10, beside (8, 4) and (12, 4)
  Simulation absorbed(scene);
  absorbed.advance(Number(20.0), std::nullopt);
  ASSERT_EQ(absorbed.departures().size(), 1u);
  const Departure d = absorbed.departures()[0];
  const double dx = d.position[0] - 4 * std::round(d.position[0] / 4), dy = d.position[1] - 4 * std::round(d.position[1] / 4);
  EXPECT_NEAR(std::hypot(dx, dy), 1.0, 1e-14);
  EXPECT_NEAR(d.position[1] - 2.0, (d.position[0] - 2.0) / 4, 1e-14);
}

TEST(Opening, is_refused_where_balls_do_not_leave_alone) {
  Scene scene = room();
  scene.balls = {ball({1.0, 1.0}, {2.0, 0.1}, 0.25)};
  scene.collision.law = LawKind::stick;
  EXPECT_EQ(refusals(scene).size(), 1u);
}

}  // namespace
}  // namespace carom
