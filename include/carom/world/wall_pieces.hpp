#pragma once
// The pieces of walls that stand still, by one number: flat ones, spheres and arcs.

#include <cstddef>

#include "carom/world/wall_motion.hpp"
#include "carom/world/walls.hpp"

namespace carom {

/// Calls f(pieces) for the arrays of pieces that have a number, until it returns true.
template <class Real, int D, class F>
inline void until_array(const Walls<Real, D>& walls, F&& f) {
  if (f(walls.faces) || f(walls.planes)) return;
  if constexpr (D == 2)
    if (f(walls.segments)) return;
  if constexpr (D > 1)
    if (f(walls.spheres)) return;
  if constexpr (D == 2) (void)f(walls.arcs);
}

[[nodiscard]] inline std::size_t numbered_pieces(const auto& walls) {
  std::size_t sum = 0;
  until_array(walls, [&sum](const auto& pieces) {
    sum += pieces.size();
    return false;
  });
  return sum;
}

/// Calls f(shape) for piece `number`, counted from the first face on; for none if there is no such piece.
template <class Real, int D, class F>
inline void with_piece(const Walls<Real, D>& walls, std::size_t number, F&& f) {
  until_array(walls, [&number, &f](const auto& pieces) {
    if (number >= pieces.size()) {
      number -= pieces.size();
      return false;
    }
    f(pieces[number]);
    return true;
  });
}

/// True if all pieces have a number, stand still and let nobody out.
template <class Real, int D>
[[nodiscard]] bool all_stand_still(const Walls<Real, D>& walls) {
  bool still = true;
  std::size_t pieces = 0;
  walls.for_each([&](const auto& shape) {
    ++pieces;
    still = still && !moves(walls, shape) && !walls.opens(index(shape.wall));
  });
  return still && pieces == numbered_pieces(walls);
}

}  // namespace carom
