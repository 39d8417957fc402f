#pragma once
// Random sequential insertion: one ball after the other, each at random places until it overlaps none before it.

#include "crowd.hpp"

namespace carom {

/// Share of the volume up to which insertion is quick: about half of where it saturates (0.7476, 0.5470, 0.3841 in 1, 2,
/// 3-D).
[[nodiscard]] constexpr double insertion_packing(int dimension) {
  return dimension == 1 ? 0.4 : dimension == 2 ? 0.32 : 0.2;
}

/// Places the balls after the obstacles with all radii times `scale`, but clear of walls and faces at full radius.
/// A ball that finds no place in 1000 tries shrinks the scale by a tenth; `reached` is the scale in the end.
/// Not done: some ball found no place at all, clear of the walls, within a bounded number of tries.
template <int D>
[[nodiscard]] Outcome insert_randomly(Crowd<D>& crowd, double scale, std::uint32_t attempt);

extern template Outcome insert_randomly(Crowd<1>&, double, std::uint32_t);
extern template Outcome insert_randomly(Crowd<2>&, double, std::uint32_t);
extern template Outcome insert_randomly(Crowd<3>&, double, std::uint32_t);

}  // namespace carom
