#pragma once
// The result of a run for programs: one JSON object.

#include <string>

#include "carom/write/run_report.hpp"

namespace carom {

/// The object of `carom run --json`, its keys in a fixed order, ended by a newline. Numbers are the shortest text that
/// reads back the same; what is not finite, not conserved or not defined is null.
[[nodiscard]] std::string summary_json(const RunReport& report);

}  // namespace carom
