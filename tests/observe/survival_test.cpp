// Survival: who is left, and the rate at which balls leave.

#include "carom/observe/survival.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "carom/core/error.hpp"
#include "carom/scene/read.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

/// Four balls at 1, 2, 3 and 4 from an opening, all at speed 1, one that comes never, and one that is fixed.
Scene departing(const std::optional<double>& from, const std::optional<double>& to) {
  Scene scene = testing::open_space(2);
  WallSpec gap;
  gap.kind = WallKind::segment;
  gap.from = {0.0, -10.0};
  gap.to = {0.0, 10.0};
  gap.opening = true;
  scene.walls = {gap};
  for (const double x : {1.0, 2.0, 3.0, 4.0}) scene.balls.push_back(testing::ball({-x, x}, {1.0, 0.0}, 0.25));
  scene.balls.push_back(testing::ball({-5.0, 0.0}, {-1.0, 0.0}, 0.25));
  scene.balls.push_back(testing::ball({-5.0, -5.0}, {}, 0.25));
  scene.balls.back().fixed = true;
  scene.observe.survival.emplace();
  if (from) scene.observe.survival->from = *from;
  if (to) scene.observe.survival->to = *to;
  scene.observe.survival->bins = 4;
  return scene;
}

Estimates measured(const Scene& scene, double until) {
  Simulation simulation(scene);
  const Survival survival(scene, simulation);
  simulation.advance(Number(until), std::nullopt);
  return survival.estimates(simulation);
}

// From 3 to 5 one leaves in the middle, where the weight is 1, as one of two; the integral of the weights is 256 / 315.
TEST(Survival, rate_is_a_weighted_mean_of_departures_over_those_inside) {
  const Estimates one = measured(departing(3.0, 5.0), 8.0);
  EXPECT_EQ(one[0].name, "survival.escape_rate");
  EXPECT_NEAR(one[0].value, 315.0 / 512, 1e-15);
  EXPECT_NEAR(one[0].error, 315.0 / 512, 1e-15);
  EXPECT_EQ(one[1].value, 1.0);
  EXPECT_EQ(measured(departing(std::nullopt, std::nullopt), 8.0)[1].value, 4.0);
  EXPECT_TRUE(std::isnan(measured(departing(5.0, 6.0), 8.0)[0].value));
  // Where all leave, to the last departure: without the ball that never comes the span is 2 to 4, with one of two in its middle.
  Scene scene = departing(2.0, std::nullopt);
  scene.balls.erase(scene.balls.begin() + 4);
  EXPECT_NEAR(measured(scene, 8.0)[0].value, 315.0 / 512, 1e-15);
}

// Balls that leave at the quantiles of an exponential law.
TEST(Survival, rate_and_error_are_those_of_an_exponential_law) {
  Scene scene = departing(0.0, 4.0);
  const double gamma = 0.75;
  const int n = 2000;
  scene.balls.clear();
  for (int k = 0; k < n; ++k)
    scene.balls.push_back(testing::ball({std::log(1 - (k + 0.5) / n) / gamma, 20.0 * k / n - 10 + 0.001}, {1.0, 0.0}, 0.0));
  const Estimates found = measured(scene, 5.0);
  EXPECT_NEAR(found[0].value, gamma, 1e-3);
  EXPECT_LT(found[0].error, 0.05 * gamma);
}

TEST(Survival, curve_and_list_tell_when_where_and_who) {
  const Scene scene = departing(std::nullopt, std::nullopt);
  Simulation simulation(scene);
  const Survival survival(scene, simulation);
  simulation.advance(Number(6.0), std::nullopt);
  const std::vector<Table> tables = survival.tables(simulation);
  ASSERT_EQ(tables.size(), survival_files(scene.observe).size());
  const std::vector<std::vector<double>> curve{{0.0, 5.0}, {1.5, 4.0}, {3.0, 2.0}, {4.5, 1.0}, {6.0, 1.0}};
  ASSERT_EQ(tables[0].rows.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(tables[0].rows[k][0], curve[k][0]);
    EXPECT_EQ(tables[0].rows[k][1], curve[k][1]);
    EXPECT_EQ(tables[0].rows[k][2], curve[k][1] / 5);
  }
  EXPECT_EQ(tables[1].columns, (std::vector<std::string>{"ball", "time", "x", "y", "vx", "vy", "wall", "feature"}));
  ASSERT_EQ(tables[1].rows.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    const double n = static_cast<double>(k);
    EXPECT_EQ(tables[1].rows[k], (std::vector<double>{n, n + 1, 0.0, n + 1, 1.0, 0.0, 0.0, 0.0}));
  }
}

TEST(Survival, has_no_meaning_where_nothing_can_leave) {
  Scene scene = departing(std::nullopt, std::nullopt);
  scene.walls[0].opening = false;
  const Simulation simulation(scene);
  EXPECT_THROW((void)Survival(scene, simulation), InputError);
}

// Three disks of radius 1 at distance 6: gamma = 0.410338407769 for unit speed, by a cycle expansion [GaspardRice1989].
TEST(Survival, three_disks_leak_at_the_rate_of_their_cycles) {
  const Scene scene = read_scene(R"([[table]]
kind = "pinball"
spacing = 6
radius = 1
[[gas]]
count = 60_000
radius = 0
speed = 1
seed = 3
[run]
until = 20
[observe]
survival = { from = 4, to = 20 }
)", "pinball.toml");
  Simulation simulation(scene);
  EXPECT_EQ(simulation.composition().search, "walls alone");
  const Survival survival(scene, simulation);
  simulation.run();
  const Estimates found = survival.estimates(simulation);
  EXPECT_LT(found[0].error, 0.04 * 0.41);
  EXPECT_LT(std::abs(found[0].value - 0.410338407769), 4 * found[0].error);
  // Every point that is gone went through the opening, wall 3.
  for (const Departure& d : simulation.departures()) ASSERT_EQ(d.wall, 3u);
  EXPECT_EQ(simulation.departures().size() + simulation.balls().size(), 60'000u);
}

}  // namespace
}  // namespace carom
