#pragma once
// The log of a simulation, event by event, as claims.

#include <array>
#include <cstdint>

#include "carom/certify/claim.hpp"
#include "carom/sim/simulation.hpp"

namespace carom::certify {

/// The claim that a collision makes. `reach` is the distance of the centres at it, `periods` the edges of a periodic space
/// (0: none): which image of the partner was met follows from the places of both.
[[nodiscard]] Claim claim_of(const Collision& collision, double reach, const std::array<double, 3>& periods);

}  // namespace carom::certify
