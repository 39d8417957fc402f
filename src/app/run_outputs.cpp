#include "run_outputs.hpp"

#include <filesystem>
#include <system_error>

#include "carom/core/error.hpp"

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

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error))
    throw OutputError("cannot make the folder \"" + folder.string() + "\": " +
                      (error ? error.message() : std::string("something else has that name")) + ". Choose another --out.");
}

}  // namespace

RunOutputs::RunOutputs(const Scene& scene, const std::string& folder, const Simulation& simulation) {
  const OutputSpec& output = scene.output;
  const fs::path events = place(scene, folder, output.events, "output.events");
  const fs::path trajectory = place(scene, folder, output.trajectory, "output.trajectory");
  if (!output.events.empty() && events.lexically_normal() == trajectory.lexically_normal())
    throw InputError(Problem{scene.file, output.where.line, "output.events and output.trajectory are one file", "", ""});
  if (!folder.empty()) make_folder(folder);
  if (!output.events.empty()) events_.emplace(events.string(), simulation, scene.title);
  if (!output.trajectory.empty()) trajectory_.emplace(trajectory.string(), simulation, scene.title);
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
  return problems;
}

}  // namespace carom::app
