// Lyapunov exponents where theory knows them: their symmetry, their zeros, their sum, and published values.

#include "carom/observe/lyapunov.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "carom/write/summary_json.hpp"
#include "observe/measure.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using testing::ball;
using testing::measure;
using testing::Measured;
using testing::scaled_count;

/// The triangular Lorentz gas: a point at speed `speed` among fixed disks of radius `a`, `spacing` apart.
Scene lorentz(double spacing, std::int64_t events, double a = 1, double speed = 1) {
  Scene scene = testing::box({0, 0}, {spacing, std::sqrt(3) * spacing});
  scene.space.kind = SpaceKind::periodic;
  scene.balls = {ball({0.5 * spacing, 0.1 * a}, {0.8 * speed, 0.6 * speed}, 0)};
  for (const double half : {0.0, 0.5}) {
    scene.balls.push_back(ball({half * spacing, half * std::sqrt(3) * spacing}, {}, a));
    scene.balls.back().fixed = true;
  }
  scene.run.events = events;
  scene.observe.lyapunov.emplace();
  return scene;
}

std::vector<double> exponents(const Measured& m) {
  std::vector<double> list;
  for (const Estimate& e : m.list)
    if (e.name.starts_with("lyapunov.exponents[")) list.push_back(e.value);
  return list;
}

// 0.8553(8) at spacing 3 (an independent code), 0.8 +- 0.2 in Gaspard and Baras, Phys. Rev. E 51, 5332. A point in two
// dimensions has (l, 0, 0, -l): one 0 for the flow, one for energy.
TEST(Lyapunov, of_the_triangular_lorentz_gas) {
  const Measured m = measure(lorentz(3, scaled_count(400'000)));
  const std::vector<double> l = exponents(m);
  ASSERT_EQ(l.size(), 4u);
  EXPECT_NEAR(l[0], 0.8553, 4 * (m.at("lyapunov.exponents[0]").error + 0.0008));
  EXPECT_LT(m.at("lyapunov.exponents[0]").error, 0.01);
  EXPECT_NEAR(l[1], 0, 1e-4);
  EXPECT_NEAR(l[2], 0, 1e-4);
  EXPECT_NEAR(l[0] + l[3], 0, 1e-6);
  EXPECT_NEAR(m["lyapunov.sum"], 0, 1e-6);
  EXPECT_NEAR(m["lyapunov.entropy"], l[0], 1e-4);
}

// Units of length and time are free: all events are the same ones, and exponents scale as 1 / time.
TEST(Lyapunov, scales_with_the_units) {
  const double plain = measure(lorentz(3, 2000))["lyapunov.exponents[0]"];
  for (const double speed : {0x1p-30, 0x1p30})
    EXPECT_NEAR(measure(lorentz(3 * 0x1p-20, 2000, 0x1p-20, 0x1p-20 * speed))["lyapunov.exponents[0]"] / speed, plain, 1e-12);
}

// Two points that start nearby inside a circle part as t: exponents ln(t) / t, so 0.
TEST(Lyapunov, of_a_circle_is_zero) {
  Scene scene = testing::open_space(2);
  scene.balls = {ball({0.2, -0.1}, {std::cos(0.6), std::sin(0.6)}, 0)};
  scene.walls = {testing::circle({0, 0}, 1, WallSide::inside)};
  scene.run.events = 50'000;
  scene.observe.lyapunov.emplace();
  for (const double l : exponents(measure(scene))) EXPECT_NEAR(l, 0, 3 * std::log(1e5) / 1e5);
}

// N hard disks in a periodic square: pairs of exponents add up to 0, and 2 D + 2 of them are 0, for the centre of mass, its
// momentum, the flow and energy [DellagoPosch1997].
TEST(Lyapunov, of_hard_disks_come_in_pairs) {
  Scene scene = testing::open_space(2);
  GasSpec gas;
  gas.count = 4;
  gas.packing_fraction = 0.3;
  gas.radius = 0.5;
  scene.gases = {gas};
  scene.run.events = scaled_count(60'000);
  scene.observe.lyapunov.emplace();
  const Measured m = measure(scene);
  const std::vector<double> l = exponents(m);
  ASSERT_EQ(l.size(), 16u);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(l[k] + l[15 - k], 0, 2e-3 * l[0]) << k;
  for (std::size_t k = 5; k < 11; ++k) EXPECT_NEAR(l[k], 0, 3e-3 * l[0]) << k;
  EXPECT_GT(l[4], 0.05 * l[0]);
  scene.observe.lyapunov->exponents = 1;
  const Measured largest = measure(scene);
  EXPECT_EQ(exponents(largest).size(), 1u);
  EXPECT_NEAR(exponents(largest)[0], l[0], 5e-3 * l[0]);
}

// Every impact at restitution e contracts phase space by e^2, once for the normal velocity and once for the place, whatever
// hits what: balls of unequal masses, walls, moving walls, under gravity.
TEST(Lyapunov, volumes_contract_by_the_square_of_the_restitution) {
  Scene scene = testing::mixed_box(2, 5, 6.0, 3);
  scene.collision.restitution = 0.95;
  scene.motion.acceleration = {0.1, -1};
  scene.walls = {testing::circle({3, 5}, 0.5, WallSide::outside), testing::plane({0, -0.2}, {0, 1})};
  scene.walls[1].velocity = {0, 0.25};
  scene.run.until = 1.5;
  scene.observe.lyapunov.emplace();
  scene.observe.lyapunov->exponents = 20;
  const Measured m = measure(scene);
  const double hits = static_cast<double>(m.summary.events.ball_ball + m.summary.events.ball_wall);
  EXPECT_GT(hits, 10);
  EXPECT_NEAR(m["lyapunov.sum"] * 1.5, hits * 2 * std::log(0.95), 1e-8);
  Scene space = testing::mixed_box(3, 4, 4.0, 5);
  space.collision.restitution = 0.9;
  space.run.events = 60;
  space.observe.lyapunov.emplace();
  space.observe.lyapunov->exponents = 24;
  const Measured n = measure(space);
  EXPECT_NEAR(n["lyapunov.sum"] * n.summary.time.value, 120 * std::log(0.9), 1e-8);
}

// Spans add up to the whole; the interval of the orthonormalisation does not matter.
TEST(Lyapunov, of_finite_times) {
  Scene scene = lorentz(3, 1);
  scene.run.events.reset();
  scene.run.until = 4000.0;
  const Measured plain = measure(scene);
  scene.observe.lyapunov->finite_time = 12.5;
  Simulation simulation(scene);
  Observers observers(scene, simulation);
  simulation.run(observers.sink());
  observers.end(simulation);
  Measured spans{observers.estimates(), {}, simulation.summary()};
  EXPECT_NEAR(spans["lyapunov.finite_time.mean[0]"], spans["lyapunov.exponents[0]"], 1e-12);
  EXPECT_NEAR(spans["lyapunov.exponents[0]"], plain["lyapunov.exponents[0]"], 1e-8);
  EXPECT_GT(spans["lyapunov.finite_time.spread[0]"], 0.05);
  ASSERT_EQ(observers.tables().size(), 1u);
  const Table table = observers.tables()[0];
  double total = 0;
  for (const auto& row : table.rows) total += row[1];
  EXPECT_NEAR(total * (table.rows[1][0] - table.rows[0][0]), 1, 1e-12);
  scene.observe.lyapunov->finite_time.reset();
  scene.observe.lyapunov->every = 5.0;
  EXPECT_NEAR(measure(scene)["lyapunov.exponents[0]"], plain["lyapunov.exponents[0]"], 1e-8);
}

TEST(Lyapunov, stands_as_a_list_in_the_summary) {
  RunReport report;
  report.observed = {{"lyapunov.exponents[0]", 1.5, 0.25}, {"lyapunov.exponents[1]", -1.5, 0.25}, {"lyapunov.sum", 0, 0}};
  const auto json = nlohmann::json::parse(summary_json(report))["observed"]["lyapunov"];
  ASSERT_TRUE(json["exponents"].is_array());
  EXPECT_EQ(json["exponents"][1]["value"], -1.5);
  EXPECT_EQ(json["exponents"][0]["error"], 0.25);
  EXPECT_EQ(json["sum"]["value"], 0);
}

}  // namespace
}  // namespace carom
