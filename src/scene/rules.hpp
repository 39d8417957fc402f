#pragma once
// What a scene may hold, whoever made it: each breach with the path of its key.

#include <string>
#include <vector>

#include "carom/scene/scene.hpp"
#include "path.hpp"

namespace carom::scene_text {

struct Finding {
  std::vector<Path> keys;  ///< the key at fault, then those that it was judged by
  Where where;             ///< of the table
  std::string what, why, hint;
};

[[nodiscard]] std::vector<Finding> findings(const Scene& scene);

}  // namespace carom::scene_text
