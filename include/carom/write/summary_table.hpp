#pragma once
// The result of a run for people: a few aligned lines.

#include <string>

#include "carom/write/run_report.hpp"

namespace carom {

enum class Colour : bool { off, on };

/// Units are the scene's. `final`, if it is there, is shown as a table.
[[nodiscard]] std::string summary_table(const RunReport& report, Colour colour = Colour::off);

}  // namespace carom
