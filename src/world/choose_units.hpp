#pragma once
// The units of a world: powers of two near the scene's smallest length, fastest crossing and lightest ball.

#include <vector>

#include "carom/core/error.hpp"
#include "carom/scene/scene.hpp"
#include "carom/world/units.hpp"
#include "roster.hpp"

namespace carom {

/// Speeds may be smaller than the fastest by 2^800: 2^-400 and 2^400 may stand in one scene [papers/clock.md].
inline constexpr int speed_range = 800;

/// Units of the scene; appends a problem for each value that lies beyond 2^+-exponent_range of them, and for each velocity
/// that is not 0 and smaller than the fastest by more than 2^speed_range.
[[nodiscard]] Units choose_units(const Scene& scene, const Roster& roster, std::vector<Problem>& problems);

}  // namespace carom
