#pragma once
// Whether a scene has balls that grow: what the features that have no place for them ask.

#include <algorithm>

#include "carom/scene/scene.hpp"

namespace carom {

[[nodiscard]] inline bool balls_grow(const Scene& scene) {
  const auto any = [](const auto& specs) {
    return std::any_of(specs.begin(), specs.end(), [](const auto& spec) { return spec.radius_growth.value > 0; });
  };
  return any(scene.balls) || any(scene.lattices) || any(scene.gases);
}

}  // namespace carom
