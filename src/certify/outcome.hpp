#pragma once
// From a replay to a report.

#include <algorithm>
#include <cmath>

#include "carom/certify/certify.hpp"
#include "replay.hpp"

namespace carom::certify {

/// An enclosure as decimals: as many digits as are certain, and three more.
[[nodiscard]] Bounds bounds_of(const Enclosure& x, int digits);

/// The verdict that a failure stands for.
void judge(Report& report, const Finding& failure, bool interrupted);

/// Fills in digits, the end and the balls there. The replay has been finished.
void describe(Report& report, const Replay& replay, const System& system, int digits);

/// Tries until it is proven, or no more digits will help. `certain`: what is refuted is wrong. (A log of too few digits may
/// be.)
template <class F>
[[nodiscard]] Report with_more_digits(const Options& options, int first, bool certain, F&& attempt) {
  int tries = 0;
  for (int digits = first;; digits = std::min(2 * digits, std::max(options.max_digits, first))) {
    Report report = attempt(digits);
    report.tries = ++tries;
    const bool open = report.verdict == Verdict::undecided || (report.verdict == Verdict::refuted && !certain);
    if (!open || report.tie || digits >= options.max_digits) return report;
  }
}

}  // namespace carom::certify
