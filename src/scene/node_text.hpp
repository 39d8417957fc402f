#pragma once
// A TOML value as text that reads back the same, its numbers as they were written.

#include <string>

#include "report.hpp"

namespace carom::scene_text {

[[nodiscard]] std::string node_text(Report& report, const toml::node& node);

}  // namespace carom::scene_text
