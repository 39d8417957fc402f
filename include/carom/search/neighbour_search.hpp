#pragma once
// What a neighbour search is: it names the partners that a ball may meet before its next bookkeeping event.

#include <concepts>
#include <cstdint>

#include "carom/core/clock.hpp"

namespace carom {

/// `reset` starts on a world as it is at `now`. `for_each_wall` calls f(shape, image) for every piece of a wall and
/// `for_each_partner` f(j, image) for every partner that ball i may meet before `next_bookkeeping`; `cross` carries such an event out, and `for_each_new_partner` names those that it brought
/// within reach. `moved` is told of a rewritten state. No search ever writes a ball, so every search gives the same events.
template <class S, class M>
concept NeighbourSearch = requires(S& s, const S& cs, const M& m, const typename S::WorldType& w, std::uint32_t i,
                                   const typename S::EventType& e, const Time<typename M::Real>& now,
                                   void (*f)(std::uint32_t, decltype(e.image))) {
  {s.reset(w, m, now)};
  {s.moved(w, m, i)};
  {s.cross(e)};
  { cs.fits(w, i, w.balls[0].radius) } -> std::convertible_to<bool>;
  { cs.next_bookkeeping(w, m, i, now) } -> std::convertible_to<typename S::EventType>;
  {cs.for_each_partner(w, i, f)};
  {cs.for_each_new_partner(w, e, f)};
};

}  // namespace carom
