#pragma once
// A search that names every partner twice, from the last to the first: what a search may do without changing an event.

#include "carom/predict/event.hpp"
#include "carom/world/world.hpp"

namespace carom::testing {

template <class Real, int D>
class RepeatingPairs {
 public:
  using WorldType = World<Real, D>;
  using EventType = Event<Real, D>;
  static constexpr const char* name = "repeating pairs";

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
    for (int time = 0; time < 2; ++time) world.walls.for_each([&](const auto& shape) { f(shape, Image<D>{}); });
  }
  template <class F>
  void for_each_partner(const WorldType& world, std::uint32_t i, F&& f) const {
    for (int time = 0; time < 2; ++time)
      for (std::uint32_t j = static_cast<std::uint32_t>(world.balls.size()); j-- > 0;)
        if (j != i && world.balls[j].alive) f(j, Image<D>{});
  }
  template <class F>
  void for_each_new_partner(const WorldType&, const EventType&, F&&) const {}
};

}  // namespace carom::testing
