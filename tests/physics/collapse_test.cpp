// Infinitely many impacts in finite time: recognised where they are, and nowhere else; and what TC and viscoelastic
// restitution make of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;
using ::testing::HasSubstr;

// 7 - 4 sqrt(3): three equal points on a line, at or below which there is no end [McNamaraYoung1992].
const double critical = 7 - 4 * std::sqrt(3.0);

Scene train(double r, double drift = -1.0 / 3.0) {
  Scene scene = open_space(1);
  scene.collision.restitution = r;
  scene.balls = {ball({-2.0}, {1.0 + drift}, 0.0), ball({0.0}, {drift}, 0.0), ball({1.75}, {drift}, 0.0)};
  return scene;
}

// In the frame of the centre of mass, where relative speeds keep all their digits.
TEST(Collapse, of_three_balls_on_both_sides_of_the_edge) {
  for (const double off : {2e-3, 5e-3, 0.02}) {
    const Result above = run(train(critical + off), 100'000);
    EXPECT_EQ(above.stop, Stop::no_events_left) << off;
    const double phi = std::acos((1 + critical + off) / (4 * std::sqrt(critical + off)));
    EXPECT_EQ(double(above.log.size()), std::ceil(M_PI / phi) - 1) << off;
    const Result below = run(train(critical - off), 100'000);
    EXPECT_EQ(below.stop, Stop::collapse) << off;
    EXPECT_LT(below.log.size(), 500u);
    ASSERT_TRUE(below.summary.stopped.has_value());
    EXPECT_EQ(below.summary.stopped->balls, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_THAT(below.summary.stopped->reason, HasSubstr("contact_time"));
    EXPECT_LE(below.summary.energy.relative_error, 1e-15);
  }
}

// With a common velocity of 1e6 times the relative one, the relative speeds end in rounding: that is no end of the collapse.
TEST(Collapse, in_a_frame_that_moves_fast) {
  for (const double drift : {1e3, -1e4, 1e6})
    for (const double r : {0.065, 0.05, 0.03, 0.01}) {
      const Result result = run(train(r, drift), 100'000);
      EXPECT_EQ(result.stop, Stop::collapse) << "r " << r << ", drift " << drift << ", " << result.log.size();
    }
  for (const double drift : {1e3, 1e6})
    for (const double r : {0.09, 0.2, 0.5, 0.9})
      EXPECT_EQ(run(train(r, drift), 100'000).stop, Stop::no_events_left) << "r " << r << ", drift " << drift;
}

// A light ball between an elastic wall and a heavy one: with the velocities (u, v) mapped by impact and wall in turn, the
// number of impacts of the two follows, and is infinite where the map has real eigenvalues.
TEST(Collapse, against_an_elastic_wall) {
  const auto squeezed = [](double mass, double e) {
    Scene scene = open_space(1);
    scene.collision.restitution = e;
    scene.walls = {plane({0.0}, {1.0})};
    scene.walls[0].restitution = 1.0;
    scene.balls = {ball({2.0}, {0.0}), ball({5.0}, {-1.0}, 0.5, mass)};
    return run(scene, 1'000'000);
  };
  for (const auto& [mass, e, hits] : {std::tuple{3.0, 0.08, 11}, {5.0, 0.15, 22}, {6.0, 0.18, 27}, {10.0, 0.4, 7}}) {
    const Result result = squeezed(mass, e);
    EXPECT_EQ(result.stop, Stop::no_events_left) << mass;
    EXPECT_EQ(result.summary.events.ball_ball, hits) << mass;
  }
  for (const auto& [mass, e] : {std::pair{3.0, 0.02}, {10.0, 0.1}, {20.0, 0.3}, {100.0, 0.2}, {1e4, 0.4}}) {
    const Result result = squeezed(mass, e);
    EXPECT_EQ(result.stop, Stop::collapse) << mass;
    EXPECT_LT(result.log.size(), 20'000u) << mass;
    EXPECT_LE(result.summary.energy.relative_error, 1e-14);
  }
}

// Slow decline: with e = 0.9999 the flights of a dropped ball fall by 1e-4 a bounce, and the clock stops telling one from the
// next long before they end.
TEST(Collapse, of_bounces_that_lose_little) {
  for (const double e : {0.99, 0.999, 0.9999}) {
    Scene scene = open_space(1);
    scene.motion.acceleration = {-1.0};
    scene.collision.restitution = e;
    scene.walls = {plane({0.0}, {1.0})};
    scene.balls = {ball({1.0}, {0.0}, 0.5)};
    const Result result = run(scene, 2'000'000);
    EXPECT_EQ(result.stop, Stop::collapse) << e;
    EXPECT_NEAR(result.summary.time, (1 + e) / (1 - e), 1e-10 / (1 - e)) << e;  // sqrt(2 h / g) = 1
  }
}

// Elastic and dissipating walls in one scene: Galperin's count stays [Galperin2003].
TEST(Collapse, is_no_elastic_sequence) {
  Scene scene = open_space(1);
  scene.walls = {plane({0.0}, {1.0}), plane({1e9}, {-1.0})};
  scene.walls[1].restitution = 0.5;  // never reached; it makes the run watch for collapse
  scene.balls = {ball({1.0}, {0.0}, 0.0), ball({2.0}, {-1.0}, 0.0, 1e8)};
  scene.run.until = 100.0;
  Simulation simulation(scene);
  EXPECT_EQ(simulation.run(), Stop::until);
  EXPECT_EQ(simulation.counts().collisions(), 31415);
}

// Along the faces of a channel a ball keeps its speed, across them it halves it at every hit: for ever, and resolved.
TEST(Collapse, is_not_the_slowing_down_of_one_component) {
  Scene scene = open_space(2);
  scene.collision.restitution = 0.5;
  scene.walls = {plane({0.0, 0.0}, {1.0, 0.0}), plane({1.0 + 0x1p-20, 0.0}, {-1.0, 0.0})};
  scene.balls = {ball({0.5 + 0x1p-21, 0.0}, {1.0, 1.0})};
  const Result result = run(scene, 56);
  EXPECT_EQ(result.stop, Stop::events);
  EXPECT_EQ(std::abs(result.balls[0].velocity[0]), 0x1p-56);
}

// TC: e = 1 if either party's last contact is at most t_c ago. A middle ball of three is hit at t = 1, and again at 1.5.
TEST(ContactTime, makes_the_second_of_two_close_impacts_elastic) {
  const auto restitutions = [](double contact_time) {
    Scene scene = open_space(1);
    scene.collision.restitution = 0.5;
    scene.collision.contact_time = contact_time;
    scene.balls = {ball({-1.0}, {1.0}, 0.0), ball({0.0}, {0.0}, 0.0, 1e9), ball({1.5}, {-1.0}, 0.0)};
    std::vector<double> e;
    for (const Collision& c : run(scene, 2).log) e.push_back(c.restitution);
    return e;
  };
  EXPECT_EQ(restitutions(0.0), (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(restitutions(0.25), (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(restitutions(0.75), (std::vector<double>{0.5, 1.0}));
}

// Obstacles have no last contact; walls count for the ball that hits them.
TEST(ContactTime, counts_walls_and_not_obstacles) {
  Scene scene = open_space(1);
  scene.collision.restitution = 0.5;
  scene.collision.contact_time = 3.0;
  scene.walls = {plane({0.0}, {1.0})};
  scene.balls = {ball({1.0}, {-1.0}, 0.0), ball({2.0}, {0.0}, 0.0)};
  scene.balls[1].fixed = true;
  const Result result = run(scene, 3);  // the wall at t = 1, the obstacle at 1 + 2 / 0.5 = 5, the wall 8 later
  ASSERT_EQ(result.log.size(), 3u);
  EXPECT_EQ(result.log[1].restitution, 0.5) << "the last contact is 4 ago";
  scene.collision.contact_time = 4.5;
  EXPECT_EQ(run(scene, 2).log[1].restitution, 1.0) << "the wall was hit 4 ago";
}

TEST(ContactTime, ends_a_collapse) {
  for (const double r : {0.0, 0.01, 0.05, 0.07}) {
    Scene scene = train(r);
    scene.collision.contact_time = 1e-6;
    const Result result = run(scene, 100'000);
    EXPECT_EQ(result.stop, Stop::no_events_left) << r;
    EXPECT_LE(result.summary.energy.relative_error, 1e-15);
  }
}

// Haff's regime and beyond: a granular gas that collapses in the plane goes on.
TEST(ContactTime, lets_a_granular_gas_cool_on) {
  Scene scene = mixed_box(2, 36, 8.0, 31, 0.9, 1.0);
  scene.collision.restitution = 0.3;
  EXPECT_EQ(run(scene, 30'000).stop, Stop::collapse);
  scene.collision.contact_time = 1e-4;
  const Result result = run(scene, 30'000);
  EXPECT_EQ(result.stop, Stop::events);
  EXPECT_LE(result.summary.energy.relative_error, 1e-15);
}

// e(v) [papers/viscoelastic.md, eq. 3]: 1 - e falls as v^(1/5), to leading order.
TEST(ViscoelasticRun, has_its_restitution_at_the_reference_speed_and_rises_to_1) {
  const auto e_at = [](double v) {
    Scene scene = open_space(1);
    scene.collision.restitution = 0.95;
    scene.collision.regularise = Regularise::viscoelastic;
    scene.collision.reference_speed = 2.0;
    scene.balls = {ball({-1.0}, {v}, 0.0), ball({0.0}, {0.0}, 0.0)};
    return run(scene, 1).log.at(0).restitution;
  };
  EXPECT_NEAR(e_at(2.0), 0.95, 1e-15);
  EXPECT_LT(e_at(20.0), 0.95);
  EXPECT_NEAR((1 - e_at(2e-10)) / (1 - e_at(2e-15)), 10.0, 0.01);
}

TEST(ViscoelasticRun, does_not_collapse) {
  for (const double r : {0.01, 0.05, 0.07}) {
    Scene scene = train(r);
    scene.collision.regularise = Regularise::viscoelastic;
    scene.collision.reference_speed = 1.0;
    EXPECT_EQ(run(scene, 100'000).stop, Stop::no_events_left) << r;
  }
}

// Under gravity it comes to rest in finite time all the same, and says so.
TEST(ViscoelasticRun, under_gravity_names_the_remedy) {
  Scene scene = open_space(1);
  scene.motion.acceleration = {-1.0};
  scene.collision.restitution = 0.8;
  scene.collision.regularise = Regularise::viscoelastic;
  scene.collision.reference_speed = 1.0;
  scene.walls = {plane({0.0}, {1.0})};
  scene.balls = {ball({1.0}, {0.0}, 0.5)};
  const Result result = run(scene, 1'000'000);
  ASSERT_EQ(result.stop, Stop::collapse);
  EXPECT_THAT(result.summary.stopped->reason, HasSubstr("\"rest\""));
}

}  // namespace
}  // namespace carom
