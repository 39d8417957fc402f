#pragma once
// What the adapters have in common: the clock, the units, the balls of infinite mass, and the report of a step.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "carom/sim/stepper.hpp"
#include "contact_runs.hpp"
#include "layout.hpp"

namespace carom::game_engine {

class EngineStepper : public Stepper {
 public:
  EngineStepper(Layout layout, double dt, RunEnd end);

  void step(const StepSink& sink) final;
  [[nodiscard]] double time() const final;
  [[nodiscard]] std::vector<BallState> balls() const final;

 protected:
  /// Makes the engine go on by one step, telling runs_ of the contacts.
  virtual void advance() = 0;
  /// Of a ball that is not fixed, as the engine has them, in its units.
  [[nodiscard]] virtual Point position(std::size_t ball) const = 0;
  [[nodiscard]] virtual Point velocity(std::size_t ball) const = 0;

  /// A driven ball is at x0 + v0 t + a t^2 / 2 at the end of step `step`.
  [[nodiscard]] Point driven_position(std::size_t ball, std::int64_t step) const;
  /// The constant velocity that takes it from the end of the last step to the end of the next.
  [[nodiscard]] Point driven_velocity(std::size_t ball) const;

  const Layout layout_;
  const double dt_;
  ContactRuns runs_;
  std::int64_t step_ = 0;  ///< steps done
};

}  // namespace carom::game_engine
