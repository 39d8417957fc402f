// When a run ends, and where it then stands.

#include <gtest/gtest.h>

#include <atomic>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

TEST(Stopping, until_includes_the_events_at_it) {
  Scene scene = open_space(1);
  scene.balls = {ball({0.0}, {1.0}), ball({3.0}, {0.0})};  // they meet at t = 2, exactly
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance(Number(1.9999)), Stop::until);
  EXPECT_EQ(simulation.counts().ball_ball, 0);
  EXPECT_EQ(simulation.advance(Number(2.0)), Stop::no_events_left);
  EXPECT_EQ(simulation.counts().ball_ball, 1);
  EXPECT_EQ(simulation.time(), 2.0);
  EXPECT_EQ(simulation.advance(Number(5.0)), Stop::no_events_left);
  EXPECT_EQ(simulation.time(), 5.0) << "no events left: the time is that of until";
  EXPECT_EQ(simulation.ball(1).position[0], 6.0);
}

TEST(Stopping, without_until_the_time_is_that_of_the_last_event) {
  Scene scene = open_space(1);
  scene.balls = {ball({0.0}, {1.0}), ball({3.0}, {0.0})};
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance(std::nullopt), Stop::no_events_left);
  EXPECT_EQ(simulation.time(), 2.0);
  Scene idle = open_space(3);
  idle.balls = {ball({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0})};
  Simulation alone(idle);
  EXPECT_EQ(alone.advance(std::nullopt), Stop::no_events_left);
  EXPECT_EQ(alone.time(), 0.0);
  EXPECT_EQ(alone.advance(Number(1e9)), Stop::no_events_left);
  EXPECT_EQ(alone.ball(0).position[0], 1e9);
}

TEST(Stopping, events_are_exactly_as_many_as_asked_inside_a_tie_too) {
  Scene scene = box({0.0, 0.0}, {10.0, 10.0});  // into the corner: two walls at one instant
  scene.balls = {ball({5.0, 5.0}, {1.0, 1.0})};
  Simulation simulation(scene);
  for (int i = 1; i <= 10; ++i) {
    EXPECT_EQ(simulation.advance(std::nullopt, 1), Stop::events);
    EXPECT_EQ(simulation.counts().ball_wall, i);
  }
  EXPECT_EQ(simulation.advance(std::nullopt, 0), Stop::events);
  EXPECT_EQ(simulation.counts().ball_wall, 10);
}

TEST(Stopping, the_scene_says_how_long) {
  Scene scene = mixed_box(2, 5, 10.0, 3);
  scene.run.events = 137;
  Simulation by_events(scene);
  EXPECT_EQ(by_events.run(), Stop::events);
  EXPECT_EQ(by_events.summary().events.collisions(), 137);
  EXPECT_EQ(by_events.summary().stopped_by, Stop::events);
  scene.run.until = by_events.time() / 2;
  Simulation by_both(scene);
  EXPECT_EQ(by_both.run(), Stop::until);
  EXPECT_EQ(by_both.time(), by_events.time() / 2);
}

TEST(Stopping, interrupted_and_taken_up_again) {
  const Scene scene = mixed_box(2, 9, 10.0, 4);
  const Result whole = run(scene, 300);
  std::atomic<bool> interrupt{false};
  std::vector<Collision> log;
  Simulation simulation(scene);
  const auto sink = [&](const Collision& c) {
    log.push_back(c);
    if (log.size() % 100 == 0) interrupt = true;
  };
  int interruptions = 0;
  while (simulation.advance(std::nullopt, 300 - std::int64_t(log.size()), sink, &interrupt) == Stop::interrupted) {
    ++interruptions;
    interrupt = false;
  }
  EXPECT_EQ(interruptions, 2);
  EXPECT_EQ(difference(whole.log, log), "");
}

TEST(Stopping, the_past_is_not_reached) {
  const Scene scene = mixed_box(2, 5, 10.0, 3);
  Simulation simulation(scene);
  simulation.advance(Number(5.0));
  const double x = simulation.ball(0).position[0];
  EXPECT_EQ(simulation.advance(Number(1.0)), Stop::until);
  EXPECT_EQ(simulation.time(), 5.0);
  EXPECT_EQ(simulation.ball(0).position[0], x);
}

// Two infinite masses that meet: nothing says what follows.
TEST(Stopping, two_infinite_masses) {
  Scene scene = open_space(2);
  const double inf = std::numeric_limits<double>::infinity();
  scene.balls = {ball({0.0, 0.0}, {1.0, 0.0}, 0.5, inf), ball({3.0, 0.0}, {-1.0, 0.0}, 0.5, inf)};
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance(Number(10.0)), Stop::collapse);
  const Summary s = simulation.summary();
  ASSERT_TRUE(s.stopped.has_value());
  EXPECT_EQ(s.stopped->balls, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(s.stopped->time, 1.0);
  EXPECT_FALSE(s.stopped->reason.empty());

  Scene at_wall = open_space(2);
  at_wall.walls = {plane({2.0, 0.0}, {-1.0, 0.0})};
  at_wall.balls = {ball({0.0, 0.0}, {1.0, 0.0}, 0.5, inf)};
  EXPECT_EQ(run_until(at_wall, 10.0).stop, Stop::collapse);
}

}  // namespace
}  // namespace carom
