#include "explain_command.hpp"

#include <fmt/core.h>

#include "carom/game_engine/game_engine.hpp"
#include "carom/scene/ensemble.hpp"
#include "carom/scene/tables.hpp"
#include "carom/sim/simulation.hpp"
#include "carom/write/number_text.hpp"
#include "model.hpp"
#include "write/json_text.hpp"

namespace carom::app {

namespace {

std::string space_text(const SpaceSpec& space) {
  switch (space.kind) {
    case SpaceKind::open:
      return "open";
    case SpaceKind::box:
      return "a box with reflecting faces";
    case SpaceKind::periodic:
      return "periodic";
  }
  return "";
}

/// Sentences of a list stand without a full stop.
std::vector<std::string> without_stops(std::vector<std::string> sentences) {
  for (std::string& s : sentences)
    if (s.ends_with('.')) s.pop_back();
  return sentences;
}

Json engines(const Scene& scene) {
  Json list = Json::array();
  for (const GameEngine& e : game_engines())
    list.push_back({{"name", e.name},
                    {"version", e.built ? Json(e.version) : Json(nullptr)},
                    {"package", e.package},
                    {"not_represented", without_stops(cannot_represent(scene, e.name))}});
  return list;
}

Json facts(const Scene& scene, const Simulation& simulation) {
  const Composition& c = simulation.composition();
  const double epoch = simulation.epoch_length();
  return {{"title", scene.title},
          {"dimension", scene.dimension},
          {"space", space_text(scene.space)},
          {"balls", simulation.summary().balls},
          {"walls", simulation.wall_count()},
          {"tables", tables_explained(scene)},
          {"ensemble", without_stops(ensemble_explained(scene))},
          {"composition", {{"motion", c.motion}, {"search", c.search}, {"queue", c.queue}, {"reasons", c.reasons}}},
          {"precision", "double"},
          {"epoch_length", hex_text(epoch)},
          {"time_resolution", epoch * 0x1p-53},
          {"collisions", collision_rules(scene)},
          {"not_modelled", not_modelled(scene)},
          {"limits", limits(scene)},
          {"not_by_steps", limits_of_steps(scene, simulation.balls())},
          {"engines", engines(scene)}};
}

void print_list(std::ostream& out, const char* heading, const Json& sentences) {
  out << '\n' << heading << '\n';
  for (const Json& s : sentences) out << "  - " << s.get<std::string>() << '\n';
}

void print(std::ostream& out, const Json& f, double epoch) {
  const std::string title = f["title"];
  if (!title.empty()) out << title << "\n\n";
  const auto row = [&out](const char* label, const std::string& value) {
    out << fmt::format("  {:<13}{}\n", label, value);
  };
  const auto word = [&f](const char* key) { return f["composition"][key].get<std::string>(); };
  row("scene", fmt::format("{} balls and {} walls in {}-D; space: {}", f["balls"].get<std::int64_t>(),
                           f["walls"].get<std::int64_t>(), f["dimension"].get<int>(), f["space"].get<std::string>()));
  row("motion", word("motion"));
  row("search", word("search"));
  row("queue", word("queue"));
  row("units", "the scene's own; carom never converts");
  row("clock", fmt::format("epochs of {} = {}, in steps of {:.3g}", f["epoch_length"].get<std::string>(),
                           number_text(epoch), f["time_resolution"].get<double>()));
  if (!f["tables"].empty()) print_list(out, "Tables", f["tables"]);
  if (!f["ensemble"].empty()) print_list(out, "Ensemble", f["ensemble"]);
  print_list(out, "Why", f["composition"]["reasons"]);
  print_list(out, "Collisions", f["collisions"]);
  print_list(out, "Not modelled", f["not_modelled"]);
  print_list(out, "Limits", f["limits"]);
  print_list(out, "Not given by time steps (carom compare)", f["not_by_steps"]);
  for (const Json& e : f["engines"]) {
    const std::string name = e["name"];
    const std::string built = e["version"].is_null() ? ", not built: needs " + e["package"].get<std::string>()
                                                     : " " + e["version"].get<std::string>();
    print_list(out, ("Not represented by " + name + built).c_str(), e["not_represented"]);
  }
}

}  // namespace

CLI::App* add_explain_command(CLI::App& program, ExplainOptions& options) {
  CLI::App* command =
      program.add_subcommand("explain", "Says what is composed for a scene and why, and what is not modelled");
  add_scene_arguments(*command, options.scene);
  command->add_flag("--json", options.json, "Prints one JSON object");
  command->footer("Example:\n  carom explain scene.toml --set collision.restitution=0.9");
  return command;
}

ExitStatus explain(const ExplainOptions& options, const Console& console) {
  const Scene scene = read_scene(options.scene);
  const Simulation simulation(scene);
  const Json f = facts(scene, simulation);
  if (options.json) {
    console.out << json_text(f);
  } else {
    print(console.out, f, simulation.epoch_length());
  }
  return ExitStatus::done;
}

}  // namespace carom::app
