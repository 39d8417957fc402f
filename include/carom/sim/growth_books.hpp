#pragma once
// What a run of growing balls measures as it goes: the pressure over blocks of collisions.

#include <algorithm>
#include <cstdint>

#include "carom/core/double_double.hpp"
#include "carom/motion/growing_flight.hpp"
#include "carom/sim/books.hpp"
#include "carom/sim/totals.hpp"

namespace carom {

/// The reduced pressure p V / (N k_B T) = 1 + (f / D N) W / ((K_0 + K_1) t) over a block of collisions that took the time
/// t, W the sum of impulse times distance of the centres over the impacts of two balls, K_0 and K_1 the kinetic energies
/// before and after, f the degrees of freedom: D N, in a periodic space D (N - 1). Infinite where a block took no time: no
/// ball has room to move any more.
template <class Real>
struct GrowthBooks {
  /// Collisions a block: ten for each ball, at least this many.
  static constexpr std::int64_t shortest_block = 1000;

  Wide<Real> kinetic{Real(0)};  ///< [energy] at the world's start
  Wide<Real> virial{Real(0)};   ///< [energy] W of the block that is being filled
  Wide<Real> before{Real(0)};   ///< [energy] K_0
  Time<Real> begun;             ///< when it began
  std::int64_t movable = 0;     ///< balls of finite mass
  Real pressure = Real(0);      ///< of the last block that was filled; 0: none yet

  template <class M, class WorldType>
  void reset(const M& motion, const WorldType& world) {
    kinetic = before = totals_at(motion, world, world.start).kinetic;
    begun = world.start;
    movable =
        std::count_if(world.details.begin(), world.details.end(), [](const auto& d) { return !detail::infinite(d.mass); });
  }

  void impact(const Real& impulse, const Real& distance) { virial = virial + wide_product<Real>(impulse, distance); }

  /// The kinetic energy now: what came in and went out is in the books.
  [[nodiscard]] Wide<Real> kinetic_now(const EnergyBooks<Real>& books) const {
    return kinetic + books.injected - books.dissipated;
  }

  [[nodiscard]] std::int64_t block() const { return std::max(shortest_block, 10 * movable); }

  /// Called after each collision; true if that one filled the block.
  template <class WorldType>
  bool count(const WorldType& world, const EventCounts& counts, const EnergyBooks<Real>& books, const Time<Real>& now) {
    if (counts.collisions() % block() != 0) return false;
    const Wide<Real> after = kinetic_now(books);
    const Real n = static_cast<Real>(movable), free = world.space.periodic() ? n - 1 : n;
    const Real action = narrow(Wide<Real>(before + after)) * elapsed(begun, now);
    pressure = action > 0 ? Real(1 + free / n * (narrow(virial) / action)) : infinity<Real>();
    virial = Wide<Real>(Real(0));
    before = after;
    begun = now;
    return true;
  }
};

/// For balls that keep their sizes.
struct NoGrowthBooks {};

template <class M>
using GrowthBooksOf = std::conditional_t<GrowingMotion<M>, GrowthBooks<typename M::Real>, NoGrowthBooks>;

}  // namespace carom
