#pragma once
// The scene as a page shows it: geometry, rules in sentences, the text of its file.

#include "carom/write/replay_log.hpp"
#include "run_record.hpp"
#include "write/json_text.hpp"

namespace carom::app {

/// `simulation` is at the start.
[[nodiscard]] Json scene_of_page(const Scene& scene, const Simulation& simulation, const ReplayLog& log,
                                 const RunRecord& record);

}  // namespace carom::app
