#pragma once
// The scenes of examples/, embedded when carom is built.

#include <string_view>
#include <vector>

namespace carom::app {

struct GalleryScene {
  std::string_view name;  ///< of the example's folder
  std::string_view text;  ///< of its scene.toml
};

/// In alphabetical order.
[[nodiscard]] const std::vector<GalleryScene>& gallery();

}  // namespace carom::app
