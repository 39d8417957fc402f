#pragma once
// By how much the books of a run do not close.

#include "carom/sim/summary.hpp"

namespace carom {

/// final + dissipated - initial - injected, summed in twice the precision and rounded once.
[[nodiscard]] double energy_error(const EnergyBalance& e);

/// The same in units in the last place of the initial energy; nan if that is 0 or not finite.
[[nodiscard]] double energy_error_ulp(const EnergyBalance& e);

}  // namespace carom
