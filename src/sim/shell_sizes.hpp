#pragma once
// How thick the shells of many balls are.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "carom/search/sized_cells.hpp"
#include "carom/world/swarm.hpp"

namespace carom {

/// What the shells are made after.
struct BallSizes {
  double largest = 0, smallest = std::numeric_limits<double>::infinity(), sum = 0;  ///< [length unit] of the radii
  std::size_t balls = 0;

  void add(double radius, std::size_t count = 1) {
    largest = std::max(largest, radius);
    smallest = std::min(smallest, radius);
    sum += radius * static_cast<double>(count);
    balls += count;
  }
  [[nodiscard]] bool equal() const { return smallest == largest; }
};

/// Neighbours wanted: measured best, 3-D at packing 0.30 and 0.49, disks at 0.65, mixtures 1:2 and 1:20 (papers/speed).
template <int D>
[[nodiscard]] constexpr double best_neighbours(bool equal) {
  return D == 2 ? 8.4 : equal ? 12.2 : 9.0;
}

/// A tenth of the mean diameter, and what the steps of the cells can tell.
[[nodiscard]] inline double least_thickness(const BallSizes& sizes) {
  return std::max(0.1 * 2 * sizes.sum / static_cast<double>(sizes.balls), 0x1p-10 * sizes.largest);
}

/// Thickness of the shells at which a ball of the mean radius has so many neighbours in a gas of such (0: best_neighbours); in a
/// narrow periodic space no more than leaves each pair of neighbours one image (see Shells). Below least_thickness: there is no room.
template <int D>
[[nodiscard]] double shell_thickness(const Space<double, D>& space, const BallSizes& sizes, double neighbours = 0) {
  double volume = 1;
  for (int k = 0; k < D; ++k) volume *= space.edge[k];
  const double n = static_cast<double>(sizes.balls);
  const double share = (neighbours > 0 ? neighbours : best_neighbours<D>(sizes.equal())) * volume / n;
  constexpr double pi = 3.141592653589793;
  const double cut = D == 3 ? std::cbrt(share * 3 / (4 * pi)) : std::sqrt(share / pi);
  double thickness = std::max(cut - 2 * sizes.sum / n, least_thickness(sizes));
  if (space.periodic())
    for (int k = 0; k < D; ++k) thickness = std::min(thickness, space.edge[k] * (0.25 - 0x1p-7) - sizes.largest);
  return thickness;
}

/// A shell for each species of a swarm: all of one thickness, since it is the small balls that move and are many; none about
/// what is fixed.
template <int D>
[[nodiscard]] std::vector<Shell> shells_of(const Swarm<D>& swarm, double thickness) {
  std::vector<Shell> shells;
  for (const Species& kind : swarm.species) {
    const double half = thickness / 2, reach = kind.fixed ? kind.radius : kind.radius + half;
    float above = static_cast<float>(reach);
    if (above < reach) above = std::nextafter(above, std::numeric_limits<float>::infinity());
    shells.push_back({half * (1 - 0x1p-6), above});
  }
  return shells;
}

}  // namespace carom
