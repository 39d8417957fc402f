#pragma once
// A scene of doubles: what a run in double precision makes of the numbers that the user wrote.

#include "carom/scene/scene.hpp"

namespace carom {

/// The scene with every number replaced by the double nearest to it, and marked `rounded`: balls that start in contact in
/// double do so in any precision.
[[nodiscard]] Scene rounded_to_double(Scene scene);

}  // namespace carom
