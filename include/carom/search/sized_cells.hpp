#pragma once
// Centres of the shells of balls of many sizes: a grid for each class of sizes, up to twice as wide as each other
// [OgarkoLuding2012].
//
// Ball i reaches as far as its radius and half of the thickness of its shell: balls are neighbours if their centres are closer
// than the sum of their reaches. A ball is in the grid of its class alone, whose cells are wider than two reaches; in each grid
// it looks at those cells that can hold a neighbour. Centres are integers, 2^32 steps a period, so that their difference
// wraps as the space does, and whether two are neighbours is decided the same from both sides.

#include <bit>
#include <cstdint>
#include <vector>

#include "carom/core/lanes.hpp"
#include "carom/core/pages.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// The share of a ball in the distance at which it has neighbours, and how far it may stray from the centre of its shell.
struct Shell {
  double radius;  ///< [length unit] of the shell; any where the ball never moves
  float reach;    ///< [length unit] the ball's radius and half of the shell's thickness
};

template <int D>
class SizedCells {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::uint32_t most_classes = 8;

  /// Grids for balls with these shells, of which there are `counts`; all cells are empty. False if a periodic space is not wider than
  /// twice the largest distance that neighbours can be at, or its steps are too coarse for the shells.
  bool lay_out(const Space<double, D>& space, const std::vector<Shell>& shells, const std::vector<std::uint32_t>& counts);

  [[nodiscard]] std::uint32_t classes() const noexcept { return classes_; }
  [[nodiscard]] std::size_t bytes() const noexcept { return home_.bytes() + cells_.bytes(); }

  /// The shell of ball i, which reaches so far, is put about x, which may lie outside of a period.
  CAROM_INLINE void place(std::uint32_t i, const double (&x)[D], float reach) {
    Home& home = home_[i];
    for (int k = 0; k < D; ++k) {
      double share = (x[k] - lower_[k]) * per_edge_[k];
      if (periodic_) share -= __builtin_floor(share);
      const double top = 1 - 0x1p-32;
      share = share < 0 ? 0 : share > top ? top : share;
      home.at[k] = static_cast<std::int32_t>(static_cast<std::int64_t>(share * steps_) - half_);
    }
    home.reach = reach;
    std::uint32_t block = cell_of(home);
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
    for (int k = 0; k < D; ++k) c.at[k][c.count] = home.at[k];
    c.reach[c.count] = reach;
    c.ball[c.count] = i;
    ++c.count;
  }
  CAROM_INLINE void displace(std::uint32_t i) {
    std::uint32_t block = cell_of(home_[i]);
    while (true) {
      Cell& c = cells_[block];
      for (std::uint32_t m = 0; m < c.count; ++m)
        if (c.ball[m] == i) {
          --c.count;
          for (int k = 0; k < D; ++k) c.at[k][m] = c.at[k][c.count];
          c.reach[m] = c.reach[c.count];
          c.ball[m] = c.ball[c.count];
          return;
        }
      block = c.next;
    }
  }

  /// From the centre of ball i's shell to x, by the shortest way; lanes beyond D are 0 if those of x are.
  CAROM_INLINE Lanes from_centre(std::uint32_t i, const Lanes& x) const {
    const Home& home = home_[i];
    Lanes centre = {};
    for (int k = 0; k < D; ++k) centre[k] = home.at[k];
    const Lanes u = x - (middle_lanes_ + centre * step_lanes_);
    return periodic_ ? u - nearest_integer(u * per_period_lanes_) * period_lanes_ : u;
  }

  /// Writes the rows of the neighbours of ball i to `found`, which has room for all balls and 16 more; returns how many.
  CAROM_INLINE std::uint32_t gather(std::uint32_t i, std::uint32_t* found) const {
    const Home home = home_[i];
    const Cell* const cells = cells_.data();
    std::uint32_t count = 0;
    for (std::uint32_t g = 0; g < classes_; ++g) {
      const Grid& grid = grids_[g];
      std::int64_t first[3] = {0, 0, 0}, last[3] = {0, 0, 0}, along[3] = {1, 1, 1};
      // Rounding of the distances that decide is far less than what is added here.
      const double cut = (static_cast<double>(home.reach) + grid.reach) * (1 + 0x1p-16);
      for (int k = 0; k < D; ++k) {
        along[k] = grid.along[k];
        const std::int64_t steps = static_cast<std::int64_t>(cut * per_step_[k]) + 2;
        std::int64_t low = home.at[k] - steps, high = home.at[k] + steps;
        if (!periodic_) {
          low = low < -half_ ? -half_ : low;
          high = high > half_ - 1 ? half_ - 1 : high;
        }
        first[k] = ((low + half_) * along[k]) >> bits_;
        last[k] = ((high + half_) * along[k]) >> bits_;
        if (last[k] - first[k] >= along[k]) {
          first[k] = 0;
          last[k] = along[k] - 1;
        }
      }
      for (std::int64_t z = first[2]; z <= last[2]; ++z) {
        const std::int64_t row_z = D == 3 ? wrapped(z, along[2]) * along[1] : 0;
        for (std::int64_t y = first[1]; y <= last[1]; ++y) {
          const Cell* const row = cells + (grid.first + (row_z + wrapped(y, along[1])) * along[0]);
          for (std::int64_t x = first[0]; x <= last[0]; ++x) {
            const Cell* c = row + wrapped(x, along[0]);
            while (true) {
              const unsigned bits = near(home, *c);
              const std::uint32_t next = c->next;
              write_chosen(found + count, c->ball, bits);
              count += static_cast<std::uint32_t>(__builtin_popcount(bits));
              if (next == none) break;
              c = cells + next;
            }
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

  CAROM_INLINE void fetch_home(std::uint32_t i) const { __builtin_prefetch(&home_[i]); }
  /// Asks for the lines of its own grid that `gather` will read, ahead of it.
  CAROM_INLINE void fetch_cells(std::uint32_t i) const {
    const Home& home = home_[i];
    const Grid& grid = grids_[class_of(home.reach)];
    std::int64_t at[3] = {0, 0, 0}, along[3] = {1, 1, 1};
    for (int k = 0; k < D; ++k) {
      along[k] = grid.along[k];
      at[k] = ((home.at[k] + half_) * along[k]) >> bits_;
    }
    for (std::int64_t dz = D == 3 ? -1 : 0; dz <= (D == 3 ? 1 : 0); ++dz) {
      const std::int64_t z = D == 3 ? wrapped(at[2] + dz, along[2]) : 0;
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const Cell* const row = &cells_[static_cast<std::size_t>(grid.first + (z * along[1] + wrapped(at[1] + dy, along[1])) * along[0])];
        for (std::int64_t dx = -1; dx <= 1; ++dx) {
          const Cell* const c = row + wrapped(at[0] + dx, along[0]);
          __builtin_prefetch(c);
          __builtin_prefetch(reinterpret_cast<const char*>(c) + 64);
        }
      }
    }
  }

 private:
  static constexpr std::uint32_t in_cell = D == 3 ? 6 : 7;

  /// Eight entries may be read from each of its arrays.
  struct alignas(64) Cell {
    std::int32_t at[D][in_cell];
    float reach[in_cell];
    std::uint32_t ball[in_cell];
    std::uint32_t count, next;
  };
  static_assert(sizeof(Cell) == 128);
  struct Home {
    std::int32_t at[3];  // of the centre, in steps from the middle of the space
    float reach;
  };
  struct Grid {
    std::int64_t first;     // cell
    std::int64_t along[D];  // cells
    float reach;            // the largest in it
  };

  /// n in [-along, 2 along) taken into [0, along).
  CAROM_INLINE static std::int64_t wrapped(std::int64_t n, std::int64_t along) {
    return n < 0 ? n + along : n >= along ? n - along : n;
  }
  CAROM_INLINE std::uint32_t class_of(float reach) const {
    std::uint32_t g = 0;
    while (g + 1 < classes_ && reach <= grids_[g + 1].reach) ++g;
    return g;
  }
  CAROM_INLINE std::uint32_t cell_of(const Home& home) const {
    const Grid& grid = grids_[class_of(home.reach)];
    std::int64_t cell = 0;
    for (int k = D - 1; k >= 0; --k) cell = cell * grid.along[k] + (((home.at[k] + half_) * grid.along[k]) >> bits_);
    return static_cast<std::uint32_t>(grid.first + cell);
  }
  /// Bit m is set if ball c.ball[m] is a neighbour of one at home.
  CAROM_INLINE unsigned near(const Home& home, const Cell& c) const {
    Floats8 square = {};
    for (int k = 0; k < D; ++k) {
      // Unsigned, so that the difference wraps.
      using Words8 = std::uint32_t __attribute__((vector_size(32)));
      const Words8 steps = std::bit_cast<Words8>(load8(reinterpret_cast<const std::uint32_t*>(c.at[k]))) - static_cast<std::uint32_t>(home.at[k]);
      const Floats8 d = __builtin_convertvector(std::bit_cast<Ints8>(steps), Floats8) * step_floats_[k];
      square += d * d;
    }
    const Floats8 cut = std::bit_cast<Floats8>(load8(reinterpret_cast<const std::uint32_t*>(c.reach))) + home.reach;
    return sign_bits8(std::bit_cast<Ints8>(square < cut * cut)) & ((1U << c.count) - 1U);
  }
  CAROM_INLINE std::uint32_t take_block() {
    cells_.resize(cells_.size() + 1);
    return static_cast<std::uint32_t>(cells_.size() - 1);
  }

  bool periodic_ = false;
  int bits_ = 32;                             // of a coordinate
  std::int64_t half_ = std::int64_t{1} << 31;  // steps from the middle of the space to its end
  double steps_ = 0x1p32;                     // from end to end
  std::uint32_t classes_ = 0;
  Grid grids_[most_classes] = {};  // the largest balls first
  double lower_[D] = {}, per_edge_[D] = {}, per_step_[D] = {};
  float step_floats_[D] = {};
  Lanes middle_lanes_ = {}, step_lanes_ = {}, period_lanes_ = {}, per_period_lanes_ = {};  // the middle: of the step there
  PageArray<Home> home_;
  PageArray<Cell> cells_;
};

extern template bool SizedCells<2>::lay_out(const Space<double, 2>&, const std::vector<Shell>&, const std::vector<std::uint32_t>&);
extern template bool SizedCells<3>::lay_out(const Space<double, 3>&, const std::vector<Shell>&, const std::vector<std::uint32_t>&);

}  // namespace carom
