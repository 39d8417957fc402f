#pragma once
// --set: puts values into the parsed scene, by dotted path, before it is read.

#include "report.hpp"

namespace carom::scene_text {

/// Sets every override in its order. A path that leads nowhere is a problem that names the override.
void apply_overrides(toml::table& scene, Report& report);

}  // namespace carom::scene_text
