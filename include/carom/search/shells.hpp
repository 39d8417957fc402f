#pragma once
// Neighbour lists: each ball has a shell that it flies in, and a list of those whose shells are near enough to be met.
//
// A ball stays within `radius` of the centre of its shell until it leaves it; then it gets a new one [DonevTorquatoStillinger
// 2005]. Two balls are neighbours if their centres are closer than the sum of their radii + `thickness`, and thickness > 2
// radius: whoever is to be met is in the list. Centres are points of a grid, up to 1024 steps a cell, so that whether two
// balls are neighbours is decided in integers, the same from both sides, and the bits of no ball are touched. Balls of several
// kinds have shells and cells by their size (search/sized_cells.hpp): `equal` false, below.

#include <bit>
#include <cstdint>
#include <vector>

#include "carom/core/lanes.hpp"
#include "carom/core/pages.hpp"
#include "carom/search/neighbour_lists.hpp"
#include "carom/search/sized_cells.hpp"
#include "carom/world/swarm.hpp"

namespace carom {

template <int D>
class Shells : public NeighbourLists {
 public:
  /// Makes room for the shells of a swarm of equal balls; lists and cells are empty. False if the space is too small for that.
  bool lay_out(const Swarm<D>& swarm, double thickness);
  /// The same for balls of several kinds, with a shell for each species.
  bool lay_out(const Swarm<D>& swarm, const std::vector<Shell>& shells);

  [[nodiscard]] std::size_t bytes() const noexcept {
    return NeighbourLists::bytes() + home_.bytes() + cells_.bytes() + sized_.bytes();
  }
  /// How far ball i may stray from the centre of its shell [length unit].
  template <bool equal>
  [[nodiscard]] CAROM_INLINE double radius(const Swarm<D>& swarm, std::uint32_t i) const {
    if constexpr (equal) return radius_;
    return shell_[swarm.past[i].species].radius;
  }

  /// The shell of ball i is put about x, which may lie outside of a period.
  template <bool equal>
  CAROM_INLINE void place([[maybe_unused]] const Swarm<D>& swarm, std::uint32_t i, const double (&x)[D]) {
    if constexpr (!equal) return sized_.place(i, x, shell_[swarm.past[i].species].reach);
    std::uint32_t fraction = 0;
    for (int k = 0; k < D; ++k) {
      double share = (x[k] - lower_[k]) * per_cell_[k];
      const double n = static_cast<double>(cells_along_[k]);
      if (periodic_ && (share < 0 || share >= n)) share -= n * __builtin_floor(share / n);
      const double top = n - 0x1p-11;
      share = share < 0 ? 0 : share > top ? top : share;
      const std::uint32_t cell = static_cast<std::uint32_t>(static_cast<std::int32_t>(share));
      const std::uint32_t step = static_cast<std::uint32_t>(
          static_cast<std::int32_t>((share - static_cast<double>(static_cast<std::int32_t>(cell))) * steps_in_cell_[k]));
      home_[i].fine[k] = cell << 10 | step;
      fraction |= step << (10 * k);
    }
    const std::uint32_t cell = cell_of(i);
    std::uint32_t block = cell;
    while (cells_[block].count == in_cell) {
      if (cells_[block].next == none) {
        const std::uint32_t fresh = take_block();
        cells_[fresh].count = 0;
        cells_[fresh].next = none;
        cells_[block].next = fresh;
      }
      block = cells_[block].next;
    }
    Cell& c = cells_[block];
    c.fraction[c.count] = fraction;
    c.ball[c.count] = i;
    ++c.count;
  }
  template <bool equal>
  CAROM_INLINE void displace(std::uint32_t i) {
    if constexpr (!equal) return sized_.displace(i);
    std::uint32_t block = cell_of(i);
    while (true) {
      Cell& c = cells_[block];
      for (std::uint32_t k = 0; k < c.count; ++k)
        if (c.ball[k] == i) {
          --c.count;
          c.fraction[k] = c.fraction[c.count];
          c.ball[k] = c.ball[c.count];
          return;
        }
      block = c.next;
    }
  }

  /// From the centre of ball i's shell to x, by the shortest way; lanes beyond D are 0 if those of x are.
  template <bool equal>
  CAROM_INLINE Lanes from_centre(std::uint32_t i, const Lanes& x) const {
    if constexpr (!equal) return sized_.from_centre(i, x);
    const Home& home = home_[i];
    std::uint32_t cell[lanes], step[lanes];
    for (int k = 0; k < lanes; ++k) {
      cell[k] = home.fine[k] >> 10;
      step[k] = home.fine[k] & 1023U;
    }
    const Lanes u = x - (lower_lanes_ + to_double(cell) * cell_lanes_ + to_double(step) * step_lanes_);
    return periodic_ ? u - nearest_integer(u * per_period_lanes_) * period_lanes_ : u;
  }

  /// Finds the neighbours of ball i by the centres; their rows are in found()[0 .. result). `periodic`: as laid out.
  template <bool periodic, bool equal>
  CAROM_INLINE std::uint32_t gather(std::uint32_t i) {
    if constexpr (!equal) return sized_.gather(i, found());
    const Home home = home_[i];
    // By axis, of the cell below, its own, and the one above: what it adds to the number of a cell, and where the ball is as
    // seen from its lower end.
    std::uint32_t part[3][3] = {};
    std::int32_t seen[3][3] = {};
    std::uint32_t stride = 1;
    for (int k = 0; k < D; ++k) {
      const std::uint32_t at = home.fine[k] >> 10, n = cells_along_[k];
      part[k][0] = at > 0 ? (at - 1) * stride : periodic ? (n - 1) * stride : none;
      part[k][1] = at * stride;
      part[k][2] = at + 1 < n ? (at + 1) * stride : periodic ? 0 : none;
      const std::int32_t fraction = static_cast<std::int32_t>(home.fine[k] & 1023U);
      for (int d = 0; d < 3; ++d) seen[k][d] = fraction - (d - 1) * steps_in_cell_[k];
      stride *= n;
    }
    const Cell* const cells = cells_.data();
    std::uint32_t* const found = this->found();
    const Ints8 cut_square = Ints8{} + cut_square_;
    std::uint32_t count = 0;
    for (int dz = 0; dz < (D == 3 ? 3 : 1); ++dz) {
      const std::uint32_t z = part[2][dz];
      if (!periodic && z == none) continue;
      const Ints8 mine_z = Ints8{} + seen[2][dz];
      for (int dy = 0; dy < 3; ++dy) {
        const std::uint32_t y = part[1][dy];
        if (!periodic && y == none) continue;
        for (int dx = 0; dx < 3; ++dx) {
          const std::uint32_t x = part[0][dx];
          if (!periodic && x == none) continue;
          const Ints8 mine_xy =
              Ints8{} + ((seen[0][dx] & 0xffff) | static_cast<std::int32_t>(static_cast<std::uint32_t>(seen[1][dy]) << 16));
          const Cell* c = cells + (x + y + z);
          while (true) {
            const Ints8 fraction = load8(c->fraction);
            const Ints8 xy = (fraction & 0x3ff) | ((fraction << 6) & 0x3ff0000);
            Ints8 square = sums_of_squares(differences16(xy, mine_xy));
            if constexpr (D == 3) square += sums_of_squares(((fraction >> 20) - mine_z) & 0xffff);
            const std::uint32_t next = c->next;
            const unsigned bits = sign_bits8(square - cut_square) & ((1U << c->count) - 1U);
            write_chosen(found + count, c->ball, bits);
            count += static_cast<std::uint32_t>(__builtin_popcount(bits));
            if (next == none) break;
            c = cells + next;
          }
        }
      }
    }
    for (std::uint32_t k = 0; k < count; ++k)  // not itself
      if (found[k] == i) {
        found[k] = found[count - 1];
        break;
      }
    return count - 1;
  }
  template <bool equal>
  CAROM_INLINE void fetch_home(std::uint32_t i) const {
    if constexpr (!equal) return sized_.fetch_home(i);
    __builtin_prefetch(&home_[i]);
  }
  /// Asks for the lines that `gather` will read, ahead of it, when ball i has got a shell about `centre`.
  template <bool equal>
  CAROM_INLINE void fetch_cells(std::uint32_t i, const double (&centre)[D]) const {
    if constexpr (!equal) return sized_.fetch_cells(i);
    std::uint32_t at[D];
    for (int k = 0; k < D; ++k) {
      const double share = (centre[k] - lower_[k]) * per_cell_[k], n = static_cast<double>(cells_along_[k]);
      const double within = share < 0 ? share + n : share < n ? share : share - n;
      at[k] = within >= 0 && within < n ? static_cast<std::uint32_t>(static_cast<std::int32_t>(within)) : 0;
    }
    const std::uint32_t x = at[0];
    for (int dz = D == 3 ? -1 : 0; dz <= (D == 3 ? 1 : 0); ++dz) {
      std::uint32_t z = 0;
      if (D == 3 && !neighbour(at[D - 1], dz, D - 1, z)) continue;
      for (int dy = -1; dy <= 1; ++dy) {
        std::uint32_t y;
        if (!neighbour(at[1], dy, 1, y)) continue;
        const Cell* const row = &cells_[(D == 3 ? z * cells_along_[1] + y : y) * cells_along_[0]];
        __builtin_prefetch(row + (x > 0 ? x - 1 : cells_along_[0] - 1));
        __builtin_prefetch(row + x);
        __builtin_prefetch(row + (x + 1 < cells_along_[0] ? x + 1 : 0));
      }
    }
  }
  [[nodiscard]] CAROM_INLINE std::uint32_t cell_of(std::uint32_t i) const {
    std::uint32_t cell = home_[i].fine[D - 1] >> 10;
    for (int k = D - 2; k >= 0; --k) cell = cell * cells_along_[k] + (home_[i].fine[k] >> 10);
    return cell;
  }

 private:
  static constexpr std::uint32_t in_cell = 7;

  struct alignas(64) Cell {
    std::uint32_t fraction[in_cell];  // 10 bits an axis
    std::uint32_t count;
    std::uint32_t ball[in_cell];
    std::uint32_t next;
  };
  struct Home {
    std::uint32_t fine[lanes];  // of the centre, by axis: 1024 times the cell + steps from its lower end
  };

  CAROM_INLINE bool neighbour(std::uint32_t c, int d, int k, std::uint32_t& to) const {
    const std::int64_t n = cells_along_[k];
    std::int64_t there = static_cast<std::int64_t>(c) + d;
    if (there < 0 || there >= n) {
      if (!periodic_) return false;
      there += there < 0 ? n : -n;
    }
    to = static_cast<std::uint32_t>(there);
    return true;
  }
  CAROM_INLINE std::uint32_t take_block() {
    cells_.resize(cells_.size() + 1);
    return static_cast<std::uint32_t>(cells_.size() - 1);
  }

  bool periodic_ = false;
  double radius_ = 0;
  std::int32_t cut_square_ = 0;   // in steps
  std::int32_t steps_in_cell_[D] = {};  // at most 1024
  double lower_[D] = {}, per_cell_[D] = {};
  Lanes lower_lanes_ = {}, period_lanes_ = {}, cell_lanes_ = {}, step_lanes_ = {}, per_period_lanes_ = {};  // the lower end: of the middle of a step
  std::uint32_t cells_along_[D] = {};
  PageArray<Home> home_;
  PageArray<Cell> cells_;
  SizedCells<D> sized_;
  PageArray<Shell> shell_;  // by species
};

extern template bool Shells<2>::lay_out(const Swarm<2>&, double);
extern template bool Shells<3>::lay_out(const Swarm<3>&, double);
extern template bool Shells<2>::lay_out(const Swarm<2>&, const std::vector<Shell>&);
extern template bool Shells<3>::lay_out(const Swarm<3>&, const std::vector<Shell>&);

}  // namespace carom
