#pragma once
// The place of a key in a scene: its dotted path, as --set takes it ("ball.0.velocity").

#include <set>
#include <string>
#include <vector>

namespace carom::scene_text {

using Path = std::vector<std::string>;

/// "ball.0.velocity"; a part that is no bare TOML key is quoted.
[[nodiscard]] std::string dotted(const Path& path);

/// The path with `part` at its end.
[[nodiscard]] Path operator/(Path path, std::string part);

/// True if `set` holds `path`, a table that it is in, or something inside it.
[[nodiscard]] bool touches(const std::set<Path>& set, const Path& path);

}  // namespace carom::scene_text
