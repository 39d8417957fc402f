#pragma once
// What a run counts and books as it goes.

#include <cstdint>
#include <limits>

#include "carom/core/double_double.hpp"

namespace carom {

struct EventCounts {
  std::int64_t ball_ball = 0;
  std::int64_t ball_wall = 0;
  std::int64_t other = 0;  ///< phase changes, scheduled events
  std::int64_t ties = 0;

  [[nodiscard]] std::int64_t collisions() const noexcept { return ball_ball + ball_wall; }
};

/// How exact the run was.
template <class Real>
struct Exactness {
  Real max_gap_error = Real(0);           ///< [length unit] largest |gap| at a contact
  Real max_gap_error_relative = Real(0);  ///< [-] the same over the sum of the radii in contact (point balls left out)
  std::int64_t clamped = 0;               ///< events found in the past: must stay 0
  std::int64_t unresolved = 0;            ///< positive flight times that rounded to no tick of the clock
  std::int64_t singular = 0;              ///< point balls that hit a vertex
  std::int64_t summed_bounces = 0;        ///< series of bounces whose end was summed: a ball came to rest
  std::int64_t repredicted = 0;           ///< stale events predicted anew: work, not physics
};

/// Energy that left and entered, in sums of twice the precision.
template <class Real>
struct EnergyBooks {
  Wide<Real> dissipated{Real(0)};
  Wide<Real> injected{Real(0)};
  Real largest_injected = Real(0);  ///< largest value that injected has reached
  Real lowest_potential =
      infinity<Real>();  ///< per mass, of all states written; accelerated motion only
};

}  // namespace carom
