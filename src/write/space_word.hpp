#pragma once
// The word of a scene file for a kind of space.

#include <string_view>

#include "carom/scene/scene.hpp"

namespace carom {

[[nodiscard]] constexpr std::string_view space_word(SpaceKind kind) noexcept {
  switch (kind) {
    case SpaceKind::open:
      return "open";
    case SpaceKind::box:
      return "box";
    case SpaceKind::periodic:
      return "periodic";
  }
  return "";
}

}  // namespace carom
