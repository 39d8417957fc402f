#pragma once
// Balls on a lattice that fills the space, and the rack of a pool table.

#include "carom/world/placement/region.hpp"

namespace carom {

/// Largest ratio of the stretches along two axes that still counts as the lattice asked for.
inline constexpr double lattice_distortion = 2.0;

/// Places spec.count balls. The lattice is stretched along the axes to fill the region; of all its shapes with this count
/// the least distorted is taken. In a box every ball lies inside the faces; in a periodic cell the pattern goes on across
/// them. Two balls may touch. The radius follows from packing_fraction where none is given. A rack's positions are each the
/// double nearest to the exact one, so that touching balls touch to rounding. Throws InputError (line of the spec, no
/// file): the count does not fit, the balls overlap, or the spec does not suit the space.
[[nodiscard]] PlacedBalls place_lattice(const LatticeSpec& spec, const Region& region);

}  // namespace carom
