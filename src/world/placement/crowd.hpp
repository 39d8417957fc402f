#pragma once
// The balls of all [[gas]] entries with the obstacles among them, in coordinates that start at the region's lower corner.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "carom/core/page_vector.hpp"
#include "carom/world/placement/region.hpp"

namespace carom {

inline constexpr std::uint32_t no_ball = ~std::uint32_t{0};

/// Balls 0 .. fixed - 1 are the obstacles; then the entries, largest radius first.
template <int D>
struct Crowd {
  using Vector = std::array<double, D>;

  struct Source {  ///< where a ball's random numbers come from
    std::uint64_t seed = 0;
    std::uint32_t entry = 0;  ///< its [[gas]]
    std::uint32_t index = 0;  ///< its number within the entry
  };

  struct Run {  ///< the balls of one entry, which follow one another
    std::size_t first = 0;  ///< counted after the obstacles
    Source source;          ///< of that one
  };

  bool periodic = true;
  Vector lower{}, edge{};
  std::size_t fixed = 0;
  PageVector<Vector> x;       ///< [length] 0 .. edge
  PageVector<double> radius;  ///< [length] padded: see `padding`
  std::vector<Run> runs;
  ClearOfWalls clear_of_walls;

  [[nodiscard]] std::size_t size() const { return radius.size(); }
  [[nodiscard]] std::size_t movable() const { return size() - fixed; }

  /// Of ball fixed + i.
  [[nodiscard]] Source source(std::size_t i) const {
    auto run = runs.rbegin();
    while (run->first > i) ++run;
    return {run->source.seed, run->source.entry, static_cast<std::uint32_t>(i - run->first)};
  }

  [[nodiscard]] bool clear(const Vector& at, double r) const {
    if (!clear_of_walls) return true;
    Vector global{};
    for (int k = 0; k < D; ++k) {
      double y = at[k];
      if (periodic) y = y < 0.0 ? y + edge[k] : y >= edge[k] ? y - edge[k] : y;
      global[k] = lower[k] + y;
    }
    return clear_of_walls(global.data(), r);
  }
};

/// What a radius is enlarged by, so that no gap closes when coordinates are shifted, wrapped and rounded: 2^-30 of it, and
/// 8 units in the last place of the largest coordinate.
[[nodiscard]] inline double padding(double radius, const Region& region) {
  double largest = 0.0;
  for (int k = 0; k < region.dimension; ++k) {
    const double lower = region.lower[k], upper = region.upper[k];
    largest = std::max({largest, lower < 0 ? -lower : lower, upper < 0 ? -upper : upper});
  }
  return radius * 0x1p-30 + largest * 0x1p-49;
}

/// What an attempt at a placement came to.
struct Outcome {
  bool done = false;
  std::size_t placed = 0;  ///< balls that found a place at all
  double reached = 0.0;    ///< radii times this would not overlap; 1 where done
};

}  // namespace carom
