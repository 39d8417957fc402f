#pragma once
// The simplest fixed-step loop there is, for tests of what compares it: free flight, two balls, no walls.

#include <cmath>
#include <utility>

#include "carom/sim/simulation.hpp"
#include "carom/sim/stepper.hpp"

namespace carom::testing {

/// Moves both balls of a simulation at its start by dt, then reflects them if they overlap and approach. The impulse is
/// that of an elastic impact times `gain`.
class LoopStepper final : public Stepper {
 public:
  LoopStepper(const Simulation& start, double dt, double gain = 1.0)
      : balls_(start.balls()), start_(start.time()), dt_(dt), gain_(gain) {}

  void step(const StepSink& sink) override {
    ++steps_;
    for (BallState& b : balls_)
      for (std::size_t k = 0; k < b.velocity.size(); ++k) {
        b.unwrapped_position[k].value += dt_ * b.velocity[k];
        b.position[k] = b.unwrapped_position[k];
      }
    collide(sink);
  }

  [[nodiscard]] double time() const override { return start_ + static_cast<double>(steps_) * dt_; }
  [[nodiscard]] std::vector<BallState> balls() const override { return balls_; }

 private:
  void collide(const StepSink& sink) {
    BallState &a = balls_.at(0), &b = balls_.at(1);
    double square = 0, closing = 0;
    std::vector<double> normal;
    for (std::size_t k = 0; k < a.position.size(); ++k) {
      normal.push_back(b.position[k] - a.position[k]);
      square += normal[k] * normal[k];
    }
    const double distance = std::sqrt(square);
    const double overlap = a.radius + b.radius - distance;
    if (overlap < 0) return;
    for (std::size_t k = 0; k < normal.size(); ++k) {
      normal[k] /= distance;
      closing += normal[k] * (a.velocity[k] - b.velocity[k]);
    }
    const double impulse = closing > 0 ? gain_ * 2 * closing * a.mass * b.mass / (a.mass + b.mass) : 0.0;
    for (std::size_t k = 0; k < normal.size(); ++k) {
      a.velocity[k].value -= impulse / a.mass * normal[k];
      b.velocity[k].value += impulse / b.mass * normal[k];
    }
    sink({time(), steps_, EventKind::ball_ball, 0, 1, 0, overlap, impulse});
  }

  std::vector<BallState> balls_;
  double start_, dt_, gain_;
  std::int64_t steps_ = 0;
};

}  // namespace carom::testing
