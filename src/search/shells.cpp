#include "carom/search/shells.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

template <int D>
bool Shells<D>::lay_out(const Swarm<D>& swarm, double largest_radius, double thickness) {
  const auto& space = swarm.rest.space;
  const double cut = 2 * largest_radius + thickness;
  periodic_ = space.periodic();
  equal_ = swarm.species.size() == 1;
  thickness_ = thickness;
  // Grid, float arithmetic and rounding of positions take less than 2^-7 of the thickness: the grid is 2^-10 of a cell's
  // edge, which is below 2 cut, and the thickness at least cut / 16.
  radius_ = thickness / 2 * (1 - 0x1p-6);
  cut_square_ = static_cast<float>(cut * cut);
  std::size_t total = 1;
  for (int k = 0; k < D; ++k) {
    const double n = std::floor(space.edge[k] / cut);
    if (periodic_ && n < 3) return false;
    if (!(n < 0x1p20)) return false;
    cells_along_[k] = std::max(1U, static_cast<std::uint32_t>(n));
    total *= cells_along_[k];
    if (total > std::max<std::size_t>(8 * std::size_t{swarm.size()}, 1024)) return false;
    lower_[k] = space.lower[k];
    period_[k] = space.edge[k];
    per_period_[k] = 1 / space.edge[k];
    step_[k] = space.edge[k] / cells_along_[k] / 1024;
    per_cell_[k] = cells_along_[k] / space.edge[k];
    scale_[k] = static_cast<float>(step_[k]);
  }
  const std::uint32_t n = swarm.size();
  slots = PageArray<Slot>(n);
  home_ = PageArray<Home>(n);
  scratch_ = PageArray<std::uint32_t>(n + 16);
  cells_ = PageArray<Cell>(total);
  for (std::size_t c = 0; c < total; ++c) cells_[c].next = none;
  more_ = PageArray<More>();
  free_cell_ = free_more_ = none;
  return true;
}

template bool Shells<2>::lay_out(const Swarm<2>&, double, double);
template bool Shells<3>::lay_out(const Swarm<3>&, double, double);

}  // namespace carom
