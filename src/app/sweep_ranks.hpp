#pragma once
// A sweep on several processes: rank 0 hands out the runs and collects the rows, and computes like the others.

#include <atomic>

#include "ranks.hpp"
#include "sweep_desk.hpp"

namespace carom::app {

/// Rank 0: until every run is done, or handed out no more. Tells the others to begin.
void lead(const SweepPlan& plan, SweepDesk& desk, int threads, std::atomic<bool>& interrupt, const Ranks& ranks);

/// Rank 0, where nothing is to be done: lets the others go.
void dismiss(const Ranks& ranks);

/// The others: they know the command line, and read the scene for themselves.
void follow(const SweepOptions& options, int threads, std::atomic<bool>& interrupt, const Ranks& ranks);

}  // namespace carom::app
