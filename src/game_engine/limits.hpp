#pragma once
// What an engine does not have, or only approximates, in a scene that is laid out for it.

#include <cstddef>
#include <string>
#include <vector>

#include "layout.hpp"

namespace carom::game_engine {

/// Why engine `number` cannot be given this scene at all.
[[nodiscard]] std::vector<std::string> refusals(const Layout& layout, std::size_t number);

/// What it does in other ways than carom.
[[nodiscard]] std::vector<std::string> approximations(const Layout& layout, std::size_t number);

}  // namespace carom::game_engine
