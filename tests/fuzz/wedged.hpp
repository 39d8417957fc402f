#pragma once
// Whether contacts cannot end: an argument for a stop of elastic balls that owes nothing to the engine's.

#include "carom/sim/simulation.hpp"

namespace carom::testing {

/// True if no motion opens every contact that the balls have now among each other and with the walls. A motion w, one
/// velocity a ball, opens them all if n_j.w > 0 for every contact j, with n_j the gradient of its gap, in velocities scaled
/// by sqrt(m). By Gordan's theorem there is none exactly if sum_j mu_j n_j = 0 for some mu >= 0 that are not all 0: if the
/// point of least length in the convex hull of the n_j is 0. With such a w a sequence of elastic impacts at one instant
/// ends, for each raises v.w [papers/simultaneous.md]; without, it need not.
///
/// Or if a ball moves along the inside of a circle that it touches, neither away from it nor towards it: an impact changes
/// nothing, and without one the circle cuts its path off at once.
///
/// Parties are in contact if their gap is within rounding of 0, and a length within rounding of 0 is 0.
[[nodiscard]] bool wedged(const Scene& scene, const Simulation& simulation);

}  // namespace carom::testing
