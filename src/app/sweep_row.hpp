#pragma once
// One run of a sweep, and the row that it leaves.

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "sweep_plan.hpp"

namespace carom::app {

/// Moves run number `run` to its end. One line of JSON, the same whoever makes it: the run's number and combination, what
/// was set, its outcome ("done"; "stopped": going on would be meaningless; "refused": it has no start), time, counts,
/// energy, exactness, what was observed. None: interrupted. Throws what is a bug.
[[nodiscard]] std::optional<std::string> sweep_row(const SweepPlan& plan, std::int64_t run, const std::atomic<bool>& interrupt);

}  // namespace carom::app
