#pragma once
// Where two scenes that should tell the same story begin to tell different ones.

#include <atomic>
#include <optional>

#include "carom/observe/horizon.hpp"
#include "carom/scene/scene.hpp"

namespace carom {

/// The first moment after which some ball moves otherwise in `other` than in `scene`, as the last collision of `scene` at
/// that moment; none if they agree to the end. What rounding makes of another order of the same impacts is no other story:
/// collisions within `one_moment` of each other are one moment, and velocities count as equal within `parting_share` of the
/// fastest component of all.
[[nodiscard]] std::optional<HorizonMark> first_parting(const Scene& scene, const Scene& other,
                                                       const std::atomic<bool>* interrupt = nullptr);

inline constexpr double parting_share = 0x1p-26;
inline constexpr double one_moment = 0x1p-37;  ///< [epoch] 2^16 ticks: many roundings of a coordinate at a usual speed

}  // namespace carom
