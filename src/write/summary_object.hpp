#pragma once
// The result of a run as JSON, to stand alone or inside something larger.

#include "carom/write/run_report.hpp"
#include "json_text.hpp"

namespace carom {

/// `observed`: a dot in a name goes one level down.
[[nodiscard]] Json observed_object(const Estimates& estimates);

/// `final`: the balls that are left.
[[nodiscard]] Json final_object(const std::vector<BallState>& balls);

/// `events`: how many of each kind.
[[nodiscard]] Json events_object(const EventCounts& counts);

/// The object of `carom run --json`.
[[nodiscard]] Json summary_object(const RunReport& report);

}  // namespace carom
