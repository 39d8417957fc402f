#pragma once
// What only the event-driven mode can move: fixed steps and game engines refuse it by name.

#include <vector>

#include "carom/core/error.hpp"
#include "carom/scene/scene.hpp"

namespace carom {

[[nodiscard]] inline bool is_magnetic(const Scene& scene) {
  return scene.motion.magnetic && scene.motion.magnetic->value != 0;
}

/// One problem each; empty if fixed steps and game engines can move the scene too.
[[nodiscard]] std::vector<Problem> exact_only(const Scene& scene);

}  // namespace carom
