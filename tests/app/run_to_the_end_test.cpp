#include "run_to_the_end.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "write/scenes.hpp"

namespace carom::app {
namespace {

struct Seen {
  std::vector<double> frames, events;
  Stop stop = Stop::until;
  double time = 0.0;
};

Seen watch(const Scene& scene) {
  Simulation simulation(scene);
  Seen seen;
  Watchers watchers;
  watchers.frame = [&] { seen.frames.push_back(simulation.time()); };
  watchers.collision = [&](const Collision& c) { seen.events.push_back(c.time); };
  seen.stop = run_to_the_end(simulation, scene.run, watchers);
  seen.time = simulation.time();
  return seen;
}

TEST(RunToTheEnd, has_frames_at_start_samples_and_end) {
  Scene scene = test::head_on(2);
  scene.run.sample_every = 2.5;
  const Seen seen = watch(scene);
  EXPECT_THAT(seen.frames, testing::ElementsAre(0.0, 2.5, 5.0, 6.0));
  EXPECT_EQ(seen.stop, Stop::until);
}

TEST(RunToTheEnd, ends_where_an_unwatched_run_ends) {
  for (const bool open : {false, true})
    for (const bool until : {false, true})
      for (const std::int64_t events : {0, 1, 2, 3, 700}) {
        Scene scene = test::head_on(2);
        if (open) scene.space = {};
        if (!until) scene.run.until.reset();
        scene.run.events = events;
        Simulation alone(scene);
        const Stop stop = alone.run();
        for (const char* every : {"0.3", "100"}) {
          scene.run.sample_every = parse_number(every);
          const Seen seen = watch(scene);
          EXPECT_EQ(seen.stop, stop);
          EXPECT_EQ(seen.time, alone.time()) << open << until << events << every;
          EXPECT_EQ(static_cast<std::int64_t>(seen.events.size()), alone.counts().collisions());
        }
      }
}

// Looks fall on frames, between them, and beyond the end.
TEST(RunToTheEnd, ends_where_an_unwatched_run_ends_with_looks_too) {
  for (const bool open : {false, true})
    for (const bool until : {false, true})
      for (const std::int64_t events : {0, 1, 2, 3, 700})
        for (const char* every : {"0.3", "0.7", "100"}) {
          Scene scene = test::head_on(2);
          if (open) scene.space = {};
          if (!until) scene.run.until.reset();
          scene.run.events = events;
          Simulation alone(scene);
          const Stop stop = alone.run();
          scene.run.sample_every = parse_number("0.6");
          scene.observe.mean_squared_displacement.emplace().every = parse_number(every);
          scene.observe.after_events = events % 3;
          Simulation simulation(scene);
          Samplers samplers(scene, simulation);
          std::vector<double> frames;
          Watchers watchers;
          watchers.frame = [&] { frames.push_back(simulation.time()); };
          watchers.samplers = &samplers;
          EXPECT_EQ(run_to_the_end(simulation, scene.run, watchers), stop);
          EXPECT_EQ(simulation.time(), alone.time()) << open << until << events << every;
          EXPECT_EQ(simulation.counts().collisions(), alone.counts().collisions());
          scene.observe = {};
          EXPECT_EQ(frames, watch(scene).frames);
        }
}

// Two balls in the open: after their impact at t = 1 nothing happens any more.
TEST(RunToTheEnd, without_until_ends_at_the_last_event) {
  Scene scene = test::head_on(2);
  scene.space = {};
  scene.run.until.reset();
  scene.run.events = 10;
  scene.run.sample_every = 0.75;
  const Seen seen = watch(scene);
  EXPECT_EQ(seen.stop, Stop::no_events_left);
  EXPECT_EQ(seen.time, 1.0);
}

TEST(RunToTheEnd, does_the_rest_of_a_run) {
  Scene scene = test::head_on(2);
  scene.run.sample_every = 1.0;
  Simulation simulation(scene);
  simulation.advance(Number(2.5));
  std::vector<double> frames;
  Watchers watchers;
  watchers.frame = [&] { frames.push_back(simulation.time()); };
  EXPECT_EQ(run_to_the_end(simulation, scene.run, watchers), Stop::until);
  EXPECT_THAT(frames, testing::ElementsAre(2.5, 3.0, 4.0, 5.0, 6.0));
}

TEST(RunToTheEnd, stops_when_it_is_interrupted) {
  Scene scene = test::head_on(2);
  scene.run.until = 1e9;
  Simulation simulation(scene);
  std::atomic<bool> interrupt{false};
  Watchers watchers;
  watchers.interrupt = &interrupt;
  watchers.collision = [&](const Collision&) { interrupt = simulation.counts().collisions() >= 1000; };
  EXPECT_EQ(run_to_the_end(simulation, scene.run, watchers), Stop::interrupted);
  EXPECT_EQ(simulation.counts().collisions(), 1000);
}

}  // namespace
}  // namespace carom::app
