#include "carom/search/shells.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

template <int D>
bool Shells<D>::lay_out(const Swarm<D>& swarm, double thickness) {
  const auto& space = swarm.frame;
  const double cut = 2 * swarm.species[0].radius + thickness;
  periodic_ = space.periodic();
  // Balls that can meet have centres of shells up to the sum of their radii + 2 radius_ apart. Distances are taken between
  // points of the grid, each step of which is within 2^-10 the same: that, and the rounding of positions, take less than
  // 2^-6 of the thickness, which is above cut / 16.
  radius_ = thickness / 2 * (1 - 0x1p-6);
  std::size_t total = 1;
  double widest = 0;
  for (int k = 0; k < D; ++k) {
    const double n = std::floor(space.edge[k] / cut);
    // Neighbours, up to cut + thickness apart, have one image each: the others are further away.
    if (periodic_ && (n < 3 || !(space.edge[k] > 2 * (cut + thickness) * (1 + 0x1p-6)))) return false;
    if (!(n < 0x1p20)) return false;
    cells_along_[k] = std::max(1U, static_cast<std::uint32_t>(n));
    total *= cells_along_[k];
    if (total > std::max<std::size_t>(8 * std::size_t{swarm.size()}, 1024)) return false;
    lower_[k] = space.lower[k];
    per_cell_[k] = cells_along_[k] / space.edge[k];
    widest = std::max(widest, space.edge[k] / cells_along_[k]);
  }
  // A cell has as many steps as make a step come nearest to 2^-10 of the widest cell; within 2^-10 it is taken for that.
  const double per_step = 1024 / widest;
  cut_square_ = static_cast<std::int32_t>(cut * per_step * (cut * per_step)) + 1;
  for (int k = 0; k < D; ++k) {
    const double cell = space.edge[k] / cells_along_[k];
    steps_in_cell_[k] = static_cast<std::int32_t>(std::round(cell * per_step));
    step_lanes_[k] = cell / steps_in_cell_[k];
    cell_lanes_[k] = cell;
    lower_lanes_[k] = lower_[k] + step_lanes_[k] / 2;
    period_lanes_[k] = space.edge[k];
    per_period_lanes_[k] = 1 / space.edge[k];
  }
  const std::uint32_t n = swarm.size();
  make_room(n);
  home_ = PageArray<Home>(n);
  cells_ = PageArray<Cell>(total);
  for (std::size_t c = 0; c < total; ++c) cells_[c].next = none;
  return true;
}

template <int D>
bool Shells<D>::lay_out(const Swarm<D>& swarm, const std::vector<Shell>& shells) {
  std::vector<std::uint32_t> counts(shells.size());
  for (std::uint32_t i = 0; i < swarm.size(); ++i) ++counts[swarm.past[i].species];
  if (!sized_.lay_out(swarm.frame, shells, counts)) return false;
  make_room(swarm.size());
  shell_ = PageArray<Shell>(shells.size());
  for (std::size_t s = 0; s < shells.size(); ++s) shell_[s] = shells[s];
  return true;
}

template bool Shells<2>::lay_out(const Swarm<2>&, double);
template bool Shells<3>::lay_out(const Swarm<3>&, double);
template bool Shells<2>::lay_out(const Swarm<2>&, const std::vector<Shell>&);
template bool Shells<3>::lay_out(const Swarm<3>&, const std::vector<Shell>&);

}  // namespace carom
