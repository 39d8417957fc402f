#pragma once
// Neighbour lists: each ball has a shell that it flies in, and a list of those whose shells are near enough to be met.
//
// A ball stays within `radius` of the centre of its shell until it leaves it; then it gets a new one [DonevTorquatoStillinger
// 2005]. Two balls are neighbours if their centres are closer than the sum of their radii + `thickness`, and thickness > 2
// radius: whoever is to be met is in the list. Centres are points of a grid, up to 1024 steps a cell, so that whether two
// balls are neighbours is decided in integers, the same from both sides, and the bits of no ball are touched.

#include <bit>
#include <cstdint>

#include "carom/core/lanes.hpp"
#include "carom/core/pages.hpp"
#include "carom/world/swarm.hpp"

namespace carom {

/// What is due next for a ball, and who is near it. Two cache lines.
struct alignas(64) Slot {
  Time<double> first;           ///< its first meeting, or a bound below it
  std::uint32_t partner;        ///< row of a ball, or a face: see Slot::wall
  std::uint32_t partner_stamp;  ///< when predicted
  Time<double> second;          ///< its second meeting, or a bound below it
  std::uint32_t second_partner;
  std::uint32_t second_stamp;
  std::int64_t exit;    ///< epoch at whose beginning it is still within its shell
  std::uint32_t count;  ///< neighbours
  std::uint32_t more;   ///< block of those that have no room here
  std::uint32_t near[16];

  static constexpr std::uint32_t wall = 0xffff0000U;     ///< + row of the face
  static constexpr std::uint32_t unknown = 0xfffefffeU;  ///< second_partner: there may be one after `first`
  static constexpr std::uint32_t here = 16;

  [[nodiscard]] CAROM_INLINE bool exit_first() const { return exit < first.epoch || (exit == first.epoch && 0 < first.offset); }
  /// When the ball is to be looked at.
  [[nodiscard]] CAROM_INLINE Time<double> due() const { return exit_first() ? Time<double>{exit, 0.0} : first; }
};
static_assert(sizeof(Slot) == 128);

template <int D>
class Shells {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  PageArray<Slot> slots;  ///< by row

  /// Makes room for the shells of a swarm, with cells for balls whose neighbours have centres at most `cut` apart; lists and
  /// cells are empty. False if the space is too small for that.
  bool lay_out(const Swarm<D>& swarm, double largest_radius, double thickness);

  [[nodiscard]] CAROM_INLINE double radius() const { return radius_; }
  [[nodiscard]] double thickness() const noexcept { return thickness_; }
  [[nodiscard]] std::size_t bytes() const noexcept {
    return slots.bytes() + home_.bytes() + cells_.bytes() + more_.bytes() + scratch_.bytes();
  }

  /// The shell of ball i is put about x, which may lie outside of a period.
  CAROM_INLINE void place(std::uint32_t i, const double (&x)[D]) {
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
        const std::uint32_t fresh = take_block(cells_, free_cell_);
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
  CAROM_INLINE void displace(std::uint32_t i) {
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
  CAROM_INLINE Lanes from_centre(std::uint32_t i, const Lanes& x) const {
    const Home& home = home_[i];
    std::uint32_t cell[lanes], step[lanes];
    for (int k = 0; k < lanes; ++k) {
      cell[k] = home.fine[k] >> 10;
      step[k] = home.fine[k] & 1023U;
    }
    const Lanes u = x - (lower_lanes_ + to_double(cell) * cell_lanes_ + to_double(step) * step_lanes_);
    return periodic_ ? u - nearest_integer(u * per_period_lanes_) * period_lanes_ : u;
  }

  /// Finds the neighbours of ball i by the centres; their rows are in found()[0 .. result). `periodic`, `equal`: as laid out.
  template <bool periodic, bool equal>
  CAROM_INLINE std::uint32_t gather(const Swarm<D>& swarm, std::uint32_t i) {
    const Home home = home_[i];
    const double own = swarm.kind(i).radius;
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
    std::uint32_t* const found = scratch_.data();
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
            unsigned bits = sign_bits8(square - cut_square) & ((1U << c->count) - 1U);
            if constexpr (!equal)
              for (unsigned rest = bits; rest != 0; rest &= rest - 1) {
                const int k = std::countr_zero(rest);
                if (!(square[k] < pair_square(own, swarm, c->ball[k]))) bits &= ~(1U << k);
              }
            write_chosen(found + count, c->ball, bits);
            count += static_cast<std::uint32_t>(__builtin_popcount(bits));
            if (next == none) break;
            c = cells + next;
          }
        }
      }
    }
    for (std::uint32_t k = 0; k < count; ++k)  // not itself
      if (scratch_[k] == i) {
        scratch_[k] = scratch_[count - 1];
        break;
      }
    return count - 1;
  }
  [[nodiscard]] CAROM_INLINE std::uint32_t* found() { return scratch_.data(); }
  CAROM_INLINE void fetch_slot(std::uint32_t i) const {
    __builtin_prefetch(&slots[i]);
    __builtin_prefetch(&slots[i].near);
  }
  CAROM_INLINE void fetch_home(std::uint32_t i) const { __builtin_prefetch(&home_[i]); }
  /// Asks for the lines that `gather` will read, ahead of it.
  CAROM_INLINE void fetch_cells(std::uint32_t i) const {
    const std::uint32_t x = home_[i].fine[0] >> 10;
    for (int dz = D == 3 ? -1 : 0; dz <= (D == 3 ? 1 : 0); ++dz) {
      std::uint32_t z = 0;
      if (D == 3 && !neighbour(home_[i].fine[D - 1] >> 10, dz, D - 1, z)) continue;
      for (int dy = -1; dy <= 1; ++dy) {
        std::uint32_t y;
        if (!neighbour(home_[i].fine[1] >> 10, dy, 1, y)) continue;
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

  /// Calls f(rows, count) for the pieces of ball i's list.
  template <class F>
  CAROM_INLINE void for_each_piece(std::uint32_t i, F&& f) const {
    const Slot& slot = slots[i];
    f(slot.near, slot.count < Slot::here ? slot.count : Slot::here);
    std::uint32_t left = slot.count;
    for (std::uint32_t block = slot.more; left > Slot::here; block = more_[block].next) {
      f(more_[block].near, more_[block].count);
      left -= more_[block].count;
    }
  }
  /// Writes the rows of ball i's list, if they are `count`, and some behind them up to a multiple of four.
  CAROM_INLINE void copy_list(std::uint32_t i, std::uint32_t count, std::uint32_t* to) const {
    if (count != slots[i].count) return;
    for_each_piece(i, [&to](const std::uint32_t* near, std::uint32_t n) {
      for (std::uint32_t k = 0; k < n; ++k) *to++ = near[k];
    });
    for (std::uint32_t k = count; k % lanes != 0; ++k) *to++ = i;
  }
  CAROM_INLINE void add(std::uint32_t i, std::uint32_t j) {
    Slot& slot = slots[i];
    if (slot.count < Slot::here) {
      slot.near[slot.count++] = j;
      return;
    }
    const std::uint32_t behind = slot.count - Slot::here;
    if (behind % in_more == 0) {  // the blocks there are full: the newest comes first
      const std::uint32_t fresh = take_block(more_, free_more_);
      more_[fresh].next = slot.more;
      more_[fresh].count = 0;
      slots[i].more = fresh;
    }
    More& m = more_[slots[i].more];
    m.near[m.count++] = j;
    ++slots[i].count;
  }
  /// Takes j, which is there, from the list of i.
  CAROM_INLINE void remove(std::uint32_t i, std::uint32_t j) {
    Slot& slot = slots[i];
    std::uint32_t* place = nullptr;
    const std::uint32_t here = slot.count < Slot::here ? slot.count : Slot::here;
    const Ints8 wanted = Ints8{} + static_cast<std::int32_t>(j);
    const unsigned at = (sign_bits8(load8(slot.near) == wanted) | sign_bits8(load8(slot.near + 8) == wanted) << 8) & ((1U << here) - 1U);
    if (at != 0) place = &slot.near[std::countr_zero(at)];
    if (slot.count <= Slot::here) {
      *place = slot.near[--slot.count];
      return;
    }
    for (std::uint32_t block = slot.more; place == nullptr; block = more_[block].next)
      for (std::uint32_t k = 0; k < more_[block].count; ++k)
        if (more_[block].near[k] == j) place = &more_[block].near[k];
    More& m = more_[slot.more];
    *place = m.near[--m.count];
    --slot.count;
    if (m.count == 0) {
      const std::uint32_t empty = slot.more;
      slot.more = m.next;
      m.next = free_more_;
      free_more_ = empty;
    }
  }
  /// Makes the n rows of found() the neighbours of ball i, on both sides, and calls fresh(k) for each found()[k] that is new.
  /// `meanwhile` is called while the records of those whose lists change are on their way.
  template <class F, class G>
  CAROM_INLINE void update(std::uint32_t i, std::uint32_t n, F&& fresh, G&& meanwhile) {
    if (n <= 32 && slots[i].count <= Slot::here) {
      std::uint32_t gone[Slot::here + 1], left = 0;
      unsigned known = 0;  // bit k: found()[k] is in the list already
      for (std::uint32_t k = 0; k < slots[i].count; ++k) {
        const std::uint32_t row = slots[i].near[k];
        const Ints8 j = Ints8{} + static_cast<std::int32_t>(row);
        unsigned at = 0;
        for (std::uint32_t m = 0; m < n; m += 8) at |= sign_bits8(load8(scratch_.data() + m) == j) << m;
        at &= (n < 32 ? 1U << n : 0U) - 1U;
        known |= at;
        gone[left] = row;
        left += at == 0;
      }
      const unsigned add_these = ~known & ((n < 32 ? 1U << n : 0U) - 1U);
      for (std::uint32_t k = 0; k < left; ++k) fetch_slot(gone[k]);
      for (unsigned rest = add_these; rest != 0; rest &= rest - 1)
        fetch_slot(scratch_[static_cast<std::uint32_t>(std::countr_zero(rest))]);
      meanwhile();
      for (std::uint32_t k = 0; k < left; ++k) remove(gone[k], i);
      for (unsigned rest = add_these; rest != 0; rest &= rest - 1) {
        const std::uint32_t k = static_cast<std::uint32_t>(std::countr_zero(rest));
        add(scratch_[k], i);
        fresh(k);
      }
    } else {
      meanwhile();
      const auto is_found = [this, n](std::uint32_t j) {
        for (std::uint32_t k = 0; k < n; ++k)
          if (scratch_[k] == j) return true;
        return false;
      };
      const auto was_there = [this, i](std::uint32_t j) {
        bool there = false;
        for_each_piece(i, [&there, j](const std::uint32_t* near, std::uint32_t count) {
          for (std::uint32_t k = 0; k < count; ++k) there |= near[k] == j;
        });
        return there;
      };
      for_each_piece(i, [&](const std::uint32_t* near, std::uint32_t count) {
        for (std::uint32_t k = 0; k < count; ++k)
          if (!is_found(near[k])) remove(near[k], i);
      });
      for (std::uint32_t k = 0; k < n; ++k)
        if (!was_there(scratch_[k])) {
          add(scratch_[k], i);
          fresh(k);
        }
    }
    clear(i);
    for (std::uint32_t k = 0; k < n; ++k) add(i, scratch_[k]);
  }
  CAROM_INLINE void clear(std::uint32_t i) {
    while (slots[i].count > Slot::here) {
      const std::uint32_t block = slots[i].more;
      slots[i].count -= more_[block].count;
      slots[i].more = more_[block].next;
      more_[block].next = free_more_;
      free_more_ = block;
    }
    slots[i].count = 0;
  }

 private:
  static constexpr std::uint32_t in_cell = 7, in_more = 12;  // in_more: a multiple of four

  struct alignas(64) Cell {
    std::uint32_t fraction[in_cell];  // 10 bits an axis
    std::uint32_t count;
    std::uint32_t ball[in_cell];
    std::uint32_t next;
  };
  struct alignas(64) More {
    std::uint32_t near[in_more];
    std::uint32_t count;
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
  CAROM_INLINE std::int32_t pair_square(double own, const Swarm<D>& swarm, std::uint32_t j) const {
    const double cut = ((own + swarm.kind(j).radius) + thickness_) * per_step_;
    return static_cast<std::int32_t>(cut * cut) + 1;
  }
  template <class T>
  CAROM_INLINE std::uint32_t take_block(PageArray<T>& blocks, std::uint32_t& free) {
    if (free != none) {
      const std::uint32_t block = free;
      free = blocks[block].next;
      return block;
    }
    blocks.resize(blocks.size() + 1);
    return static_cast<std::uint32_t>(blocks.size() - 1);
  }

  bool periodic_ = false;
  double thickness_ = 0, radius_ = 0;
  double per_step_ = 0;           // what one step of any axis is taken for
  std::int32_t cut_square_ = 0;   // in steps
  std::int32_t steps_in_cell_[D] = {};  // at most 1024
  double lower_[D] = {}, per_cell_[D] = {};
  Lanes lower_lanes_ = {}, period_lanes_ = {}, cell_lanes_ = {}, step_lanes_ = {}, per_period_lanes_ = {};  // the lower end: of the middle of a step
  std::uint32_t cells_along_[D] = {};
  std::uint32_t free_cell_ = none, free_more_ = none;
  PageArray<Home> home_;
  PageArray<Cell> cells_;
  PageArray<More> more_;
  PageArray<std::uint32_t> scratch_;
};

extern template bool Shells<2>::lay_out(const Swarm<2>&, double, double);
extern template bool Shells<3>::lay_out(const Swarm<3>&, double, double);

}  // namespace carom
