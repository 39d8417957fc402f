#pragma once
// What a run ends with: the physics, and what it took.

#include <optional>
#include <string>
#include <vector>

#include "carom/observe/estimate.hpp"
#include "carom/sim/summary.hpp"

namespace carom {

struct RunReport {
  Summary summary;
  Estimates observed;                           ///< what [observe] asks for
  std::optional<std::vector<BallState>> final;  ///< the balls that are left; none: not asked for
  double seconds = 0.0;                         ///< [s] wall time of the run, without the building of the scene
  double peak_memory_mb = 0.0;                  ///< [MiB] of the process
  std::vector<std::string> files{};             ///< that were written

  /// [1/s] 0 if no time has passed.
  [[nodiscard]] double collisions_per_second() const noexcept {
    return seconds > 0 ? static_cast<double>(summary.events.collisions()) / seconds : 0.0;
  }
};

}  // namespace carom
