#pragma once
// What a run was, kept beside its files, so that the folder alone is enough to make it again.

#include <optional>
#include <string>
#include <vector>

#include "scene_arguments.hpp"

namespace carom::app {

/// A scene file, and all that was set over it as KEY=VALUE.
struct RunRecord {
  std::string file, text;
  std::vector<std::string> set;
};

[[nodiscard]] RunRecord record_of(const SceneArguments& arguments);

/// run.json in `folder`. Throws OutputError.
void write_run_record(const std::string& folder, const RunRecord& record);

/// None if the folder has none. Throws InputError.
[[nodiscard]] std::optional<RunRecord> read_run_record(const std::string& folder);

/// Throws InputError.
[[nodiscard]] Scene read_scene(const RunRecord& record);

}  // namespace carom::app
