#pragma once
// The result of a run as JSON, to stand alone or inside something larger.

#include "carom/write/run_report.hpp"
#include "json_text.hpp"

namespace carom {

/// The object of `carom run --json`.
[[nodiscard]] Json summary_object(const RunReport& report);

}  // namespace carom
