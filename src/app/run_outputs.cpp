#include "run_outputs.hpp"

#include <filesystem>
#include <system_error>
#include <tuple>

#include "carom/core/error.hpp"
#include "output_folder.hpp"

namespace carom::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* speeds_file = "speed_histogram.csv";

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
  const bool speeds = scene.observe.speed_histogram;
  const fs::path speeds_path = place(scene, folder, speeds ? speeds_file : "", "the table of observe.speed_histogram");
  for (const auto& [file, path, key] : {std::tuple(output.events, events, "output.events"),
                                        std::tuple(output.trajectory, trajectory, "output.trajectory")})
    if (speeds && !file.empty() && path.lexically_normal() == speeds_path.lexically_normal())
      throw InputError(Problem{scene.file, output.where.line, std::string(key) + " is " + speeds_file,
                               "observe.speed_histogram writes that file", "Choose another name"});
  if (!folder.empty()) make_folder(folder);
  if (!output.events.empty()) events_.emplace(events.string(), simulation, scene.title);
  if (!output.trajectory.empty()) trajectory_.emplace(trajectory.string(), simulation, scene.title);
  if (speeds) speeds_.emplace(speeds_path.string(), simulation, scene.title);
}

std::string RunOutputs::finish(Stop stopped_by) {
  std::string problems;
  const auto end = [&](auto& file) {
    if (!file) return;
    try {
      file->finish(stopped_by);
    } catch (const OutputError& error) {
      problems += (problems.empty() ? "" : "\n") + std::string(error.what());
    }
  };
  end(events_);
  end(trajectory_);
  end(speeds_);
  return problems;
}

}  // namespace carom::app
