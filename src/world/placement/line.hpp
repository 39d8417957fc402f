#pragma once
// Balls on a line, where a fluid of any density can be sampled exactly.

#include "crowd.hpp"

namespace carom {

/// A sample of the equilibrium of hard rods [Tonks1936]: what the rods leave free is cut at uniform places; the order of
/// the rods is shuffled, and a ring is turned at random. Obstacles divide the line into intervals: each rod, largest first,
/// chooses one with a chance in proportion to what is left free in it. The balls of an entry are numbered from left to
/// right. Not done: some rod found no interval with room. Walls are not looked at.
[[nodiscard]] Outcome place_on_line(Crowd<1>& crowd, std::uint32_t attempt);

}  // namespace carom
