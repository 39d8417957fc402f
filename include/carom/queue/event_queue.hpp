#pragma once
// What an event queue is: one live event a ball, the first of all on top.

#include <concepts>
#include <cstdint>

namespace carom {

/// A queue of one event a ball (its slot). `assign` replaces the event of a slot; `top` is the first by `precedes`.
template <class Q>
concept EventQueue = requires(Q& q, const Q& cq, const typename Q::EventType& e, std::uint32_t slot) {
  {q.reset(slot)};
  {q.assign(slot, e)};
  { cq.top() } -> std::convertible_to<const typename Q::EventType&>;
  { cq.top_slot() } -> std::convertible_to<std::uint32_t>;
};

}  // namespace carom
