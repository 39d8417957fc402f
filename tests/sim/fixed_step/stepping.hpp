#pragma once
// Steppers made from texts, run for a number of steps, and what came out: what the tests of the fixed-step mode share.

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "carom/sim/fixed_step.hpp"
#include "sim/scenes.hpp"

namespace carom::testing {

[[nodiscard]] inline std::unique_ptr<Stepper> stepper(const Scene& scene, double dt, const std::string& method) {
  return make_stepper(scene, FixedStepOptions{dt, parse_step_method(method)});
}

struct Stepped {
  std::vector<StepContact> contacts;  ///< all
  std::vector<BallState> balls;
  double time = 0.0;

  [[nodiscard]] std::int64_t collisions() const {
    std::int64_t n = 0;
    for (const StepContact& c : contacts) n += c.impulse > 0;
    return n;
  }
};

[[nodiscard]] inline Stepped run_steps(const Scene& scene, double dt, const std::string& method, std::int64_t steps) {
  Stepped result;
  const auto s = stepper(scene, dt, method);
  for (std::int64_t n = 0; n < steps; ++n) s->step([&](const StepContact& c) { result.contacts.push_back(c); });
  result.balls = s->balls();
  result.time = s->time();
  return result;
}

[[nodiscard]] inline double kinetic_energy(const std::vector<BallState>& balls) {
  double energy = 0;
  for (const BallState& b : balls)
    for (const double v : b.velocity) energy += std::isfinite(b.mass) ? b.mass * v * v / 2 : 0.0;
  return energy;
}

/// One name of each method, and of those that differ in more than a number.
inline const std::vector<std::string> every_method{"discrete",
                                                   "discrete:iterations=8:correction=baumgarte",
                                                   "discrete:correction=none",
                                                   "swept",
                                                   "swept:substeps",
                                                   "speculative",
                                                   "penalty"};

}  // namespace carom::testing
