#pragma once
// What a scene models, in sentences: its restitution, what it leaves out, and how far its results can be trusted.

#include <string>
#include <vector>

#include "carom/scene/scene.hpp"

namespace carom::app {

[[nodiscard]] std::vector<std::string> collision_rules(const Scene& scene);
[[nodiscard]] std::vector<std::string> not_modelled(const Scene& scene);
[[nodiscard]] std::vector<std::string> limits(const Scene& scene);

}  // namespace carom::app
