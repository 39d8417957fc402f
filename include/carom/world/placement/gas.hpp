#pragma once
// Balls at random places without overlap, at any density of a fluid.

#include <span>
#include <vector>

#include "carom/world/placement/region.hpp"

namespace carom {

/// Places the [[gas]] entries of a scene together, beside the obstacles. No two balls overlap or touch, nor a ball and a
/// face. Where the region is open, the first entry with radius and packing_fraction sets it: a periodic cube, square or
/// line from 0. In one dimension without walls: a sample of the equilibrium (Tonks) gas. Else random sequential insertion
/// [Widom1966], above its reach with smaller balls, whose overlaps at full size are then pushed apart. The result depends
/// on the entries (their seeds) and the places of obstacles and walls alone. Throws InputError (line of the entry, no file)
/// with all problems, and if the balls cannot be placed.
[[nodiscard]] std::vector<PlacedBalls> place_gases(std::span<const GasSpec> specs, const Region& region,
                                                   std::span<const Obstacle> obstacles, const ClearOfWalls& clear_of_walls);

}  // namespace carom
