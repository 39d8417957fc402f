#include "carom/search/neighbour_lists.hpp"

#include <algorithm>

namespace carom {

void NeighbourLists::make_room(std::uint32_t n) {
  slots = PageArray<Slot>(n);
  found_ = PageArray<std::uint32_t>(n + 16);
  seen_ = PageArray<std::uint32_t>(n);
  more_ = PageArray<More>();
  arrays_ = PageArray<std::uint32_t*>();
  owned_.clear();
  free_more_ = none;
  round_ = 0;
}

void NeighbourLists::add_to_array(std::uint32_t i, std::uint32_t j) {
  if (!is_lengthy(slots[i])) {
    std::vector<std::uint32_t> behind;
    bool here = true;  // those in the slot stay there
    for_each_piece(i, [&behind, &here](const std::uint32_t* near, std::uint32_t n) {
      if (!here) behind.insert(behind.end(), near, near + n);
      here = false;
    });
    const std::uint32_t count = slots[i].count;
    clear(i);
    slots[i].count = count;
    slots[i].more = static_cast<std::uint32_t>(owned_.size()) | Slot::lengthy;
    behind.resize(4 * behind.size());
    owned_.push_back(std::move(behind));
    arrays_.resize(owned_.size());
    arrays_[owned_.size() - 1] = owned_.back().data();
  }
  const std::uint32_t a = slots[i].more & ~Slot::lengthy, at = slots[i].count - Slot::here;
  std::vector<std::uint32_t>& rows = owned_[a];
  if (at + 16 >= rows.size()) {  // so many may be read from the last one
    rows.resize(2 * rows.size());
    arrays_[a] = rows.data();
  }
  rows[at] = j;
  ++slots[i].count;
}

std::uint32_t NeighbourLists::forget_marks() {
  std::fill(seen_.data(), seen_.data() + seen_.size(), 0U);
  return 1;
}

std::size_t NeighbourLists::bytes() const noexcept {
  std::size_t sum = slots.bytes() + more_.bytes() + found_.bytes() + seen_.bytes() + arrays_.bytes();
  for (const auto& rows : owned_) sum += rows.capacity() * sizeof(std::uint32_t);
  return sum;
}

}  // namespace carom
