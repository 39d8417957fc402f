#pragma once
// Which walls of a periodic space, in which periods, a ball can meet while it is in a cell.

#include <array>
#include <cstdint>
#include <vector>

#include "carom/world/wall_images.hpp"

namespace carom {

/// A list for each cell of a grid. A wall is in it, with its period relative to the cell's own, if a ball whose centre is in
/// the cell can touch it; both are widened by a margin, which rounding the time of a crossing cannot use up.
template <class Real, int D>
class NearWalls {
 public:
  /// `cells` of `edge` from `lower` on; balls up to `radius`.
  template <class Cells>
  void reset(const World<Real, D>& world, const Vec<Real, D>& lower, const Vec<Real, D>& edge, const Cells& cells,
             const Real& radius, double margin) {
    using std::sqrt;
    first_.clear();
    near_.clear();
    const Real half = sqrt(dot<Real, D>(edge, edge)) / 2;
    const Real distance = half * Real(1 + margin) + radius;
    std::array<std::int64_t, static_cast<std::size_t>(D)> cell{};
    while (true) {
      Vec<Real, D> middle;
      for (int k = 0; k < D; ++k) middle[k] = lower[k] + (Real(cell[static_cast<std::size_t>(k)]) + Real(0.5)) * edge[k];
      first_.push_back(static_cast<std::uint32_t>(near_.size()));
      std::uint32_t piece = 0;
      world.walls.for_each([&](const auto& shape) {
        for_each_image(world.space, shape, middle, distance, [&](const Image<D>& n) { near_.push_back({piece, n}); });
        ++piece;
      });
      int k = D - 1;  // the last axis counts fastest, as in CellGrid
      while (k >= 0 && ++cell[static_cast<std::size_t>(k)] == cells[static_cast<std::size_t>(k)])
        cell[static_cast<std::size_t>(k--)] = 0;
      if (k < 0) break;
    }
    first_.push_back(static_cast<std::uint32_t>(near_.size()));
  }

  /// Calls f(shape, image) for the walls near a cell that stands `period` periods away.
  template <class F>
  void for_each(const World<Real, D>& world, std::size_t cell, const Image<D>& period, F& f) const {
    std::uint32_t next = first_[cell], piece = 0;
    const std::uint32_t end = first_[cell + 1];
    world.walls.for_each([&](const auto& shape) {
      for (; next < end && near_[next].piece == piece; ++next) {
        Image<D> image = near_[next].image;
        for (int k = 0; k < D; ++k) image[k] += period[k];
        f(shape, image);
      }
      ++piece;
    });
  }

 private:
  struct Near {
    std::uint32_t piece;  // in the order of Walls::for_each
    Image<D> image;
  };
  std::vector<std::uint32_t> first_;  // by cell
  std::vector<Near> near_;
};

}  // namespace carom
