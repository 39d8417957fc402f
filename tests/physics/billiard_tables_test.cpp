// Chaotic and integrable tables against published numbers.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "carom/scene/tables.hpp"
#include "observe/measure.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using std::numbers::pi;
using testing::measure;
using testing::Measured;
using testing::scaled_count;

Scene table(TableKind kind) {
  Scene scene = testing::open_space(2);
  scene.tables.emplace_back();
  scene.tables.back().kind = kind;
  return scene;
}

// Half circles of radius 1, straight parts of 2: 0.43 v/R [BenettinStrelcyn1978], 0.4304(4) from an independent code; mean
// free path pi (pi + 4) / (2 pi + 4) [Chernov1997].
TEST(Stadium, exponents_and_free_path) {
  Scene scene = table(TableKind::stadium);
  scene.tables.back().radius = 1.0;
  scene.tables.back().length = 2.0;
  scene.balls = {testing::ball({0.3, 0.1}, {std::cos(1.1), std::sin(1.1)}, 0)};
  scene.run.events = scaled_count(300'000);
  scene.observe.lyapunov.emplace();
  scene.observe.mean_free_path = true;
  const Measured m = measure(scene);
  EXPECT_NEAR(m["lyapunov.exponents[0]"], 0.4304, 0.02 * 0.4304);
  EXPECT_NEAR(m["lyapunov.exponents[0]"] + m["lyapunov.exponents[3]"], 0, 1e-5);
  EXPECT_NEAR(m["lyapunov.exponents[1]"], 0, 1e-3);
  EXPECT_NEAR(m["lyapunov.exponents[2]"], 0, 1e-3);
  EXPECT_NEAR(m["mean_free_path"], pi * (pi + 4) / (2 * pi + 4), 5 * m.at("mean_free_path").error);
  EXPECT_LT(m.at("mean_free_path").error, 0.005);
}

// A disk of radius 0.25 in a larger stadium sees the same one.
TEST(Stadium, of_a_ball_is_a_smaller_one_of_a_point) {
  Scene scene = table(TableKind::stadium);
  scene.tables.back().radius = 1.25;
  scene.tables.back().length = 2.0;
  scene.balls = {testing::ball({0.3, 0.1}, {std::cos(1.1), std::sin(1.1)}, 0.25)};
  scene.run.events = scaled_count(100'000);
  scene.observe.lyapunov.emplace();
  EXPECT_NEAR(measure(scene)["lyapunov.exponents[0]"], 0.4304, 0.04 * 0.4304);
}

// Axes 2 and 1, on the chord from (2 cos 0.3, sin 0.3) towards the angle 2.5: L1 L2 about the foci is 0.8305520941916194 for ever, and
// nothing grows exponentially.
TEST(EllipseBilliard, keeps_its_caustic) {
  Scene scene = table(TableKind::ellipse);
  scene.tables.back().axes = {2.0, 1.0};
  scene.balls = {testing::ball({2 * std::cos(0.3) + 0.5 * std::cos(2.5), std::sin(0.3) + 0.5 * std::sin(2.5)},
                               {std::cos(2.5), std::sin(2.5)}, 0)};
  scene.run.events = 1000;
  scene.observe.caustic = scene.observe.rotation_number = true;
  const Measured m = measure(scene);
  EXPECT_NEAR(m["caustic.invariant"], 0.8305520941916194, 1e-12);
  EXPECT_LE(m["caustic.spread"], 1e-12);
  scene.run.events = scaled_count(100'000);
  scene.observe.lyapunov.emplace();
  const Measured longer = measure(scene);
  EXPECT_LE(longer["caustic.spread"], 1e-10);
  EXPECT_NEAR(longer["rotation_number"], m["rotation_number"], 2e-3);
  EXPECT_NEAR(longer["lyapunov.exponents[0]"], 0, 5e-4);
}

// The ready table of the Lorentz gas is the one of fixed disks: 1.7594(3) at 2.3.
TEST(LorentzTable, exponents) {
  Scene scene = table(TableKind::lorentz);
  scene.tables.back().radius = 1.0;
  scene.tables.back().spacing = 2.3;
  scene.balls = {testing::ball({1.1, 0.05}, {0.6, 0.8}, 0)};
  scene.run.events = scaled_count(200'000);
  scene.observe.lyapunov.emplace();
  scene.observe.mean_free_path = true;
  const Measured m = measure(scene);
  EXPECT_NEAR(m["lyapunov.exponents[0]"], 1.7594, 0.01 * 1.7594);
  EXPECT_NEAR(m["mean_free_path"], (std::sqrt(3.0) * 2.3 * 2.3 / 2 - pi) / 2, 5 * m.at("mean_free_path").error);
}

}  // namespace
}  // namespace carom
