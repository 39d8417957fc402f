#pragma once
// Keys that carom documents and this version cannot run yet: refused by name, never ignored.

#include <string>
#include <string_view>

namespace carom::scene_text {

/// True if `key` (dotted, without indices: "wall.kind") is refused whatever its value, or with this value.
[[nodiscard]] bool is_unbuilt(std::string_view key, std::string_view value = {});

/// `key wall.kind = "arc": not built yet`.
[[nodiscard]] std::string unbuilt_message(std::string_view key, std::string_view value = {});

inline constexpr std::string_view unbuilt_reason = "documented, but this version of carom cannot run it";

}  // namespace carom::scene_text
