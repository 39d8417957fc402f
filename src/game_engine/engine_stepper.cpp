#include "engine_stepper.hpp"

#include <cmath>
#include <utility>

namespace carom::game_engine {

EngineStepper::EngineStepper(Layout layout, double dt, RunEnd end) : layout_(std::move(layout)), dt_(dt), runs_(end) {}

void EngineStepper::step(const StepSink& sink) {
  advance();
  ++step_;
  runs_.finish_step(layout_, time(), step_, sink);
}

double EngineStepper::time() const { return layout_.start + static_cast<double>(step_) * dt_; }

Point EngineStepper::driven_position(std::size_t ball, std::int64_t step) const {
  const Body& body = layout_.bodies[ball];
  const double t = static_cast<double>(step) * dt_;
  return along(along(body.position, t, body.velocity), t * t / 2, layout_.acceleration);
}

Point EngineStepper::driven_velocity(std::size_t ball) const {
  const Body& body = layout_.bodies[ball];
  return along(body.velocity, (static_cast<double>(step_) + 0.5) * dt_, layout_.acceleration);
}

std::vector<BallState> EngineStepper::balls() const {
  const auto d = static_cast<std::size_t>(layout_.dimension);
  std::vector<BallState> states;
  states.reserve(layout_.bodies.size());
  for (std::size_t i = 0; i < layout_.bodies.size(); ++i) {
    const Body& body = layout_.bodies[i];
    Point x = body.position, v{};
    if (body.kind == BodyKind::dynamic) {
      x = position(i);
      v = velocity(i);
    } else if (body.kind == BodyKind::driven) {
      x = position(i);
      v = along(body.velocity, static_cast<double>(step_) * dt_, layout_.acceleration);
    }
    BallState state;
    state.index = static_cast<std::uint32_t>(i);
    state.name = body.name;
    for (std::size_t k = 0; k < d; ++k) {
      state.position.push_back(layout_.to_user_length(x[k]));
      state.velocity.push_back(layout_.to_user_length(v[k]));
    }
    state.unwrapped_position = state.position;
    state.image.assign(d, 0);
    state.radius = layout_.to_user_length(body.radius);
    state.mass = std::ldexp(body.mass, -layout_.mass);
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace carom::game_engine
