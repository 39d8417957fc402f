#pragma once
// Walls of two dimensions as paths of a picture: straight pieces, and curves in steps too short to see.

#include <array>
#include <vector>

#include "carom/write/replay_log.hpp"
#include "write/json_text.hpp"

namespace carom::app {

using Place = std::array<double, 2>;

/// From the beginning of a wall to its end; of a closed one the first point comes last again. None of a plane. `wall` is an
/// entry of `walls` in the page's scene.
[[nodiscard]] std::vector<Place> wall_points(const Json& wall);

/// The closed outlines that segments and arcs of one table make.
[[nodiscard]] std::vector<std::vector<Place>> table_outlines(const Json& walls);

/// The shifts by whole periods that bring the points into the cell of a periodic space; else none but zero.
[[nodiscard]] std::vector<Place> shifts_into(const Json& space, const std::vector<Place>& points);

}  // namespace carom::app
