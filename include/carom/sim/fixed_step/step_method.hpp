#pragma once
// What a fixed-step method is: it takes the balls on by one step and reports the contacts that it found.

#include <concepts>

#include "carom/sim/fixed_step/step_report.hpp"
#include "carom/sim/fixed_step/step_state.hpp"

namespace carom {

/// `step` moves positions and velocities on by state.dt, adds 1 to state.steps and gives each contact to the report. It is
/// made from its options, the state at the start (which stays where it is) and whether to look at every pair.
template <class Method, class Options, int D>
concept StepMethod = std::constructible_from < Method,
        const Options&, StepState<D>
&, bool > &&requires(Method& method, StepState<D>& state, const StepReport& report) { {method.step(state, report)}; };

}  // namespace carom
