#include "sweep_row.hpp"

#include <optional>
#include <utility>

#include "carom/core/error.hpp"
#include "carom/observe/observers.hpp"
#include "carom/observe/samplers.hpp"
#include "carom/observe/survival.hpp"
#include "carom/sim/simulation.hpp"
#include "run_to_the_end.hpp"
#include "write/summary_object.hpp"

namespace carom::app {

namespace {

constexpr std::int64_t most_attempts = 10'000;  // to place balls where the start is not refused

struct Started {
  Ensemble::Member member;
  Simulation simulation;
};

/// A place that is drawn may overlap something: then the next one is drawn.
Started start(const SweepPlan& plan, std::int64_t run, Ensemble::Member& made) {
  for (std::int64_t attempt = 0;; ++attempt) {
    made = plan.ensemble().member(run, attempt);
    try {
      Simulation simulation(made.scene, plan.precision());
      return {std::move(made), std::move(simulation)};
    } catch (const InputError&) {
      if (!plan.ensemble().places() || attempt + 1 == most_attempts) throw;
    }
  }
}

/// Numbers, strings and arrays of them as they are; what JSON does not know as its TOML text.
Json value_of(const std::string& toml) {
  Json value = Json::parse(toml, nullptr, false);
  return value.is_discarded() ? Json(toml) : value;
}

Json set_object(const std::vector<Override>& set) {
  Json j = Json::object();
  for (const Override& o : set) j[o.key] = value_of(o.value);
  return j;
}

std::string text_of(const std::vector<Problem>& problems) {
  std::string s;
  for (const Problem& p : problems) s += (s.empty() ? "" : "; ") + p.text();
  return s;
}

std::optional<Json> carried_out(const SweepPlan& plan, Started& started, const std::atomic<bool>& interrupt) {
  Simulation& simulation = started.simulation;
  const Scene& scene = started.member.scene;
  Observers observers(scene, simulation);
  Samplers samplers(scene, simulation);
  const Survival survival(scene, simulation);
  Watchers watchers;
  watchers.collision = observers.sink();
  if (samplers.any()) watchers.samplers = &samplers;
  watchers.interrupt = &interrupt;
  run_to_the_end(simulation, scene.run, watchers);
  observers.end(simulation);
  const Summary s = simulation.summary();
  if (s.stopped_by == Stop::interrupted) return std::nullopt;

  Estimates observed = observers.estimates();
  for (Estimate& e : samplers.estimates()) observed.push_back(std::move(e));
  for (Estimate& e : survival.estimates(simulation)) observed.push_back(std::move(e));
  Json j{{"outcome", s.stopped ? "stopped" : "done"}, {"stopped_by", word(s.stopped_by)}, {"time", s.time}};
  j["events"] = events_object(s.events);
  j["energy"] = {{"initial", s.energy.initial}, {"final", s.energy.final}, {"dissipated", s.energy.dissipated},
                 {"injected", s.energy.injected}, {"relative_error", s.energy.relative_error}};
  j["exactness"] = {{"max_gap_error", s.exactness.max_gap_error}, {"clamped", s.exactness.clamped},
                    {"unresolved", s.exactness.unresolved}, {"singular", s.exactness.singular}};
  if (!observed.empty()) j["observed"] = observed_object(observed);
  if (plan.wants_final()) j["final"] = final_object(simulation.balls());
  if (s.stopped) j["reason"] = s.stopped->reason;
  return j;
}

}  // namespace

std::optional<std::string> sweep_row(const SweepPlan& plan, std::int64_t run, const std::atomic<bool>& interrupt) {
  Json row{{"run", run}, {"combination", run % plan.ensemble().combinations()}};
  Ensemble::Member made;
  try {
    Started started = start(plan, run, made);
    row["set"] = set_object(started.member.set);
    const std::optional<Json> result = carried_out(plan, started, interrupt);
    if (!result) return std::nullopt;
    row.update(*result);
  } catch (const InputError& error) {
    if (made.set.empty()) made.set = plan.ensemble().listed(run % plan.ensemble().combinations());
    if (!row.contains("set")) row["set"] = set_object(made.set);
    row["outcome"] = "refused";
    row["reason"] = text_of(error.problems());
  }
  return json_line(row);
}

}  // namespace carom::app
