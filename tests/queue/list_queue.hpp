#pragma once
// The event queue as anybody would write it first: a list, searched from end to end.

#include <cstdint>
#include <vector>

#include "carom/predict/event.hpp"

namespace carom::testing {

template <class Real, int D>
class ListQueue {
 public:
  using EventType = Event<Real, D>;
  static constexpr const char* name = "list";

  void reset(std::uint32_t slots) { events_.assign(slots, EventType{}); }
  void assign(std::uint32_t slot, const EventType& event) { events_[slot] = event; }
  [[nodiscard]] const EventType& top() const { return events_[top_slot()]; }
  [[nodiscard]] std::uint32_t top_slot() const {
    std::uint32_t first = static_cast<std::uint32_t>(events_.size()) - 1;  // equal events: any of them
    for (std::uint32_t s = first; s-- > 0;)
      if (precedes(events_[s], events_[first])) first = s;
    return first;
  }

 private:
  std::vector<EventType> events_;
};

}  // namespace carom::testing
