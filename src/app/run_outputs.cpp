#include "run_outputs.hpp"

#include <filesystem>
#include <map>
#include <system_error>

#include "carom/core/error.hpp"
#include "carom/observe/observers.hpp"
#include "carom/observe/samplers.hpp"
#include "carom/observe/survival.hpp"
#include "output_folder.hpp"

namespace carom::app {

namespace fs = std::filesystem;

namespace {

/// The places of files, each a different one.
class Places {
 public:
  Places(const Scene& scene, const std::string& folder) : scene_(scene), folder_(folder) {}

  /// Empty for a file without a name. `key` says what is written there.
  std::string operator()(const std::string& file, const std::string& key) {
    if (file.empty()) return {};
    const fs::path path = folder_.empty() ? fs::path(file) : fs::path(folder_) / file;
    std::error_code ignored;
    if (!scene_.file.empty() && fs::equivalent(path, scene_.file, ignored))
      refuse(key + " is the scene file itself", "it would be overwritten", "Choose another name, or write elsewhere with --out");
    const auto [other, is_new] = keys_.try_emplace(path.lexically_normal().string(), key);
    if (!is_new) refuse(key + " is \"" + file + "\"", other->second + " is written there", "Choose another name");
    return path.string();
  }

 private:
  [[noreturn]] void refuse(std::string what, std::string why, std::string hint) const {
    throw InputError(Problem{scene_.file, scene_.output.where.line, std::move(what), std::move(why), std::move(hint)});
  }

  const Scene& scene_;
  const std::string& folder_;
  std::map<std::string, std::string> keys_;
};

void require_format(const Scene& scene) {
  try {
    if (!scene.output.trajectory.empty()) require_built(scene.output.trajectory);
  } catch (const InputError& error) {
    Problem p = error.problems().front();
    p.file = scene.file;
    p.line = scene.output.where.line;
    p.what = "output.trajectory = " + p.what;
    throw InputError(p);
  }
}

}  // namespace

RunOutputs::RunOutputs(const Scene& scene, const std::string& folder, const Simulation& simulation,
                       const Provenance& provenance) {
  const OutputSpec& output = scene.output;
  require_format(scene);
  Places place(scene, folder);
  const auto placed = [&](const std::string& file, const std::string& key) {
    std::string path = place(file, key);
    if (!path.empty()) written_.push_back(path);
    return path;
  };
  const std::string events = placed(output.events, "output.events");
  const std::string trajectory = placed(output.trajectory, "output.trajectory");
  const std::string ledger = placed(output.ledger, "output.ledger");
  std::vector<std::pair<std::string, std::string>> tables;  // name, path
  for (const std::string& name : observed_tables(scene.observe))
    tables.emplace_back(name, placed(name + ".csv", "the table of observe." + name));
  for (const std::string& name : final_tables(scene.observe)) tables.emplace_back(name, placed(name + ".csv", "a table of [observe]"));
  for (const auto& [name, file] : survival_files(scene.observe)) tables.emplace_back(name, placed(file, "a table of observe.survival"));
  std::vector<StreamedTable> streamed = streamed_tables(scene);
  for (StreamedTable& table : streamed) table.file = placed(table.file, "the table of observe." + table.name);
  const std::string speeds =
      scene.observe.speed_histogram ? placed("speed_histogram.csv", "the table of observe.speed_histogram") : "";

  if (!folder.empty()) make_folder(folder);
  const TrajectoryHead head = head_of(scene, simulation);
  if (!events.empty()) events_.emplace(events, simulation, scene.title);
  if (!trajectory.empty()) trajectory_ = begin_trajectory(trajectory, head, provenance);
  if (!ledger.empty()) ledger_.emplace(ledger, head);
  for (const auto& [name, path] : tables) tables_.emplace_back(path, simulation, scene.title, name);
  for (const StreamedTable& table : streamed) streams_.emplace_back(table, simulation, scene.title);
  if (!speeds.empty()) speeds_.emplace(speeds, simulation, scene.title);
}

void RunOutputs::frame(const Simulation& simulation) {
  const bool books = ledger_ || (trajectory_ && trajectory_->books() == Books::kept);
  const TrajectoryFrame frame = frame_of(simulation, books ? Books::kept : Books::left_out);
  if (trajectory_) trajectory_->write(frame);
  if (ledger_) ledger_->write(frame);
}

bool RunOutputs::failed() const {
  return (events_ && events_->failed()) || (trajectory_ && trajectory_->failed()) || (ledger_ && ledger_->failed());
}

std::string RunOutputs::finish(const Summary& summary) {
  std::string problems;
  const auto end = [&](auto& file, const auto& ending) {
    try {
      file.finish(ending);
    } catch (const OutputError& error) {
      problems += (problems.empty() ? "" : "\n") + std::string(error.what());
    }
  };
  if (events_) end(*events_, summary.stopped_by);
  if (trajectory_) end(*trajectory_, Ending{std::string(word(summary.stopped_by)), summary});
  if (ledger_) end(*ledger_, summary.stopped_by);
  if (speeds_) end(*speeds_, summary.stopped_by);
  for (TableCsv& table : tables_) end(table, summary.stopped_by);
  for (Stream& stream : streams_) end(stream.file, summary.stopped_by);
  return problems;
}

}  // namespace carom::app
