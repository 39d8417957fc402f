#pragma once
// From the tables of a scene file to the structs of a Scene, one function a table.

#include "carom/scene/scene.hpp"
#include "table_reader.hpp"

namespace carom::scene_text {

/// Reads every table of the scene; unknown keys, wrong types and unknown words go to the report.
[[nodiscard]] Scene read_tables(const toml::table& root, Report& report);

[[nodiscard]] EnsembleSpec read_ensemble(TableReader t);

}  // namespace carom::scene_text
