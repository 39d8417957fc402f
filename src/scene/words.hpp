#pragma once
// Words for messages: quoted, listed, and the known word nearest to a misspelt one.

#include <string>
#include <string_view>
#include <vector>

namespace carom::scene_text {

[[nodiscard]] std::string in_quotes(std::string_view word);

/// A TOML string that means `value`: what is no control character stands for itself.
[[nodiscard]] std::string toml_string(const std::string& value);

/// `"a", "b" or "c"`.
[[nodiscard]] std::string listed(const std::vector<std::string_view>& words);

/// `Did you mean "velocity"?` if a known word is near enough, else `Known: "a", "b" or "c"`.
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string_view>& known);

}  // namespace carom::scene_text
