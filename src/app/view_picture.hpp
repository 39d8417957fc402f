#pragma once
// A still picture of a run, as SVG: the balls at one moment, and the paths that led them there.

#include <string>
#include <string_view>

#include "write/json_text.hpp"

namespace carom::app {

/// `scene` and `start` as the page gets them, `chunk` the first of the log (empty: nothing happened), `end` the run's last
/// moment. Walls are drawn in two dimensions only; three are seen from a corner, one has time downwards.
[[nodiscard]] std::string picture_of(const Json& scene, std::string_view start, std::string_view chunk, double end);

}  // namespace carom::app
