#pragma once
// A scene as far as it could be read, beside the problems found: read_scene without the throw.

#include <string>
#include <string_view>
#include <vector>

#include "carom/core/error.hpp"
#include "carom/scene/read.hpp"

namespace carom::scene_text {

struct Reading {
  Scene scene;
  std::vector<Problem> problems;
};

[[nodiscard]] Reading read_all(std::string_view text, const std::string& file, const std::vector<Override>& overrides);

}  // namespace carom::scene_text
