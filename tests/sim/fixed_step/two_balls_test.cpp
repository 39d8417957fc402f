// What a time step costs where two balls meet: missed meetings, and an error that falls with dt.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/fixed_step/stepping.hpp"

namespace carom {
namespace {

using namespace testing;

// Two balls of radius 0.01, a gap of 1 between them, 200 of relative speed: in a step of 0.01 they pass by 2.
TEST(TwoBallsInSteps, a_fast_pair_passes_through_unless_it_is_swept) {
  Scene scene = open_space(2);
  scene.balls = {ball({-0.51, 0.0}, {100.0, 0.0}, 0.01), ball({0.51, 0.0}, {-100.0, 0.0}, 0.01)};
  for (const std::string& method : every_method) {
    const Stepped result = run_steps(scene, 1e-2, method, 10);
    const bool continuous = method.starts_with("swept") || method.starts_with("speculative");
    EXPECT_EQ(result.collisions(), continuous ? 1 : 0) << method;
    EXPECT_NEAR(result.balls[0].velocity[0], continuous ? -100.0 : 100.0, 1e-10) << method;
    EXPECT_NEAR(result.balls[1].velocity[0], continuous ? 100.0 : -100.0, 1e-10) << method;
  }
}

// The same formulas as in the event-driven mode, head-on, in each dimension:
//   v1 = (m1 u1 + m2 u2 - e m2 (u1 - u2)) / (m1 + m2), v2 alike.
TEST(TwoBallsInSteps, restitution_in_every_dimension) {
  for (const std::string& method : every_method)
    for (const double e : {1.0, 0.5})
      for (int d = 1; d <= 3; ++d) {
        Scene scene = open_space(d);
        scene.collision.restitution = e;
        const auto along_x = [&](double x) {
          Coordinates c(static_cast<std::size_t>(d), 0.0);
          c[0] = x;
          return c;
        };
        scene.balls = {ball(along_x(-3.0), along_x(5.0), 0.5, 2.0), ball(along_x(3.0), along_x(-1.0), 0.25, 3.0)};
        const Stepped result = run_steps(scene, 1e-4, method, 20000);
        EXPECT_EQ(result.collisions(), 1) << method << " in " << d << "-D";
        const double common = (2.0 * 5.0 - 3.0) / 5.0, tolerance = method == "penalty" ? 0.15 : 1e-13;
        EXPECT_NEAR(result.balls[0].velocity[0], common - e * 3.0 * 6.0 / 5.0, tolerance) << method << " e " << e;
        EXPECT_NEAR(result.balls[1].velocity[0], common + e * 2.0 * 6.0 / 5.0, tolerance) << method << " e " << e;
      }
}

/// Mean over start offsets of the largest position error at t = 4, in steps of 2^-k.
double mean_error(const std::string& method, int k) {
  constexpr int offsets = 250;
  Dice dice(7);
  double sum = 0;
  for (int n = 0; n < offsets; ++n) {
    Scene scene = open_space(2);
    scene.balls = {ball({-2.5 - 0.25 * dice.unit(), 0.35}, {1.5, 0.1}), ball({0.0, 0.0}, {-0.2, 0.05}, 0.4, 2.0)};
    const std::vector<BallState> exact = run_until(scene, 4.0).balls;
    const std::vector<BallState> stepped = run_steps(scene, std::ldexp(1.0, -k), method, std::int64_t{4} << k).balls;
    double worst = 0;
    for (std::size_t b = 0; b < 2; ++b)
      worst = std::max(
          worst, std::hypot(stepped[b].position[0] - exact[b].position[0], stepped[b].position[1] - exact[b].position[1]));
    sum += worst;
  }
  return sum / offsets;
}

// A contact is found up to dt late, deeper than it was and with its normal turned: all of first order. One start alone
// gives a sawtooth in dt, so the error is a mean over where in a step the contact falls.
TEST(TwoBallsInSteps, discrete_converges_at_first_order) {
  for (const char* method : {"discrete", "discrete:correction=none", "speculative"}) {
    const double slope = (std::log2(mean_error(method, 4)) - std::log2(mean_error(method, 9))) / 5;
    EXPECT_NEAR(slope, 1.0, 0.1) << method;
  }
}

// A ball that passes another at impact parameter b is within reach along a chord of 2 sqrt(s^2 - b^2), s the sum of the
// radii. Steps of length L = |v| dt fall into it with probability min(1, chord / L); and while the two still approach, in
// the first half of it, with half as much.
TEST(TwoBallsInSteps, discrete_misses_as_often_as_the_chord_says) {
  constexpr int starts = 4000;
  constexpr double s = 0.02, length = 0.1;
  Dice dice(8);
  for (const double b : {0.0, 0.01, 0.018}) {
    int unseen = 0, missed = 0;
    for (int n = 0; n < starts; ++n) {
      Scene scene = open_space(2);
      scene.balls = {ball({-0.5 - length * dice.unit(), b}, {10.0, 0.0}, 0.005), ball({0.0, 0.0}, {0.0, 0.0}, 0.015)};
      const Stepped result = run_steps(scene, length / 10.0, "discrete", 8);
      unseen += result.contacts.empty();
      missed += result.collisions() == 0;
    }
    const double chord = 2 * std::sqrt(s * s - b * b);
    const auto expect_share = [&](int count, double p, const char* what) {
      EXPECT_NEAR(count / double(starts), p, 4 * std::sqrt(p * (1 - p) / starts)) << what << ", b = " << b;
    };
    expect_share(unseen, 1 - chord / length, "never within reach");
    expect_share(missed, 1 - chord / 2 / length, "never within reach and approaching");
  }
}

// What is swept misses nothing: the chord does not matter.
TEST(TwoBallsInSteps, swept_misses_nothing) {
  Dice dice(9);
  for (int n = 0; n < 300; ++n) {
    Scene scene = open_space(2);
    scene.balls = {ball({-0.5 - dice.unit(), 0.0199 * dice.unit()}, {10.0, 0.0}, 0.005),
                   ball({0.0, 0.0}, {0.0, 0.0}, 0.015)};
    for (const char* method : {"swept", "swept:substeps"}) {
      const Stepped result = run_steps(scene, 0.4, method, 1);
      EXPECT_EQ(result.collisions(), 1) << method;
      const Result exact = run_until(scene, 0.4);
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < 2; ++k)
          EXPECT_NEAR(result.balls[i].position[k], exact.balls[i].position[k], 1e-13) << method;
      EXPECT_NEAR(result.contacts[0].time, exact.log[0].time, 1e-14);
      EXPECT_NEAR(result.contacts[0].impulse, exact.log[0].impulse, 1e-12);
    }
  }
}

}  // namespace
}  // namespace carom
