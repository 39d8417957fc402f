#include "carom/sim/fixed_step.hpp"

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "carom/core/error.hpp"
#include "carom/scene/exact_only.hpp"
#include "carom/scene/growing.hpp"
#include "carom/sim/fixed_step/discrete.hpp"
#include "carom/sim/fixed_step/penalty.hpp"
#include "carom/sim/fixed_step/speculative.hpp"
#include "carom/sim/fixed_step/step_method.hpp"
#include "carom/sim/fixed_step/swept.hpp"
#include "carom/world/build.hpp"
#include "step_method_rules.hpp"

namespace carom {

namespace {

template <int D, class Options>
struct MethodOf;
template <int D>
struct MethodOf<D, DiscreteOptions> {
  using type = Discrete<D>;
};
template <int D>
struct MethodOf<D, SweptOptions> {
  using type = Swept<D>;
};
template <int D>
struct MethodOf<D, SpeculativeOptions> {
  using type = Speculative<D>;
};
template <int D>
struct MethodOf<D, PenaltyOptions> {
  using type = Penalty<D>;
};

template <int D, class Options>
requires StepMethod<typename MethodOf<D, Options>::type, Options, D>
class FixedStep final : public Stepper {
 public:
  FixedStep(const Scene& scene, const Options& options, double dt, World<double, D> world)
      : start_(scene.run.start),
        dt_(dt),
        state_(std::move(world), dt),
        method_(options, state_, scene.engine.search == SearchKind::all_pairs) {}

  void step(const StepSink& sink) override {
    const std::int64_t next = state_.steps + 1;
    method_.step(state_, StepReport{sink, state_.world.units, next, start_ + static_cast<double>(next) * dt_});
  }

  [[nodiscard]] double time() const override { return start_ + static_cast<double>(state_.steps) * dt_; }

  [[nodiscard]] std::vector<BallState> balls() const override {
    std::vector<BallState> all(state_.size());
    for (std::uint32_t i = 0; i < state_.size(); ++i) all[i] = ball(i);
    return all;
  }

 private:
  [[nodiscard]] BallState ball(std::uint32_t i) const {
    const Units& units = state_.world.units;
    const Space<double, D>& space = state_.world.space;
    BallState b;
    b.index = i;
    b.name = state_.world.details[i].name;
    Vec<double, D> x = state_.x[i];
    const Turns<D> turns = state_.within_reach(i) ? wrap(space, x) : Turns<D>{};
    for (int k = 0; k < D; ++k) {
      b.position.push_back(std::ldexp(x[k], units.length));
      b.image.push_back(state_.turns[i][k] + turns[k]);
      b.unwrapped_position.push_back(
          std::ldexp(state_.x[i][k] + static_cast<double>(state_.turns[i][k]) * space.edge[k], units.length));
      b.velocity.push_back(std::ldexp(state_.v[i][k], units.velocity()));
    }
    b.radius = std::ldexp(state_.radius[i], units.length);
    b.mass = std::ldexp(state_.world.details[i].mass, units.mass);
    return b;
  }

  double start_, dt_;
  StepState<D> state_;
  typename MethodOf<D, Options>::type method_;
};

template <int D>
std::unique_ptr<Stepper> make(const Scene& scene, const FixedStepOptions& options) {
  World<double, D> world = build<double, D>(scene);
  return std::visit(
      [&](const auto& method) -> std::unique_ptr<Stepper> {
        using Options = std::remove_cvref_t<decltype(method)>;
        return std::make_unique<FixedStep<D, Options>>(scene, method, options.dt, std::move(world));
      },
      options.method);
}

std::vector<Problem> judge(const Scene& scene, const FixedStepOptions& options) {
  std::vector<Problem> problems = judge_step_method(options.method);
  for (Problem& p : exact_only(scene)) problems.push_back(std::move(p));
  if (!(options.dt > 0) || !std::isfinite(options.dt))
    problems.push_back({"", 0, fmt::format("dt = {}", options.dt), "a time step is > 0 and finite", ""});
  const PenaltyOptions* penalty = std::get_if<PenaltyOptions>(&options.method);
  if (penalty != nullptr && options.dt > 0) {
    const double steps = penalty->contact_time ? *penalty->contact_time / options.dt : penalty->steps;
    if (steps < least_contact_steps)
      problems.push_back({"", 0, fmt::format("penalty: an impact lasts {} time steps", steps),
                          fmt::format("below {} its spring is not stable", least_contact_steps),
                          "Give a longer contact_time, or a shorter dt"});
  }
  if (scene.collision.law != LawKind::restitution)
    problems.push_back(
        {scene.file, scene.collision.where.line,
         fmt::format("the fixed-step mode has no law \"{}\"", scene.collision.law == LawKind::stick ? "stick" : "merge"),
         "it does restitution only", "Use law = \"restitution\", or the event-driven mode"});
  for (const WallSpec& w : scene.walls)
    if (w.opening || scene.space.kind == SpaceKind::periodic)
      problems.push_back({scene.file, w.where.line,
                          w.opening ? "the fixed-step mode has no openings" : "the fixed-step mode has no walls in a periodic space",
                          "its walls stand once, and nothing passes them", "Leave the wall out, or use the event-driven mode"});
  if (balls_grow(scene))
    problems.push_back({scene.file, 0, "the fixed-step mode has no balls that grow", "it keeps the radii",
                        "Leave out radius_growth, or use the event-driven mode"});
  return problems;
}

}  // namespace

std::unique_ptr<Stepper> make_stepper(const Scene& scene, const FixedStepOptions& options) {
  const std::vector<Problem> problems = judge(scene, options);
  if (!problems.empty()) throw InputError(problems);
  switch (scene.dimension) {
    case 1:
      return make<1>(scene, options);
    case 2:
      return make<2>(scene, options);
    case 3:
      return make<3>(scene, options);
    default:
      throw InputError(Problem{scene.file, 0, "dimension = " + std::to_string(scene.dimension), "it is 1, 2 or 3", ""});
  }
}

}  // namespace carom
