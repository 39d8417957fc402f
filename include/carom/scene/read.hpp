#pragma once
// From the text of a scene file to a Scene: syntax, keys, types and ranges.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "carom/scene/scene.hpp"

namespace carom {

/// One `--set KEY=VALUE`: a dotted path ("ball.0.velocity") and a TOML value ("[1, 0]").
struct Override {
  std::string key;
  std::string value;
};

/// Reads a scene file. Throws InputError with every problem of syntax, type, key and range, each with its line.
[[nodiscard]] Scene read_scene_file(const std::string& path, const std::vector<Override>& overrides = {});

/// The same from text; `file` is what messages call it.
[[nodiscard]] Scene read_scene(std::string_view text, const std::string& file, const std::vector<Override>& overrides = {});

}  // namespace carom
