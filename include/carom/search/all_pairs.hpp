#pragma once
// Every ball against every other: nothing to keep, the fastest for a handful of balls.

#include "carom/predict/event.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Open space and box. (A periodic space has infinitely many images of every partner: there cells are the search.)
template <class Real, int D>
class AllPairs {
 public:
  using WorldType = World<Real, D>;
  using EventType = Event<Real, D>;
  static constexpr const char* name = "all pairs";

  template <class M>
  void reset(const WorldType&, const M&) {}
  template <class M>
  void moved(const WorldType&, const M&, std::uint32_t) {}
  template <class M>
  void cross(const WorldType&, const M&, const EventType&) {}
  template <class M>
  [[nodiscard]] EventType next_bookkeeping(const WorldType&, const M&, std::uint32_t) const {
    return {};
  }
  template <class F>
  void for_each_partner(const WorldType& world, std::uint32_t i, F&& f) const {
    const std::uint32_t n = static_cast<std::uint32_t>(world.balls.size());
    for (std::uint32_t j = 0; j < n; ++j)
      if (j != i && world.balls[j].alive) f(j, Image<D>{});
  }
};

}  // namespace carom
