// Gases against the equation of state: what is measured agrees with the literature and with itself.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "observe/measure.hpp"
#include "sim/scenes.hpp"

namespace carom {
namespace {

using testing::measure;
using testing::Measured;
using testing::scaled_count;

/// A periodic gas of balls of diameter 1 and mass 1 at kT = 1.
Scene gas(int dimension, std::int64_t count, double packing, std::int64_t events) {
  Scene scene = testing::open_space(dimension);
  GasSpec balls;
  balls.count = count;
  balls.packing_fraction = packing;
  balls.radius = 0.5;
  scene.gases = {balls};
  scene.run.events = scaled_count(events);
  scene.observe.after_events = scaled_count(events) / 5;
  scene.observe.pressure = true;
  return scene;
}

/// Share of the volume that spheres of diameter 1 take at number density rho.
double packing_of_spheres(double rho) { return std::numbers::pi / 6 * rho; }

/// Statistical errors grow where checks leave time for fewer collisions.
double slack() { return std::sqrt(1e6 / static_cast<double>(scaled_count(1'000'000))); }

/// The measured value is the expected one within 4 standard errors, and these are small.
void expect_near(const Estimate& e, double expected, double largest_error) {
  EXPECT_NEAR(e.value, expected, 4 * e.error) << e.name;
  EXPECT_LT(4 * e.error, slack() * largest_error * expected) << e.name;
  EXPECT_GT(e.error, 0) << e.name;
}

// [HansenGoos2016], a fit to simulations good to 1e-4: Z = 1.96823, 3.26936, 4.29485 at rho = 0.3, 0.5, 0.6. The rate per
// ball is Gamma = 6/sqrt(pi) (Z - 1), the mean speed sqrt(8/pi), so the mean free path is sqrt(8/pi) / Gamma; V = N / rho.
TEST(Fluid, hard_spheres) {
  const struct {
    double rho, z;
    std::int64_t events;
  } states[] = {{0.3, 1.96823, 300'000}, {0.5, 3.26936, 400'000}, {0.6, 4.29485, 400'000}};
  for (const auto& [rho, z, events] : states) {
    Scene scene = gas(3, 1000, packing_of_spheres(rho), events);
    scene.observe.collision_rate = scene.observe.mean_free_path = true;
    const Measured m = measure(scene);
    const double rate = 6 / std::sqrt(std::numbers::pi) * (z - 1);
    expect_near(m.at("pressure.Z"), z, 0.005 * 3);
    expect_near(m.at("pressure.Z_rate"), z, 0.005 * 3);
    EXPECT_NEAR(m["pressure.Z"], z, slack() * 0.005 * z) << rho;
    EXPECT_NEAR(m["pressure.virial"], rho * m["pressure.Z"], 1e-9);
    EXPECT_NEAR(m["pressure.kT"], 1.0, 1e-12);
    expect_near(m.at("collision_rate"), rate, 0.015);
    expect_near(m.at("mean_free_path"), std::sqrt(8 / std::numbers::pi) / rate, 0.015);
    EXPECT_EQ(m["wall_collision_rate"], 0);
    EXPECT_EQ(m.summary.exactness.clamped, 0);
  }
}

// The virial series to the tenth coefficient [ClisbyMcCoy2006] gives Z = 1.236144 at eta = 0.10 and 1.570365 at 0.20.
TEST(Fluid, hard_disks) {
  for (const auto& [eta, z] : {std::pair{0.10, 1.236144}, std::pair{0.20, 1.570365}}) {
    const Measured m = measure(gas(2, 1000, eta, 300'000));
    EXPECT_NEAR(m["pressure.Z"], z, slack() * 0.005 * z) << eta;
    expect_near(m.at("pressure.Z"), z, 0.01);
    expect_near(m.at("pressure.Z_rate"), z, 0.01);
  }
}

// With kT = 2E / D_f there is no bias from the fixed energy and momentum, however few the balls: three disks in a cell have
// Z and Z_rate equal, while with kT = 2E/(d N) the two would differ by parts in ten.
TEST(Fluid, few_balls_have_no_bias) {
  const Measured m = measure(gas(2, 3, 0.15, 300'000));
  EXPECT_NEAR(m["pressure.Z_rate"] - 1, m["pressure.Z"] - 1, slack() * 0.01 * (m["pressure.Z"] - 1));
  EXPECT_NEAR(m["pressure.kT"], 1.0, 1e-12);
}

// N rods in a box of length L: the centres less what lies between them are N points in L - N sigma that pass through each
// other, so the force on a face is 2E / (L - N sigma) in the long run for every start; with kT = 2E/N,
// Z = P L / (N kT) = 1 / (1 - eta) [Tonks1936].
TEST(Fluid, rods_in_a_box) {
  Scene scene = testing::box({0}, {50});
  GasSpec rods;
  rods.count = 20;
  rods.radius = 0.5;
  scene.gases = {rods};
  scene.run.until = 2e4;
  scene.observe.pressure = true;
  const Measured m = measure(scene);
  const double z = 1 / (1 - 0.4), force = 2 * m.summary.energy.initial / 30;
  EXPECT_NEAR(m["pressure.Z"], z, 1e-3 * z);
  EXPECT_NEAR(m["pressure.virial"], force, 1e-3 * force);
  for (const char* name : {"pressure.wall", "pressure.face.x-", "pressure.face.x+"})
    EXPECT_NEAR(m[name], force, 1e-3 * force);
}

// A box: the virial with faces as partners, the impulses on the faces, and the rates are three views of one pressure.
TEST(Fluid, virial_and_walls_agree_in_a_box) {
  Scene scene = gas(3, 300, 0.2, 300'000);
  scene.gases[0].packing_fraction.reset();
  scene.space.kind = SpaceKind::box;
  scene.space.lower = {0, 0, 0};
  scene.space.upper = {8, 9, 10};
  const Measured m = measure(scene);
  const Estimate &virial = m.at("pressure.virial"), &wall = m.at("pressure.wall");
  EXPECT_NEAR(virial.value, wall.value, 4 * (virial.error + wall.error));
  EXPECT_NEAR(virial.value, wall.value, slack() * 0.01 * wall.value);
  EXPECT_NEAR(m["pressure.Z_rate"], m["pressure.Z"], slack() * 0.005 * m["pressure.Z"]);
  for (const char* face : {"x-", "x+", "y-", "y+", "z-", "z+"}) {
    const Estimate& e = m.at(std::string("pressure.face.") + face);
    EXPECT_NEAR(e.value, wall.value, 4 * (e.error + wall.error)) << face;
  }
}

/// Two kinds of spheres.
Scene mixture(std::int64_t events) {
  Scene scene = testing::box({0, 0, 0}, {11, 11, 11});
  scene.space.kind = SpaceKind::periodic;
  GasSpec light, heavy;
  light.count = 300;
  light.radius = 0.4;
  light.mass = 1;
  heavy.count = 150;
  heavy.radius = 0.7;
  heavy.mass = 7;
  heavy.seed = 2;
  scene.gases = {light, heavy};
  scene.run.events = scaled_count(events);
  scene.observe.after_events = scaled_count(events) / 5;
  scene.observe.pressure = scene.observe.speed_histogram = true;
  return scene;
}

// [Mansoori1971, eq. 10]: with x_k = (pi/6) sum rho_i sigma_i^k,
//   Z = (6 / (pi rho)) (x_0/(1 - x_3) + 3 x_1 x_2/(1 - x_3)^2 + x_2^3 (3 - x_3)/(1 - x_3)^3),
// good to 0.1 % below a packing of 0.25; masses do not enter. Here 0.222.
// Speeds scaled with sqrt(m) are Maxwell's whatever the masses, but for the fixed energy: <u^4> is lower by D_f / (D_f +
// 2).
TEST(Fluid, mixture_in_equilibrium) {
  double x[4];
  for (int k = 0; k < 4; ++k)
    x[k] = std::numbers::pi / 6 * (300 * std::pow(0.8, k) + 150 * std::pow(1.4, k)) / (11.0 * 11 * 11);
  const double left = 1 - x[3];
  const double z =
      (x[0] / left + 3 * x[1] * x[2] / (left * left) + std::pow(x[2], 3) * (3 - x[3]) / std::pow(left, 3)) / x[0];
  const Measured m = measure(mixture(300'000));
  EXPECT_NEAR(m["pressure.Z"], z, slack() * 0.006 * z);
  EXPECT_NEAR(m["pressure.Z_rate"], z, slack() * 0.006 * z);

  const double freedom = 3 * (450 - 1);
  EXPECT_NEAR(m["speed_histogram.maxwell_mean"], 1, slack() * 0.002);
  EXPECT_NEAR(m["speed_histogram.maxwell_fourth"], freedom / (freedom + 2), slack() * 0.006);
  EXPECT_NEAR(m["speed_histogram.mean_square"], 3 * (300.0 / 1 + 150.0 / 7) / 450, slack() * 0.03);
  double total = 0, maxwell = 0;
  for (const SpeedBin& bin : *m.speeds) {
    EXPECT_NEAR(bin.share, bin.maxwell, slack() * 0.002) << bin.from;
    total += bin.share;
    maxwell += bin.maxwell;
  }
  EXPECT_NEAR(total, 1, 1e-9);
  EXPECT_NEAR(maxwell, 1, 1e-5);
}

// Whatever the start, both kinds come to the same mean kinetic energy a ball.
TEST(Fluid, energy_is_shared_equally) {
  Scene scene = mixture(0);
  scene.gases[1].temperature = 0.1;  // out of equilibrium: the heavy ones are cold
  Simulation simulation(scene);
  simulation.advance(std::nullopt, scaled_count(50'000));
  double light = 0, heavy = 0;
  constexpr int samples = 100;
  for (int s = 0; s < samples; ++s) {
    simulation.advance(std::nullopt, scaled_count(1000));
    for (const BallState& b : simulation.balls()) {
      double square = 0;
      for (const double v : b.velocity) square += v * v;
      (b.index < 300 ? light : heavy) += b.mass * square / 2;
    }
  }
  EXPECT_NEAR((light / 300) / (heavy / 150), 1.0, slack() * 0.03);
}

// Homogeneous cooling: the energy lost a collision is (1 - e^2) kT on average, so T = T0 (1 + a t)^-2 with
// a = (1 - e^2) Gamma_0 / (2 d) [Haff1983]; Gamma_0 = 0.81149 at rho = 0.1. The sample of 4000 balls loses in some 28 000
// collisions, so a is known to 0.7 %.
TEST(Fluid, inelastic_gas_cools_at_haffs_rate) {
  Scene scene = gas(3, 4000, packing_of_spheres(0.1), 0);
  scene.collision.restitution = 0.95;
  scene.run.events.reset();
  scene.run.until = 25.0;
  scene.observe.after_events.reset();
  const Measured m = measure(scene);
  const double t0 = m.summary.energy.initial, t1 = m.summary.energy.final;
  const double a = (1 - 0.95 * 0.95) * 0.81149 / 6;
  EXPECT_NEAR((std::sqrt(t0 / t1) - 1) / 25, a, 0.02 * a);
  EXPECT_NEAR(t0 / t1, 1.77, 0.05);
  // Averaged over the time: int (1 + a t)^-2 dt / t = 1 / (1 + a t).
  EXPECT_NEAR(m["pressure.kT"], 1 / (1 + 25 * a), 0.01);
}

// Of all forces on a gas in a box only the weight is not from the faces, so in the long run floor - ceiling = N m g in any
// state, in equilibrium or not; the momentum that the gas may keep fades as 1/t. Side walls balance.
TEST(Fluid, floor_less_ceiling_is_the_weight) {
  Scene scene = testing::box({0, 0}, {20, 15});
  GasSpec disks;
  disks.count = 60;
  disks.radius = 0.5;
  disks.mass = 2;
  disks.temperature = 3;
  scene.gases = {disks};
  scene.motion.acceleration = {0, -0.25};
  scene.run.until = static_cast<double>(scaled_count(2000));
  scene.observe.pressure = true;
  const Measured m = measure(scene);
  EXPECT_NEAR((m["pressure.face.y-"] - m["pressure.face.y+"]) * 20, 60 * 2 * 0.25, 0.01 * 60 * 2 * 0.25);
  EXPECT_NEAR(m["pressure.face.x-"], m["pressure.face.x+"], 0.02 * m["pressure.face.x+"]);
  EXPECT_GT(m["pressure.face.y+"], 0);
}

}  // namespace
}  // namespace carom
