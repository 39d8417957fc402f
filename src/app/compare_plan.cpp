#include "compare_plan.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/core.h>

#include "carom/game_engine/game_engine.hpp"
#include "carom/scene/growing.hpp"
#include "carom/sim/fixed_step.hpp"

namespace carom::app {

namespace {

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> words(1);
  for (const char c : list) {
    if (c == ',') {
      words.emplace_back();
    } else if (c != ' ') {
      words.back() += c;
    }
  }
  return words;
}

/// Adds the problems of an InputError, each with the word that it is about; one that is there already is not repeated.
void add(std::vector<Problem>& problems, const InputError& error, const std::string& about = "") {
  for (Problem p : error.problems()) {
    if (!about.empty()) p.what = about + ": " + p.what;
    const auto same = [&](const Problem& q) { return q.text() == p.text(); };
    if (std::none_of(problems.begin(), problems.end(), same)) problems.push_back(std::move(p));
  }
}

std::vector<Number> read_steps(const std::string& list, std::vector<Problem>& problems) {
  std::vector<Number> steps;
  for (const std::string& word : split(list)) {
    const std::string what = "--dt " + (word.empty() ? "(empty)" : word);
    try {
      const Number dt = parse_number(word);
      if (!(dt > 0) || !std::isfinite(dt.value)) {
        problems.push_back({"", 0, what, "a time step is above 0 and finite", ""});
      } else {
        steps.push_back(dt);
      }
    } catch (const std::invalid_argument&) {
      problems.push_back({"", 0, what + " is no number", "", "Steps are listed with commas: --dt 1e-2,1e-3"});
    } catch (const std::out_of_range&) {
      problems.push_back({"", 0, what + " is beyond the range of double precision", "", ""});
    }
  }
  return steps;
}

/// How late the method reports a contact: "penalty" after it has ended, or after twice its duration.
double delay_of(const StepMethodOptions& method, double dt) {
  const auto* soft = std::get_if<PenaltyOptions>(&method);
  return soft == nullptr ? 0.0 : 2 * soft->contact_time.value_or(soft->steps * dt);
}

PlannedRow row_of(const StepMethodOptions& method, const Number& dt) {
  return {step_method_text(method), "", dt, delay_of(method, dt),
          [=](const Scene& scene) { return make_stepper(scene, {.dt = dt, .method = method}); }};
}

PlannedRow row_of(GameEngineOptions options, const Number& dt) {
  options.dt = dt;
  return {"", game_engine_text(options), dt, 0.0, [=](const Scene& scene) { return make_game_engine(scene, options); }};
}

/// The known engine of that name is part of this carom.
void judge_built(const GameEngineOptions& options, std::vector<Problem>& problems) {
  for (const GameEngine& engine : game_engines())
    if (engine.name == options.engine && !engine.built)
      problems.push_back({"", 0, "--engine " + engine.name + ": this carom was built without it", "",
                          "Install the Debian package " + engine.package + " and build carom again"});
}

}  // namespace

std::vector<PlannedRow> plan_comparison(const std::string& dt, const std::string& methods, const std::string& engines,
                                        std::vector<Problem>& problems) {
  const std::vector<Number> steps = read_steps(dt, problems);
  std::vector<PlannedRow> rows;
  const auto add_rows = [&](const std::string& option, const std::string& word, auto&& parse) {
    try {
      const auto options = parse(word);
      for (const Number& step : steps) rows.push_back(row_of(options, step));
    } catch (const InputError& error) {
      add(problems, error, option);
    }
  };
  std::vector<std::string> names = step_method_names();
  if (!methods.empty()) names = split(methods);
  if (!methods.empty() || engines.empty())
    for (const std::string& word : names)
      add_rows("--method", word, [](const std::string& w) { return parse_step_method(w); });
  if (!engines.empty())
    for (const std::string& word : split(engines))
      add_rows("--engine", word, [&](const std::string& w) {
        GameEngineOptions options = parse_game_engine(w);
        judge_built(options, problems);
        return options;
      });
  return rows;
}

std::vector<Problem> judge_comparison(const Scene& scene, const std::vector<PlannedRow>& rows) {
  std::vector<Problem> problems;
  if (scene.collision.law != LawKind::restitution)
    problems.push_back({scene.file, scene.collision.where.line, "compare needs the law \"restitution\"",
                        "balls that stay together have no course of their own to compare with", ""});
  if (balls_grow(scene))
    problems.push_back({scene.file, 0, "compare has no balls that grow", "time steps and engines keep the radii",
                        "Leave out radius_growth"});
  for (const PlannedRow& row : rows) {
    try {
      row.make(scene);
    } catch (const InputError& error) {
      add(problems, error);
    }
  }
  return problems;
}

}  // namespace carom::app
