#pragma once
// How long a ball of a gas flies freely, before anything was measured.

#include "carom/observe/subject.hpp"

namespace carom {

/// Mean free time [time] of Enskog's theory for balls of the mean diameter and mass:
///   1/tau = omega n sigma^(d-1) g sqrt(kT/(pi m)),  omega = 2, 2 pi, 4 pi in 1, 2, 3-D
/// with g of Tonks, 1/(1 - eta); of Henderson, (1 - 7 eta/16)/(1 - eta)^2 [Henderson1975]; of Carnahan and Starling,
/// (1 - eta/2)/(1 - eta)^3 [CarnahanStarling1969]. Good to a few per cent in a fluid. NaN: an open space, points or balls at
/// rest.
[[nodiscard]] double enskog_free_time(const Subject& subject);

/// Area of the unit sphere in d dimensions: 2, 2 pi, 4 pi.
[[nodiscard]] double sphere_area(int dimension);

}  // namespace carom
