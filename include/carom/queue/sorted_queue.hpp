#pragma once
// The event queue as a sorted set: the plainest there is, kept to check the others against.

#include <set>
#include <vector>

#include "carom/predict/event.hpp"

namespace carom {

template <class Real, int D>
class SortedQueue {
 public:
  using EventType = Event<Real, D>;
  static constexpr const char* name = "sorted set";

  void reset(std::uint32_t slots) {
    events_.assign(slots, EventType{});
    order_.clear();
    for (std::uint32_t s = 0; s < slots; ++s) order_.insert(s);
  }
  void assign(std::uint32_t slot, const EventType& event) {
    order_.erase(slot);
    events_[slot] = event;
    order_.insert(slot);
  }
  [[nodiscard]] const EventType& top() const { return events_[*order_.begin()]; }
  [[nodiscard]] std::uint32_t top_slot() const { return *order_.begin(); }

  SortedQueue() = default;
  SortedQueue(const SortedQueue&) = delete;  // the order looks into the events of this queue
  SortedQueue& operator=(const SortedQueue&) = delete;

 private:
  struct Earlier {
    const std::vector<EventType>* events;
    bool operator()(std::uint32_t a, std::uint32_t b) const {
      if (precedes((*events)[a], (*events)[b])) return true;
      return !precedes((*events)[b], (*events)[a]) && a < b;
    }
  };

  std::vector<EventType> events_;
  std::set<std::uint32_t, Earlier> order_{Earlier{&events_}};
};

}  // namespace carom
