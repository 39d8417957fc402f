#pragma once
// What a neighbour search is: it names the partners that a ball may meet before its next bookkeeping event.

#include <concepts>
#include <cstdint>

namespace carom {

/// `reset` starts on a world. `for_each_partner(world, i, f)` calls f(j, image) for every partner that ball i may meet before
/// `next_bookkeeping(world, motion, i)`. `cross` carries such an event out. `moved` is told of a rewritten state. No search
/// ever writes a ball, so every search gives the same events.
template <class S, class M>
concept NeighbourSearch = requires(S& s, const S& cs, const M& m, const typename S::WorldType& w, std::uint32_t i,
                                   const typename S::EventType& e) {
  { s.reset(w, m) };
  { s.moved(w, m, i) };
  { s.cross(w, m, e) };
  { cs.next_bookkeeping(w, m, i) } -> std::convertible_to<typename S::EventType>;
  { cs.for_each_partner(w, i, [](std::uint32_t, const auto&) {}) };
};

}  // namespace carom
