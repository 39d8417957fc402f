#pragma once
// A scene moved by time steps of one length: what carom's fixed-step methods and the engines built beside it have in common.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "carom/predict/event.hpp"
#include "carom/sim/summary.hpp"

namespace carom {

/// A contact that a step found, in the user's units.
struct StepContact {
  double time = 0.0;      ///< [time] end of the step that found it; the moment itself where the method knows it
  std::int64_t step = 0;  ///< number of that step, from 1
  EventKind kind = EventKind::none;  ///< ball_ball or ball_wall
  std::uint32_t ball = 0;            ///< ball_ball: the smaller number
  std::uint32_t partner = 0;         ///< a ball's number, or a wall's as Simulation numbers them
  std::int32_t feature = 0;          ///< of the wall
  double overlap = 0.0;              ///< [length] depth at which it was found, >= 0
  double impulse = 0.0;              ///< [momentum] size; 0: they touch, and nothing was done
};

using StepSink = std::function<void(const StepContact&)>;

class Stepper {
 public:
  Stepper() = default;
  virtual ~Stepper() = default;
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  /// Goes on by one step. `sink` is given every contact that the step found, in the order in which it was treated.
  virtual void step(const StepSink& sink) = 0;

  [[nodiscard]] virtual double time() const = 0;                  ///< [time] of the scene's clock
  [[nodiscard]] virtual std::vector<BallState> balls() const = 0;  ///< by ball number, at time()
};

}  // namespace carom
