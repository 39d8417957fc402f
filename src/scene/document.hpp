#pragma once
// A piece of TOML text, a scene file or the value of an override, and the text of the numbers in it.

#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace carom::scene_text {

class Document {
 public:
  explicit Document(std::string text);

  /// Parses; every node's source names `name`. Throws toml::parse_error.
  [[nodiscard]] toml::table parse(std::string_view name) const;

  /// The number or word that starts at a place of the text, as it is written there.
  [[nodiscard]] std::string literal(const toml::source_position& start);

 private:
  std::string text_;
  std::vector<std::size_t> line_starts_;
  // The place found last: literals are asked for from left to right, and a line may be long.
  toml::source_position last_{1, 1};
  std::size_t last_offset_ = 0;
};

}  // namespace carom::scene_text
