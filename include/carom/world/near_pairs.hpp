#pragma once
// Every pair of balls whose centres are within the sum of their radii and a margin, found on a grid of its own.
//
// For what is done once (start contacts, overlaps) and for audits; independent of the neighbour searches of a run.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/core/id.hpp"
#include "carom/core/vec.hpp"
#include "carom/world/world.hpp"

namespace carom {

namespace detail {

/// Balls sorted into cells of a bounding box; at most about four cells a ball.
template <int D>
struct PairGrid {
  std::array<double, D> lower{}, cell{};
  std::array<std::int64_t, D> cells{};
  std::vector<std::uint32_t> first, balls;  // balls of cell c: balls[first[c]] .. balls[first[c + 1] - 1]
  std::vector<std::uint32_t> alive, fill;   // working space

  [[nodiscard]] std::int64_t place(double x, int k) const {
    const double n = std::floor((x - lower[k]) / cell[k]);
    return std::clamp<std::int64_t>(n < 9e18 ? static_cast<std::int64_t>(n) : cells[k], 0, cells[k] - 1);
  }
};

}  // namespace detail

/// Calls f(i, j, image) once for every pair i < j (and i == j for a ball and its own image) that may be closer than the sum
/// of the radii plus `margin`; `positions` are those of the balls, wrapped in a periodic space. Farther pairs may be named
/// too. `grid` lends its memory: where it is kept from call to call, nothing is allocated again.
template <class WorldLike, class Real, int D, class F>
void for_each_near_pair(const WorldLike& world, const std::vector<Vec<Real, D>>& positions, double margin,
                        detail::PairGrid<D>& grid, F&& f) {
  const std::uint32_t n = static_cast<std::uint32_t>(positions.size());
  std::vector<std::uint32_t>& alive = grid.alive;
  alive.clear();
  double reach = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!world.balls[i].alive) continue;
    alive.push_back(i);
    reach = std::max(reach, static_cast<double>(world.balls[i].radius));
  }
  if (alive.empty()) return;
  reach = 2 * reach * (1 + 0x1p-20) + margin;

  const bool periodic = world.space.periodic();
  std::array<double, D> extent{};
  for (int k = 0; k < D; ++k) {
    double low = static_cast<double>(positions[alive[0]][k]), high = low;
    for (const std::uint32_t i : alive) {
      low = std::min(low, static_cast<double>(positions[i][k]));
      high = std::max(high, static_cast<double>(positions[i][k]));
    }
    grid.lower[k] = periodic ? static_cast<double>(world.space.lower[k]) : low;
    extent[k] = periodic ? static_cast<double>(world.space.edge[k]) : high - low;
  }
  double most = 1;
  for (int k = 0; k < D; ++k) most *= std::max(1.0, reach > 0 ? std::floor(extent[k] / reach) : 1e9);
  const double shrink = std::max(1.0, std::pow(most / (4.0 * static_cast<double>(alive.size()) + 64.0), 1.0 / D));
  std::int64_t total = 1;
  for (int k = 0; k < D; ++k) {
    const double fit = reach > 0 ? std::floor(extent[k] / (reach * shrink)) : std::floor(1e9 / shrink);
    grid.cells[k] = static_cast<std::int64_t>(std::max(1.0, std::min(fit, 1e6)));
    grid.cell[k] = extent[k] > 0 ? extent[k] / static_cast<double>(grid.cells[k]) : 1.0;
    total *= grid.cells[k];
  }

  const auto cell_of = [&](std::uint32_t i) {
    std::array<std::int64_t, D> c;
    for (int k = 0; k < D; ++k) c[k] = grid.place(static_cast<double>(positions[i][k]), k);
    return c;
  };
  const auto flat = [&](const std::array<std::int64_t, D>& c) {
    std::int64_t s = 0;
    for (int k = 0; k < D; ++k) s = s * grid.cells[k] + c[k];
    return s;
  };
  grid.first.assign(static_cast<std::size_t>(total) + 1, 0);
  for (const std::uint32_t i : alive) ++grid.first[flat(cell_of(i)) + 1];
  for (std::size_t c = 0; c < static_cast<std::size_t>(total); ++c) grid.first[c + 1] += grid.first[c];
  grid.balls.resize(alive.size());
  grid.fill.assign(grid.first.begin(), grid.first.end() - 1);
  for (const std::uint32_t i : alive) grid.balls[grid.fill[flat(cell_of(i))]++] = i;

  // How many cells away a partner may lie: one where a cell holds the reach, more in a small periodic cell.
  std::array<std::int64_t, D> range{};
  for (int k = 0; k < D; ++k)
    range[k] = periodic ? static_cast<std::int64_t>(std::floor(reach / grid.cell[k])) + 1 : (grid.cells[k] > 1 ? 1 : 0);

  for (const std::uint32_t i : alive) {
    const std::array<std::int64_t, D> home = cell_of(i);
    std::array<std::int64_t, D> offset;
    for (int k = 0; k < D; ++k) offset[k] = -range[k];
    while (true) {
      std::array<std::int64_t, D> c;
      Image<D> image{};
      bool inside = true;
      for (int k = 0; k < D; ++k) {
        c[k] = home[k] + offset[k];
        if (periodic) {
          std::int64_t turns = c[k] / grid.cells[k];
          if (c[k] % grid.cells[k] < 0) --turns;
          c[k] -= turns * grid.cells[k];
          image[k] = static_cast<std::int32_t>(turns);
        } else if (c[k] < 0 || c[k] >= grid.cells[k]) {
          inside = false;
        }
      }
      if (inside) {
        const std::size_t s = static_cast<std::size_t>(flat(c));
        for (std::uint32_t p = grid.first[s]; p < grid.first[s + 1]; ++p) {
          const std::uint32_t j = grid.balls[p];
          if (j > i || (j == i && image > Image<D>{})) f(i, j, image);
        }
      }
      int k = 0;
      while (k < D && ++offset[k] > range[k]) {
        offset[k] = -range[k];
        ++k;
      }
      if (k == D) break;
    }
  }
}

template <class WorldLike, class Real, int D, class F>
void for_each_near_pair(const WorldLike& world, const std::vector<Vec<Real, D>>& positions, double margin, F&& f) {
  detail::PairGrid<D> grid;
  for_each_near_pair(world, positions, margin, grid, f);
}

}  // namespace carom
