#pragma once
// The event queue as a heap: O(log N) a change, nothing to tune.

#include <vector>

#include <boost/heap/d_ary_heap.hpp>

#include "carom/predict/event.hpp"

namespace carom {

template <class Real, int D>
class HeapQueue {
 public:
  using EventType = Event<Real, D>;
  static constexpr const char* name = "heap";

  /// Makes `slots` slots, each empty (its event is `none`, at `never`).
  void reset(std::uint32_t slots) {
    heap_.clear();
    handles_.clear();
    heap_.reserve(slots);
    handles_.reserve(slots);
    for (std::uint32_t s = 0; s < slots; ++s) handles_.push_back(heap_.push(Entry{EventType{}, s}));
  }
  void assign(std::uint32_t slot, const EventType& event) {
    (*handles_[slot]).event = event;
    heap_.update(handles_[slot]);
  }
  [[nodiscard]] const EventType& top() const { return heap_.top().event; }
  [[nodiscard]] std::uint32_t top_slot() const { return heap_.top().slot; }
  [[nodiscard]] bool empty() const { return heap_.empty(); }

 private:
  struct Entry {
    EventType event;
    std::uint32_t slot;
  };
  struct Later {  // Boost.Heap keeps the largest on top
    bool operator()(const Entry& a, const Entry& b) const { return precedes(b.event, a.event); }
  };
  using Heap =
      boost::heap::d_ary_heap<Entry, boost::heap::arity<4>, boost::heap::mutable_<true>, boost::heap::compare<Later>>;

  Heap heap_;
  std::vector<typename Heap::handle_type> handles_;
};

}  // namespace carom
