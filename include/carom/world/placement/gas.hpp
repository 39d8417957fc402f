#pragma once
// Balls at random places without overlap, at any density of a fluid.

#include <span>
#include <vector>

#include "carom/world/placement/region.hpp"

namespace carom {

/// Places the [[gas]] entries of a scene together, beside the obstacles. No two balls overlap or touch, nor a ball and a
/// face. Where the region is open, the first entry with radius and packing_fraction sets it: a periodic cube, square or
/// line from 0. In one dimension without walls: a sample of the equilibrium (Tonks) gas. Else random sequential insertion
/// [Widom1966], above its reach with smaller balls, whose overlaps at full size are then pushed apart. Except on the line such
/// a start is disordered but not in equilibrium: let a gas run for some tens of collisions a ball before it is measured, a
/// dense one for hundreds (observe.after). At 10^6 spheres of packing 0.49 placing takes 7 s and 240 bytes a ball, all
/// but the state given back (`carom bench --balls 1000000 --packing 0.49` shows the whole start). The result depends
/// on the entries (their seeds) and the places of obstacles and walls alone. Throws InputError (line of the entry, no file)
/// with all problems, and if the balls cannot be placed.
[[nodiscard]] std::vector<PlacedBalls> place_gases(std::span<const GasSpec> specs, const Region& region,
                                                   std::span<const Obstacle> obstacles, const ClearOfWalls& clear_of_walls);

}  // namespace carom
