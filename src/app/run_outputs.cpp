#include "run_outputs.hpp"

#include <filesystem>
#include <system_error>
#include <tuple>

#include "carom/core/error.hpp"
#include "carom/observe/samplers.hpp"
#include "output_folder.hpp"

namespace carom::app {

namespace fs = std::filesystem;

namespace {

fs::path place(const Scene& scene, const std::string& folder, const std::string& file, const char* key) {
  const fs::path path = folder.empty() ? fs::path(file) : fs::path(folder) / file;
  std::error_code ignored;
  if (!scene.file.empty() && fs::equivalent(path, scene.file, ignored))
    throw InputError(Problem{scene.file, scene.output.where.line, std::string(key) + " is the scene file itself",
                             "it would be overwritten", "Choose another name, or write elsewhere with --out"});
  return path;
}

}  // namespace

RunOutputs::RunOutputs(const Scene& scene, const std::string& folder, const Simulation& simulation) {
  const OutputSpec& output = scene.output;
  const fs::path events = place(scene, folder, output.events, "output.events");
  const fs::path trajectory = place(scene, folder, output.trajectory, "output.trajectory");
  if (!output.events.empty() && events.lexically_normal() == trajectory.lexically_normal())
    throw InputError(Problem{scene.file, output.where.line, "output.events and output.trajectory are one file", "", ""});
  std::vector<std::string> tables = observed_tables(scene.observe);
  if (scene.observe.speed_histogram) tables.emplace_back("speed_histogram");
  for (std::string& name : tables) {
    const fs::path path = place(scene, folder, name + ".csv", ("the table of observe." + name).c_str());
    for (const auto& [file, other, key] : {std::tuple(output.events, events, "output.events"),
                                           std::tuple(output.trajectory, trajectory, "output.trajectory")})
      if (!file.empty() && other.lexically_normal() == path.lexically_normal())
        throw InputError(Problem{scene.file, output.where.line, std::string(key) + " is " + name + ".csv",
                                 "observe." + name + " writes that file", "Choose another name"});
  }
  if (!folder.empty()) make_folder(folder);
  if (!output.events.empty()) events_.emplace(events.string(), simulation, scene.title);
  if (!output.trajectory.empty()) trajectory_.emplace(trajectory.string(), simulation, scene.title);
  for (const std::string& name : tables) {
    const std::string path = place(scene, folder, name + ".csv", name.c_str()).string();
    if (name == "speed_histogram") {
      speeds_.emplace(path, simulation, scene.title);
    } else {
      tables_.emplace_back(path, simulation, scene.title, name);
    }
  }
}

std::string RunOutputs::finish(Stop stopped_by) {
  std::string problems;
  const auto end = [&](auto& file) {
    try {
      file.finish(stopped_by);
    } catch (const OutputError& error) {
      problems += (problems.empty() ? "" : "\n") + std::string(error.what());
    }
  };
  if (events_) end(*events_);
  if (trajectory_) end(*trajectory_);
  if (speeds_) end(*speeds_);
  for (TableCsv& table : tables_) end(table);
  return problems;
}

}  // namespace carom::app
