// What has no meaning in a scene is refused by name before anything is measured; what is not asked for costs nothing.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "carom/observe/observers.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> refused(const Scene& scene) {
  const Simulation simulation(scene);
  std::vector<std::string> what;
  try {
    const Observers observers(scene, simulation);
  } catch (const InputError& error) {
    for (const Problem& p : error.problems()) what.push_back(p.what + " | " + p.why);
  }
  return what;
}

Scene two_balls(Scene scene) {
  scene.balls = {testing::ball({2, 2}, {1, 0.5}), testing::ball({5, 5}, {-1, 0.25})};
  scene.run.events = 10;
  return scene;
}

Scene periodic() {
  Scene scene = testing::box({0, 0}, {8, 8});
  scene.space.kind = SpaceKind::periodic;
  return two_balls(scene);
}

TEST(Refusals, pressure_of_open_space) {
  Scene scene = two_balls(testing::open_space(2));
  scene.observe.pressure = true;
  EXPECT_THAT(refused(scene),
              ElementsAre(HasSubstr("observe.pressure has no meaning in this scene | an open space has no vol")));
  scene.observe.pressure = false;
  scene.observe.collision_rate = scene.observe.mean_free_path = scene.observe.speed_histogram = true;
  EXPECT_THAT(refused(scene), ElementsAre());
}

TEST(Refusals, pressure_of_obstacles_acceleration_and_a_lone_ball_in_a_periodic_space) {
  Scene scene = periodic();
  scene.observe.pressure = true;
  EXPECT_THAT(refused(scene), ElementsAre());
  scene.balls[1].fixed = true;
  scene.balls[1].velocity = {};
  EXPECT_THAT(refused(scene), ElementsAre(HasSubstr("obstacles")));
  scene.balls.pop_back();
  EXPECT_THAT(refused(scene), ElementsAre(HasSubstr("single ball")));
  scene = periodic();
  scene.observe.pressure = true;
  scene.motion.acceleration = {0, -1};
  EXPECT_THAT(refused(scene), ElementsAre(HasSubstr("accelerated")));
}

TEST(Refusals, flights_of_balls_that_stick_or_merge) {
  for (const LawKind law : {LawKind::stick, LawKind::merge}) {
    Scene scene = two_balls(testing::box({0, 0}, {8, 8}));
    scene.collision.law = law;
    scene.observe.collision_rate = true;
    EXPECT_THAT(refused(scene), ElementsAre());
    scene.observe.mean_free_path = scene.observe.pressure = scene.observe.speed_histogram = true;
    EXPECT_THAT(refused(scene), ElementsAre(HasSubstr("observe.mean_free_path"), HasSubstr("observe.pressure"),
                                            HasSubstr("observe.speed_histogram")));
  }
}

TEST(Refusals, anything_where_no_ball_is_free) {
  Scene scene = testing::open_space(2);
  BallSpec fixed = testing::ball({0, 0}, {});
  fixed.fixed = true;
  scene.balls = {fixed};
  EXPECT_THAT(refused(scene), ElementsAre());
  scene.observe.collision_rate = true;
  EXPECT_THAT(refused(scene), ElementsAre(HasSubstr("no ball has a finite mass")));
}

TEST(Observing, only_what_is_asked_for) {
  Scene scene = two_balls(testing::box({0, 0}, {8, 8}));
  const Simulation simulation(scene);
  Observers none(scene, simulation);
  EXPECT_FALSE(none.any());
  EXPECT_FALSE(none.sink()) << "so that the engine makes no record";
  EXPECT_TRUE(none.estimates().empty());
  EXPECT_FALSE(none.speed_table());

  scene.observe.pressure = true;
  Observers pressure(scene, simulation);
  EXPECT_TRUE(pressure.sink());
  std::vector<std::string> names;
  for (const Estimate& e : pressure.estimates()) names.push_back(e.name);
  EXPECT_THAT(names, ElementsAre("pressure.Z", "pressure.virial", "pressure.kT", "pressure.Z_rate", "pressure.wall",
                                 "pressure.face.x-", "pressure.face.x+", "pressure.face.y-", "pressure.face.y+"));
}

TEST(Observing, changes_no_event) {
  Scene scene = testing::box({0, 0}, {9, 9});
  scene.gases.emplace_back();
  scene.gases[0].count = 30;
  scene.gases[0].packing_fraction = 0.3;
  scene.motion.acceleration = {0, -1};
  const auto log = [&](bool observed) {
    scene.observe.collision_rate = scene.observe.mean_free_path = scene.observe.pressure = scene.observe.speed_histogram =
        observed;
    Simulation simulation(scene);
    Observers observers(scene, simulation);
    const CollisionSink sink = observers.sink();
    std::vector<double> times;
    simulation.advance(std::nullopt, 2000, [&](const Collision& c) {
      times.push_back(c.time);
      if (sink) sink(c);
    });
    observers.end(simulation);
    return std::pair(times, simulation.balls()[7].position);
  };
  EXPECT_EQ(log(true), log(false));
}

}  // namespace
}  // namespace carom
