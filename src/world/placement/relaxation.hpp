#pragma once
// Overlapping balls pushed apart until none overlap.

#include "crowd.hpp"

namespace carom {

/// Moves the balls after the obstacles, sweep by sweep and pair by pair: every pair nearer than its contact distance times
/// 1 + slack is moved apart, beyond it by 2/5, small balls more than large ones. Done when no pair overlaps; given up when
/// 100 sweeps have not taken a tenth off the overlaps even at the least slack, or when the number of pairs looked at
/// exceeds `budget`. All steps are in a fixed order: the result is a function of the start.
template <int D>
[[nodiscard]] Outcome push_apart(Crowd<D>& crowd, std::int64_t& budget);

extern template Outcome push_apart(Crowd<1>&, std::int64_t&);
extern template Outcome push_apart(Crowd<2>&, std::int64_t&);
extern template Outcome push_apart(Crowd<3>&, std::int64_t&);

}  // namespace carom
