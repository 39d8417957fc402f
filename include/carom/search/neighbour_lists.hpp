#pragma once
// Who is near whom: a list for each ball, with its two next meetings beside it.

#include <bit>
#include <cstdint>
#include <vector>

#include "carom/core/clock.hpp"
#include "carom/core/lanes.hpp"
#include "carom/core/pages.hpp"

namespace carom {

/// What is due next for a ball, and who is near it. Two cache lines.
struct alignas(64) Slot {
  Time<double> first;     ///< its first meeting, or a bound below it
  Time<double> second;    ///< its second meeting, or a bound below it
  std::uint32_t partner;  ///< row of a ball, or a face: see Slot::wall
  std::uint32_t second_partner;
  std::int64_t exit;    ///< epoch at whose beginning it is still within its shell
  std::uint32_t count;  ///< neighbours
  std::uint32_t more;   ///< of those that have no room here: the newest block, or Slot::lengthy + the number of an array
  alignas(64) std::uint32_t near[16];

  static constexpr std::uint32_t wall = 0xffff0000U;     ///< + row of the face
  static constexpr std::uint32_t unknown = 0xfffefffeU;  ///< second_partner: there may be one after `first`
  static constexpr std::uint32_t here = 16;
  static constexpr std::uint32_t lengthy = 1U << 31;

  [[nodiscard]] CAROM_INLINE bool exit_first() const { return exit < first.epoch || (exit == first.epoch && 0 < first.offset); }
  /// When the ball is to be looked at.
  [[nodiscard]] CAROM_INLINE Time<double> due() const { return exit_first() ? Time<double>{exit, 0.0} : first; }
  /// The same without a branch, for where nobody can foresee which of the two it is.
  [[nodiscard]] CAROM_INLINE Time<double> due_of_both() const {
    const std::int64_t leaves = -static_cast<std::int64_t>(exit < first.epoch + (0 < first.offset ? 1 : 0));
    return {first.epoch ^ ((first.epoch ^ exit) & leaves),
            std::bit_cast<double>(std::bit_cast<std::int64_t>(first.offset) & ~leaves)};
  }
};
static_assert(sizeof(Slot) == 128);

/// Each ball's list, in its slot as far as there is room, then in blocks of twelve; beyond `most_in_blocks` in an array of its
/// own: a large ball may have thousands of small ones around it.
class NeighbourLists {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::uint32_t most_in_blocks = 64;

  PageArray<Slot> slots;  ///< by row

  /// Room for the lists of n balls, all empty.
  void make_room(std::uint32_t n);

  /// Calls f(rows, count) for the pieces of ball i's list; sixteen rows may be read from any that is there in an array.
  template <class F>
  CAROM_INLINE void for_each_piece(std::uint32_t i, F&& f) const {
    const Slot& slot = slots[i];
    f(slot.near, slot.count < Slot::here ? slot.count : Slot::here);
    if (slot.count <= Slot::here) return;
    std::uint32_t left = slot.count - Slot::here;
    if (is_lengthy(slot)) return f(array_of(slot), left);
    for (std::uint32_t block = slot.more; left > 0; block = more_[block].next) {
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
    if (slot.count >= most_in_blocks || is_lengthy(slot)) return add_to_array(i, j);
    const std::uint32_t behind = slot.count - Slot::here;
    if (behind % in_more == 0) {  // the blocks there are full: the newest comes first
      const std::uint32_t fresh = take_block();
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
    if (is_lengthy(slot)) {
      std::uint32_t* const rows = array_of(slot);
      for (std::uint32_t k = 0; place == nullptr; k += 8)
        if (const unsigned bits = sign_bits8(load8(rows + k) == wanted); bits != 0) place = rows + k + std::countr_zero(bits);
      *place = rows[--slot.count - Slot::here];
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
        for (std::uint32_t m = 0; m < n; m += 8) at |= sign_bits8(load8(found_.data() + m) == j) << m;
        at &= (n < 32 ? 1U << n : 0U) - 1U;
        known |= at;
        gone[left] = row;
        left += at == 0;
      }
      const unsigned add_these = ~known & ((n < 32 ? 1U << n : 0U) - 1U);
      for (std::uint32_t k = 0; k < left; ++k) fetch_slot(gone[k]);
      for (unsigned rest = add_these; rest != 0; rest &= rest - 1)
        fetch_slot(found_[static_cast<std::uint32_t>(std::countr_zero(rest))]);
      meanwhile();
      for (std::uint32_t k = 0; k < left; ++k) remove(gone[k], i);
      for (unsigned rest = add_these; rest != 0; rest &= rest - 1) {
        const std::uint32_t k = static_cast<std::uint32_t>(std::countr_zero(rest));
        add(found_[k], i);
        fresh(k);
      }
      if (n <= Slot::here) {
        for (std::uint32_t k = 0; k < Slot::here; ++k) slots[i].near[k] = found_[k];
        slots[i].count = n;
        return;
      }
    } else if (n <= most_in_blocks && slots[i].count <= most_in_blocks) {
      meanwhile();
      const auto is_found = [this, n](std::uint32_t j) {
        for (std::uint32_t k = 0; k < n; ++k)
          if (found_[k] == j) return true;
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
        if (!was_there(found_[k])) {
          add(found_[k], i);
          fresh(k);
        }
    } else {
      meanwhile();
      mark(n);
      for_each_piece(i, [&](const std::uint32_t* near, std::uint32_t count) {
        for (std::uint32_t k = 0; k < count; ++k)
          if (seen_[near[k]] == round_)
            seen_[near[k]] = 0;  // known already
          else
            remove(near[k], i);
      });
      for (std::uint32_t k = 0; k < n; ++k)
        if (seen_[found_[k]] == round_) {
          add(found_[k], i);
          fresh(k);
        }
    }
    clear(i);
    for (std::uint32_t k = 0; k < n; ++k) add(i, found_[k]);
  }
  CAROM_INLINE void clear(std::uint32_t i) {
    while (slots[i].count > Slot::here && !is_lengthy(slots[i])) {
      const std::uint32_t block = slots[i].more;
      slots[i].count -= more_[block].count;
      slots[i].more = more_[block].next;
      more_[block].next = free_more_;
      free_more_ = block;
    }
    slots[i].count = 0;
  }

  [[nodiscard]] CAROM_INLINE std::uint32_t* found() { return found_.data(); }
  CAROM_INLINE void fetch_slot(std::uint32_t i) const {
    __builtin_prefetch(&slots[i]);
    __builtin_prefetch(&slots[i].near);
  }

  [[nodiscard]] std::size_t bytes() const noexcept;

 private:
  static constexpr std::uint32_t in_more = 12;  // a multiple of four

  struct alignas(64) More {
    std::uint32_t near[in_more];
    std::uint32_t count;
    std::uint32_t next;
  };

  // Slot::more is of no meaning while a list fits its slot, but that a ball which has an array keeps it.
  CAROM_INLINE static bool is_lengthy(const Slot& slot) { return (slot.more & Slot::lengthy) != 0; }
  CAROM_INLINE std::uint32_t* array_of(const Slot& slot) const { return arrays_[slot.more & ~Slot::lengthy]; }

  /// The list of i has no room in blocks, or is in an array already: j comes to it there.
  void add_to_array(std::uint32_t i, std::uint32_t j);
  /// Sets seen_ to round_ for the n found.
  CAROM_INLINE void mark(std::uint32_t n) {
    if (++round_ == 0) round_ = forget_marks();
    for (std::uint32_t k = 0; k < n; ++k) seen_[found_[k]] = round_;
  }
  std::uint32_t forget_marks();
  CAROM_INLINE std::uint32_t take_block() {
    if (free_more_ != none) {
      const std::uint32_t block = free_more_;
      free_more_ = more_[block].next;
      return block;
    }
    more_.resize(more_.size() + 1);
    return static_cast<std::uint32_t>(more_.size() - 1);
  }

  std::uint32_t free_more_ = none;
  std::uint32_t round_ = 0;
  PageArray<More> more_;
  PageArray<std::uint32_t> found_;
  PageArray<std::uint32_t> seen_;  // by row: in which round it was found; pages that are never asked for take no memory
  PageArray<std::uint32_t*> arrays_;
  std::vector<std::vector<std::uint32_t>> owned_;  // what arrays_ points to
};

}  // namespace carom
