#pragma once
// Every ball against every other: nothing to keep, the fastest for a handful of balls.

#include "carom/predict/event.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// For open space and box. A periodic space has infinitely many images of every partner: there CellGrid with one cell does
/// it.
template <class Real, int D>
class AllPairs {
 public:
  using WorldType = World<Real, D>;
  using EventType = Event<Real, D>;
  static constexpr const char* name = "all pairs";

  template <class M>
  void reset(const WorldType&, const M&, const Time<Real>&) {}
  template <class M>
  void moved(const WorldType&, const M&, std::uint32_t) {}
  void cross(const EventType&) {}
  [[nodiscard]] bool fits(const WorldType&, std::uint32_t, const Real&) const { return true; }
  template <class M>
  [[nodiscard]] EventType next_bookkeeping(const WorldType&, const M&, std::uint32_t, const Time<Real>&) const {
    return {};
  }
  template <class F>
  void for_each_wall(const WorldType& world, std::uint32_t, F&& f) const {
    world.walls.for_each([&](const auto& shape) { f(shape, Image<D>{}); });
  }
  template <class F>
  void for_each_partner(const WorldType& world, std::uint32_t i, F&& f) const {
    const std::uint32_t n = static_cast<std::uint32_t>(world.balls.size());
    for (std::uint32_t j = 0; j < n; ++j)
      if (j != i && world.balls[j].alive) f(j, Image<D>{});
  }
  template <class F>
  void for_each_new_partner(const WorldType&, const EventType&, F&&) const {}
};

}  // namespace carom
