#pragma once
// The units of a world: powers of two near the scene's smallest length, fastest crossing and lightest ball.

#include <vector>

#include "carom/core/error.hpp"
#include "carom/scene/scene.hpp"
#include "carom/world/units.hpp"
#include "roster.hpp"

namespace carom {

/// Units of the scene; appends a problem for each value that lies beyond 2^+-exponent_range of them.
[[nodiscard]] Units choose_units(const Scene& scene, const Roster& roster, std::vector<Problem>& problems);

}  // namespace carom
