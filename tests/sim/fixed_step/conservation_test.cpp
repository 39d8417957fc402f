// What every method keeps, what only some keep, and the restitution that soft balls reproduce.

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/fixed_step/stepping.hpp"

namespace carom {
namespace {

using namespace testing;

/// Balls of unequal sizes and masses in a periodic cell.
Scene periodic_crowd(int dimension, int balls, double side, std::uint64_t seed) {
  Scene scene = mixed_box(dimension, balls, side, seed);
  scene.space.kind = SpaceKind::periodic;
  return scene;
}

std::array<double, 4> momentum(const std::vector<BallState>& balls) {
  std::array<double, 4> p{};  // three components, and the sum of sizes
  for (const BallState& b : balls) {
    double vv = 0;
    for (std::size_t k = 0; k < b.velocity.size(); ++k) {
      p[k] += b.mass * b.velocity[k];
      vv += b.velocity[k] * b.velocity[k];
    }
    p[3] += b.mass * std::sqrt(vv);
  }
  return p;
}

// Impulses and forces come in opposite pairs: only their roundings are left. Positions are pushed by inverse mass,
// so the centre of mass flies straight too.
TEST(Conservation, momentum_and_the_centre_of_mass) {
  for (const std::string& method : every_method)
    for (int d = 1; d <= 3; ++d) {
      Scene scene = periodic_crowd(d, d == 1 ? 8 : 30, d == 1 ? 12.0 : 8.0, 21);
      scene.collision.restitution = 0.8;
      const auto s = stepper(scene, 0.01, method);
      const auto centre = [&](const std::vector<BallState>& balls, std::size_t k) {
        double sum = 0, mass = 0;
        for (const BallState& b : balls) {
          sum += b.mass * b.unwrapped_position[k];
          mass += b.mass;
        }
        return std::pair{sum / mass, mass};
      };
      const std::vector<BallState> first = s->balls();
      const auto before = momentum(first);
      std::int64_t collisions = 0;
      for (int n = 0; n < 400; ++n) s->step([&](const StepContact& c) { collisions += c.impulse > 0; });
      const auto after = momentum(s->balls());
      EXPECT_GE(collisions, 5) << method << " in " << d << "-D";
      for (std::size_t k = 0; k < std::size_t(d); ++k) {
        EXPECT_NEAR(after[k], before[k], 1e-13 * before[3]) << method << " in " << d << "-D";
        const auto [x0, mass] = centre(first, k);
        EXPECT_NEAR(centre(s->balls(), k).first, x0 + before[k] / mass * s->time(), 1e-11) << method << " in " << d << "-D";
      }
    }
}

// Elastic impulses keep the kinetic energy, one by one; speculative contacts keep it for one pair, but not where a ball has
// several contacts in a step.
TEST(Conservation, energy_of_elastic_balls) {
  for (const std::string method :
       {"discrete", "discrete:iterations=8:correction=baumgarte", "discrete:correction=none", "swept", "swept:substeps"}) {
    Scene scene = periodic_crowd(2, 30, 8.0, 22);
    const auto s = stepper(scene, 0.01, method);
    const double before = kinetic_energy(s->balls());
    for (int n = 0; n < 1000; ++n) s->step({});
    EXPECT_NEAR(kinetic_energy(s->balls()) / before, 1.0, 1e-13) << method;
  }
  Scene pair = open_space(2);
  pair.balls = {ball({-2.0, 0.3}, {1.0, 0.0}), ball({0.0, 0.0}, {0.0, 0.2}, 0.5, 3.0)};
  const Stepped result = run_steps(pair, 0.07, "speculative", 60);
  EXPECT_EQ(result.collisions(), 1);
  EXPECT_NEAR(kinetic_energy(result.balls), 0.5 + 3.0 * 0.04 / 2, 1e-15);
}

TEST(Conservation, speculative_contacts_lose_energy_in_a_crowd) {
  Scene scene = periodic_crowd(2, 30, 8.0, 22);
  const auto s = stepper(scene, 0.05, "speculative");
  const double before = kinetic_energy(s->balls());
  for (int n = 0; n < 400; ++n) s->step({});
  EXPECT_LT(kinetic_energy(s->balls()), 0.9 * before);
}

/// Largest error of the restitution of one impact over where in a step it begins.
double restitution_error(double e, const std::string& method) {
  double worst = 0;
  for (int n = 0; n < 20; ++n) {
    Scene scene = open_space(1);
    scene.collision.restitution = e;
    scene.balls = {ball({-0.6 - 1e-3 * n / 20}, {1.0}, 0.5, 2.0), ball({0.5}, {0.0}, 0.5, 5.0)};
    const Stepped result = run_steps(scene, 1e-3, method, 1000);
    EXPECT_EQ(result.collisions(), 1);
    worst = std::max(worst, std::abs(result.balls[1].velocity[0] - result.balls[0].velocity[0] - e));
  }
  return worst;
}

// t_c = pi / omega and e = exp(-eta t_c) hold for the spring and dashpot in continuous time [Luding1998]; the error is that
// of entering and leaving the contact in the middle of a step, of order dt / t_c.
TEST(Penalty, reproduces_restitution_when_the_contact_is_resolved) {
  for (const double e : {1.0, 0.95, 0.8, 0.5, 0.2}) {
    EXPECT_LT(restitution_error(e, "penalty:steps=100"), 0.01) << e;
    EXPECT_LT(restitution_error(e, "penalty"), e == 1 ? 0.0005 : 0.05) << e << ", by default";
  }
}

// F = k d over half a period of pi / t_c: the overlap reaches v t_c / pi, and the whole impulse is 2 mu v.
TEST(Penalty, impact_lasts_the_contact_time) {
  Scene scene = open_space(1);
  scene.balls = {ball({-0.6}, {1.0}, 0.5, 2.0), ball({0.5}, {0.0}, 0.5, 2.0)};
  const Stepped result = run_steps(scene, 1e-4, "penalty:contact_time=0.1", 4000);
  ASSERT_EQ(result.contacts.size(), 1u);
  EXPECT_NEAR(result.contacts[0].time, 0.1 + 0.1, 3e-4) << "told at its end";
  EXPECT_NEAR(result.contacts[0].overlap, 0.1 / M_PI, 1e-4);
  EXPECT_NEAR(result.contacts[0].impulse, 2.0, 0.01);
}

}  // namespace
}  // namespace carom
