#pragma once
// What a scene models, in sentences: its restitution, what it leaves out, and how far its results can be trusted.

#include <string>
#include <vector>

#include "carom/scene/scene.hpp"
#include "carom/sim/summary.hpp"

namespace carom::app {

[[nodiscard]] std::vector<std::string> collision_rules(const Scene& scene);
[[nodiscard]] std::vector<std::string> not_modelled(const Scene& scene);
[[nodiscard]] std::vector<std::string> limits(const Scene& scene);

/// What the fixed-step mode does not give in this scene. `start`: its balls at the start.
[[nodiscard]] std::vector<std::string> limits_of_steps(const Scene& scene, const std::vector<BallState>& start);

}  // namespace carom::app
