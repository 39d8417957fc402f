#pragma once
// Where generated balls may lie, what lies there already, and what a generator hands back.

#include <array>
#include <cstddef>
#include <functional>

#include "carom/core/page_vector.hpp"
#include "carom/scene/scene.hpp"

namespace carom {

/// The [space] of a scene in doubles. Components beyond the dimension are not read; an open space has no bounds.
struct Region {
  SpaceKind kind = SpaceKind::open;
  int dimension = 2;
  std::array<double, 3> lower{};  ///< [length]
  std::array<double, 3> upper{};  ///< [length]

  [[nodiscard]] double length(int axis) const { return upper[axis] - lower[axis]; }
};

/// A ball that is there already.
struct Obstacle {
  std::array<double, 3> position{};  ///< [length]
  double radius = 0.0;               ///< [length]
};

/// Equal balls with their state at the start.
struct PlacedBalls {
  double radius = 0.0;           ///< [length]
  double packing = 0.0;          ///< [-] their own share of the region; 0 in an open space
  PageVector<double> position;  ///< [length] count x dimension, row by row
  PageVector<double> velocity;  ///< [length/time] count x dimension, row by row
  Region region;                 ///< the space: as given, or the periodic cell that the balls have set
};

/// Does a ball of this radius at x (dimension components, inside the region) overlap no wall, nor a periodic image of one?
/// Empty: there are no walls.
using ClearOfWalls = std::function<bool(const double* x, double radius)>;

}  // namespace carom
