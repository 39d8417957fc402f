#pragma once
// The rack of a pool table: a triangle of rows of balls behind an apex.

#include "carom/world/placement/region.hpp"

namespace carom {

/// Row j = 0, 1, ... holds j + 1 balls; with s = 2 r + gap and u the direction, w = (-u_y, u_x), ball m of row j is at
///   apex + s (sqrt(3)/2 j u + (m - j/2) w),
/// computed with 50 digits and rounded once.
[[nodiscard]] PlacedBalls place_rack(const LatticeSpec& spec, const Region& region);

}  // namespace carom
