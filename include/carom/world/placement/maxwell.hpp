#pragma once
// Maxwell velocities with no total momentum and an exact temperature.

#include <cstdint>

#include "carom/core/page_vector.hpp"
#include "carom/scene/scene.hpp"

namespace carom {

/// What the draws of a placement are for: the `use` of a RandomStream. `entry` tells apart the [[gas]] tables of a scene,
/// `attempt` the placements that were tried.
[[nodiscard]] constexpr std::uint32_t use_for_velocity(std::uint32_t entry) { return 0x1000'0000u + entry; }
[[nodiscard]] constexpr std::uint32_t use_for_position(std::uint32_t entry, std::uint32_t attempt) {
  return 0x2000'0000u + (attempt << 20) + entry;
}
[[nodiscard]] constexpr std::uint32_t use_for_order(std::uint32_t part) { return 0x3000'0000u + part; }

struct Maxwell {
  std::int64_t count = 0;
  int dimension = 2;
  double temperature = 1.0;  ///< k_B T [energy]
  double mass = 1.0;         ///< [mass] inf: at rest
  std::uint64_t seed = 1;
  std::uint32_t entry = 0;
};

/// Velocities of N equal balls, N x D, row by row: normal variates of (seed, ball), shifted and scaled such that
///   sum of v = 0 exactly (all are multiples of one power of two);
///   k_B T = m sum v^2 / (D (N - 1)) in a periodic cell, m sum v^2 / (D N) else, to `temperature_ulp`.
/// One ball is at rest in a periodic cell, and keeps its momentum elsewhere.
[[nodiscard]] PageVector<double> maxwell_velocities(const Maxwell& maxwell, SpaceKind space);

/// Largest relative error of the temperature in units of 2^-53 (measured by maxwell_test).
inline constexpr double temperature_ulp = 6.0;

}  // namespace carom
