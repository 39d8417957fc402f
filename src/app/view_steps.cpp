#include "view_steps.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/core.h>

#include "carom/game_engine/game_engine.hpp"
#include "carom/observe/comparison.hpp"
#include "carom/observe/enclosures.hpp"
#include "carom/write/number_text.hpp"

namespace carom::app {

namespace {

constexpr std::int64_t most_numbers = 1'000'000;  // of places that a page holds: 8 MB
constexpr std::int64_t most_steps = 100'000'000;

bool is_engine(const std::string& word) {
  const auto list = game_engines();
  return std::any_of(list.begin(), list.end(),
                     [&](const GameEngine& e) { return word.substr(0, word.find(':')) == e.name; });
}

/// How many steps end by `end`. Throws InputError.
std::int64_t steps_until(double end, const Scene& scene, double dt) {
  const double wanted = std::floor((end - scene.run.start) / dt * (1 + 1e-12));
  if (!(wanted >= 1) || wanted > static_cast<double>(most_steps))
    throw InputError(Problem{"", 0,
                             fmt::format("--compare {}: {} steps to time {}", number_text(dt), wanted, number_text(end)),
                             "a page compares 1 to 10^8 steps", "Give another step, or another --until"});
  return static_cast<std::int64_t>(wanted);
}

using Pair = std::tuple<EventKind, std::uint32_t, std::uint32_t>;

/// Of the exact meetings up to `end`, those that none of the steps' answers to: the k-th of a pair answers the k-th.
std::vector<std::int64_t> missed_events(const Meetings& exact, std::map<Pair, std::int64_t> answers, double end,
                                        const std::vector<std::int64_t>& event_of) {
  std::vector<std::int64_t> missed;
  for (std::size_t m = 0; m < exact.size() && exact[m].time <= end; ++m)
    if (--answers[{exact[m].kind, exact[m].ball, exact[m].partner}] < 0) missed.push_back(event_of[m]);
  return missed;
}

class Filming {
 public:
  Filming(const Scene& scene, const PlannedRow& row, std::int64_t steps)
      : stepper_(row.make(scene)), dimension_(static_cast<std::size_t>(scene.dimension)), steps_(steps) {
    const auto numbers = static_cast<std::int64_t>(stepper_->balls().size() * dimension_);
    each_ = std::max<std::int64_t>(1, (steps * numbers + most_numbers - 1) / most_numbers);
  }

  /// The answers to exact meetings up to the time `until`.
  std::map<Pair, std::int64_t> run(double until, const std::atomic<bool>& interrupt) {
    std::map<Pair, std::int64_t> answers;
    keep();
    for (std::int64_t n = 1; n <= steps_ && !interrupt; ++n) {
      stepper_->step([&](const StepContact& c) {
        if (c.impulse != 0 && c.time <= until) ++answers[{c.kind, c.ball, c.partner}];
      });
      if (n % each_ == 0 || n == steps_) keep();
    }
    return answers;
  }

  [[nodiscard]] std::int64_t each() const noexcept { return each_; }
  [[nodiscard]] std::size_t frames() const noexcept { return times_.size(); }
  [[nodiscard]] std::string bytes() const {
    std::string all(reinterpret_cast<const char*>(times_.data()), times_.size() * sizeof(double));
    return all.append(reinterpret_cast<const char*>(places_.data()), places_.size() * sizeof(double));
  }

 private:
  void keep() {
    times_.push_back(stepper_->time());
    for (const BallState& b : stepper_->balls())
      for (std::size_t k = 0; k < dimension_; ++k) places_.push_back(b.position[k]);
  }

  std::unique_ptr<Stepper> stepper_;
  std::size_t dimension_;
  std::int64_t steps_, each_ = 1;
  std::vector<double> times_, places_;
};

std::vector<Triple> places_at_start(const Course& course) {
  std::vector<Triple> list;
  for (std::uint32_t b = 0; b < course.balls(); ++b) list.push_back(course.at(b, -HUGE_VAL).position);
  return list;
}

}  // namespace

PlannedRow plan_view_steps(const std::string& text, const Scene& scene) {
  const std::size_t comma = text.find(',');
  const std::string dt = text.substr(0, comma), method = comma == std::string::npos ? "discrete" : text.substr(comma + 1);
  std::vector<Problem> problems;
  std::vector<PlannedRow> rows =
      plan_comparison(dt, is_engine(method) ? "" : method, is_engine(method) ? method : "", problems);
  if (problems.empty() && rows.size() != 1)
    problems.push_back(
        {"", 0, "--compare " + text, "it has the form DT or DT,METHOD", "For instance --compare 0.01,discrete"});
  if (problems.empty()) problems = judge_comparison(scene, rows);
  if (!problems.empty()) throw InputError(std::move(problems));
  if (scene.run.until) static_cast<void>(steps_until(*scene.run.until, scene, rows.front().dt));
  return std::move(rows.front());
}

ViewSteps make_view_steps(const Scene& scene, const PlannedRow& row, const Course& course, double end,
                          const std::vector<std::int64_t>& event_of, const std::atomic<bool>& interrupt) {
  const double dt = row.dt;
  ComparisonSettings settings;
  settings.dt = dt;
  settings.steps = steps_until(end, scene, dt);
  settings.delay = row.delay;
  settings.interrupt = &interrupt;
  const std::unique_ptr<Stepper> stepper = row.make(scene);
  const Comparison judged =
      carom::compare(course, Enclosures(scene, course.subject(), places_at_start(course)), *stepper, settings);

  const double until = std::min(judged.diverged_at.value_or(judged.time), judged.time - 2 * dt - row.delay);
  Filming film(scene, row, settings.steps);
  const auto answers = film.run(until + 2 * dt + row.delay, interrupt);
  const std::string& name = row.engine.empty() ? row.method : row.engine;
  return {
      {{"method", name},
       {"dt", row.dt.value},
       {"steps", settings.steps},
       {"steps_a_frame", film.each()},
       {"frames", film.frames()},
       {"missed", missed_events(course.meetings(), answers, until, event_of)},
       {"collisions", judged.collisions},
       {"tally", {{"missed", judged.tally.missed}, {"spurious", judged.tally.spurious}, {"swapped", judged.tally.swapped}}},
       {"escaped", judged.escaped},
       {"energy_error", judged.energy_error},
       {"parted_at", judged.diverged_at ? Json(*judged.diverged_at) : Json(nullptr)}},
      film.bytes()};
}

}  // namespace carom::app
