#pragma once
// What can be judged of a scene without geometry: ranges, dimensions, names, what is not supported together.

#include <vector>

#include "carom/core/error.hpp"
#include "carom/scene/scene.hpp"

namespace carom {

/// Every problem found; empty if the scene may be built. A scene made in code is judged by the same rules as a file.
[[nodiscard]] std::vector<Problem> validate(const Scene& scene);

}  // namespace carom
