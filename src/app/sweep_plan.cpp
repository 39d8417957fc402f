#include "sweep_plan.hpp"

#include <algorithm>
#include <utility>

#include "carom/core/error.hpp"
#include "carom/scene/validate.hpp"
#include "run_record.hpp"

namespace carom::app {

namespace {

SceneSource source_of(const SweepOptions& options) {
  static_cast<void>(read_scene(options.scene));  // says what is wrong in the user's words
  const RunRecord record = record_of(options.scene);
  SceneSource source{record.text, record.file, {}};
  for (const std::string& set : record.set) {
    const std::size_t equals = set.find('=');
    source.set.push_back({set.substr(0, equals), set.substr(equals + 1)});
  }
  return source;
}

/// That of the scene, and what the command line says over it: a key of both is varied as the command line says.
EnsembleSpec spec_of(const SweepOptions& options) {
  Scene scene = read_scene(options.scene);
  EnsembleSpec spec = scene.ensemble.value_or(EnsembleSpec{});
  for (const std::string& text : options.vary) {
    VarySpec v = parse_vary(text);
    const auto same = std::find_if(spec.vary.begin(), spec.vary.end(), [&](const VarySpec& w) { return w.key == v.key; });
    if (same != spec.vary.end()) {
      *same = std::move(v);
    } else {
      spec.vary.push_back(std::move(v));
    }
  }
  if (options.count) spec.count = options.count;
  if (options.seed) spec.seed = *options.seed;
  if (options.zip) spec.combine = Combine::zip;
  scene.ensemble = spec;
  if (std::vector<Problem> problems = validate(scene); !problems.empty()) throw InputError(std::move(problems));
  return spec;
}

Json print_of(const VarySpec& v) {
  Json j{{"key", v.key}};
  if (!v.values.empty()) j["values"] = v.values;
  if (v.from) j["from"] = v.from->value;
  if (v.to) j["to"] = v.to->value;
  if (v.steps > 0) j["steps"] = v.steps;
  return j;
}

/// Messages name what the user wrote: a value of the first run stands for --vary.
std::vector<Problem> of_first_run(std::vector<Problem> problems, const EnsembleSpec& spec) {
  for (Problem& p : problems)
    for (const VarySpec& v : spec.vary)
      if (p.what.starts_with("--set " + v.key)) p.what.replace(0, 5, "--vary");
  return problems;
}

}  // namespace

SweepPlan::SweepPlan(const SweepOptions& options)
    : source_(source_of(options)),
      ensemble_(source_, spec_of(options)),
      precision_(parse_precision(options.precision)),
      final_(options.final) {
  try {
    const Scene first = ensemble_.member(0).scene;
    title_ = first.title;
    const OutputSpec& o = first.output;
    names_files_ = !o.events.empty() || !o.trajectory.empty() || !o.ledger.empty() || !o.checkpoint.empty();
  } catch (const InputError& error) {
    throw InputError(of_first_run(error.problems(), ensemble_.spec()));
  }
}

Json SweepPlan::print() const {
  Json set = Json::array(), vary = Json::array();
  for (const Override& o : source_.set) set.push_back(o.key + "=" + o.value);
  const EnsembleSpec& spec = ensemble_.spec();
  for (const VarySpec& v : spec.vary) vary.push_back(print_of(v));
  return {{"carom", CAROM_VERSION},
          {"scene", source_.file},
          {"set", set},
          {"vary", vary},
          {"combine", spec.combine == Combine::zip ? "zip" : "grid"},
          {"seed", spec.seed},
          {"precision", precision_.text()},
          {"final", final_},
          {"text", source_.text}};
}

}  // namespace carom::app
