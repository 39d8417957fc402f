#pragma once
// What the options of a fixed-step method may be.

#include <vector>

#include "carom/core/error.hpp"
#include "carom/sim/fixed_step.hpp"

namespace carom {

/// Every option that is out of its range.
[[nodiscard]] std::vector<Problem> judge_step_method(const StepMethodOptions& method);

}  // namespace carom
