#pragma once
// A contact as a comparison of runs sees it, and what two lists of them have in common.

#include <cstdint>
#include <vector>

#include "carom/predict/event.hpp"

namespace carom {

/// Who met whom, when. Which edge or corner of a wall it was does not count.
struct Meeting {
  double time = 0.0;                 ///< [time]
  EventKind kind = EventKind::none;  ///< ball_ball or ball_wall
  std::uint32_t ball = 0;            ///< ball_ball: the smaller number
  std::uint32_t partner = 0;         ///< a ball's number, or a wall's
  double impulse = 0.0;              ///< [momentum] size
};

using Meetings = std::vector<Meeting>;  ///< in the order in which they were treated

/// How far two lists are compared.
struct MatchWindow {
  double end = 0.0;    ///< [time] later meetings are not judged
  double late = 0.0;   ///< [time] a meeting that should have come by `end` may come as much later, >= 0
  double early = 0.0;  ///< [time] a meeting before `end` may be due as much later, >= 0
};

/// What a run made of the meetings of the exact run. The k-th meeting of a pair (two balls, or a ball and a wall) answers
/// to the k-th of the same pair in the exact run.
struct Tally {
  std::int64_t missed = 0;        ///< exact meetings up to `end` that none answers to up to `end + late`
  std::int64_t missed_pairs = 0;  ///< pairs among them that never met
  std::int64_t spurious = 0;      ///< meetings up to `end` that answer to none of the exact run up to `end + early`
  std::int64_t swapped = 0;       ///< meetings up to `end` that are out of order; see match()
};

/// Compares `here` with `exact`. Swapped is a meeting whose exact moment is before that of the previous meeting of one of
/// its balls: an adjacent inversion in the order of one ball. What was a tie in the exact run has no order to be swapped.
/// `obstacle[b]`: ball b keeps its velocity whatever it meets, so its order is nobody's; beyond the end: it does not.
[[nodiscard]] Tally match(const Meetings& exact, const Meetings& here, const MatchWindow& window,
                          const std::vector<bool>& obstacle = {});

}  // namespace carom
