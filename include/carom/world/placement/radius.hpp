#pragma once
// Radius, packing fraction and volume: each from the other two, from + - * / sqrt alone.

#include <cstdint>

#include "carom/world/placement/region.hpp"

namespace carom {

/// Largest error of `cube_root` in units of the last place (measured by radius_test, CubeRoot).
inline constexpr double cube_root_ulp = 1.0;

/// The cube root of a normal x >= 0, by Newton's iteration on y^3 = x after a split into powers of eight.
[[nodiscard]] double cube_root(double x);

/// x^(1/dimension).
[[nodiscard]] double dimensional_root(double x, int dimension);

/// x^dimension.
[[nodiscard]] double dimensional_power(double x, int dimension);

/// Length 2 r, area pi r^2 or volume 4 pi r^3 / 3 of one ball.
[[nodiscard]] double ball_volume(double radius, int dimension);

/// Length, area or volume of a bounded region.
[[nodiscard]] double region_volume(const Region& region);

/// The radius with which `count` balls fill the share `packing` of a volume.
[[nodiscard]] double radius_for_packing(double packing, std::int64_t count, double volume, int dimension);

}  // namespace carom
