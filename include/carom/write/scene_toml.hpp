#pragma once
// A scene file that starts where a frame is.

#include <cstdint>
#include <string>

#include "carom/write/frame.hpp"

namespace carom {

struct SnapshotScene {
  std::string source;         ///< file that the frame comes from, for the scene's head
  double temperature = 1.0;   ///< k_B T [energy], where velocities are not known. DEFAULT: 1
  std::uint64_t seed = 1;     ///< of those velocities. DEFAULT: 1
};

/// The space and a [[ball]] for each ball, in order, numbers with all their digits. Laws, walls and forces are in no
/// trajectory: they are left at their defaults.
[[nodiscard]] std::string scene_toml(const TrajectoryHead& head, const TrajectoryFrame& frame, const SnapshotScene& options);

}  // namespace carom
