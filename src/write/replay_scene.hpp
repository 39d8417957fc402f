#pragma once
// What stands still in a replay: the scene as a page draws it, and the balls at the start.

#include <string>

#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"
#include "json_text.hpp"

namespace carom {

/// title, dimension, space {kind, lower, upper}, acceleration, magnetic (cyclotron frequency), law, start, until and events (null: not given), walls as in
/// the scene, wall_labels by number, names {number: name}, balls (how many). `simulation` is at the start.
[[nodiscard]] Json replay_scene(const Scene& scene, const Simulation& simulation);

/// Little-endian f64 for N balls in D dimensions: position[N D] (wrapped), velocity[N D], radius[N], mass[N], fixed[N] (0
/// or 1).
[[nodiscard]] std::string replay_start(const Scene& scene, const Simulation& simulation);

}  // namespace carom
