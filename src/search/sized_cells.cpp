#include "carom/search/sized_cells.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

template <int D>
bool SizedCells<D>::lay_out(const Space<double, D>& space, const std::vector<Shell>& shells,
                            const std::vector<std::uint32_t>& counts) {
  std::vector<std::pair<float, std::uint32_t>> reaches;  // and how many have it, the largest first
  double thinnest = 0, widest = 0;  // [length unit] radii of shells
  std::size_t balls = 0;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    if (counts[s] == 0) continue;
    reaches.push_back({shells[s].reach, counts[s]});
    thinnest = thinnest == 0 ? shells[s].radius : std::min(thinnest, shells[s].radius);
    widest = std::max(widest, shells[s].radius);
    balls += counts[s];
  }
  if (reaches.empty()) return false;
  std::sort(reaches.rbegin(), reaches.rend());

  const double cut = 2 * double{reaches[0].first};
  periodic_ = space.periodic();
  bits_ = periodic_ ? 32 : 31;
  half_ = std::int64_t{1} << (bits_ - 1);
  steps_ = std::ldexp(1.0, bits_);
  double volume = 1;
  for (int k = 0; k < D; ++k) {
    const double edge = space.edge[k], step = edge / steps_;
    // Neighbours have one image each, wherever they are in their shells: the others are further away.
    if (periodic_ && !(edge > 2 * (cut + 2 * widest) * (1 + 0x1p-6))) return false;
    // Distances are taken in floats: off by less than 2^-20 of the largest, which is less than 2^-6 of any shell's radius.
    if (!(step < thinnest * 0x1p-8) || !(cut * 0x1p-13 < thinnest)) return false;
    volume *= edge;
    lower_[k] = space.lower[k];
    per_edge_[k] = 1 / edge;
    per_step_[k] = steps_ / edge;
    step_floats_[k] = static_cast<float>(step);
    step_lanes_[k] = step;
    middle_lanes_[k] = space.lower[k] + edge / 2 + step / 2;
    period_lanes_[k] = edge;
    per_period_lanes_[k] = 1 / edge;
  }

  classes_ = 0;
  std::int64_t total = 0;
  for (std::size_t next = 0; next < reaches.size();) {
    Grid& grid = grids_[classes_++];
    grid.reach = reaches[next].first;
    std::uint64_t members = 0;
    const bool last = classes_ == most_classes;
    for (; next < reaches.size() && (last || 2 * reaches[next].first > grid.reach); ++next) members += reaches[next].second;
    // Cells of two reaches, and not fewer than two balls to a cell where it has few.
    const double edge = std::max(2 * double{grid.reach}, std::pow(2 * volume / static_cast<double>(members), 1.0 / D));
    grid.first = total;
    std::int64_t cells = 1;
    for (int k = 0; k < D; ++k) {
      grid.along[k] = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::min(space.edge[k] / edge, 0x1p20)));
      cells *= grid.along[k];
      if (cells > (std::int64_t{1} << 30)) return false;
    }
    total += cells;
  }
  if (total > (std::int64_t{1} << 30)) return false;
  home_ = PageArray<Home>(balls);
  cells_ = PageArray<Cell>(static_cast<std::size_t>(total));
  for (std::size_t c = 0; c < cells_.size(); ++c) cells_[c].next = none;
  return true;
}

template bool SizedCells<2>::lay_out(const Space<double, 2>&, const std::vector<Shell>&, const std::vector<std::uint32_t>&);
template bool SizedCells<3>::lay_out(const Space<double, 3>&, const std::vector<Shell>&, const std::vector<std::uint32_t>&);

}  // namespace carom
