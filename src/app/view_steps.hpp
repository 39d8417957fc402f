#pragma once
// A run by time steps beside the exact one, for the page of `carom view --compare`.

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "carom/observe/course.hpp"
#include "compare_plan.hpp"
#include "write/json_text.hpp"

namespace carom::app {

/// What the page is given. `places`, little-endian f64 for F frames of N balls in D dimensions: the frames' times[F],
/// positions[F N D].
struct ViewSteps {
  Json head;  ///< method, dt, steps, frames, missed (event numbers from 0, ascending), tally, parted_at (null: never)
  std::string places;
};

/// Reads "DT" or "DT,METHOD"; METHOD is one of carom's own (DEFAULT: discrete) or a game engine. Throws InputError, also if
/// the scene cannot be moved that way.
[[nodiscard]] PlannedRow plan_view_steps(const std::string& text, const Scene& scene);

/// Moves `scene` by steps up to `end`, as many as end there or before. `event_of[m]` is the number in the log of the
/// course's meeting m. Frames are thinned evenly until they fit.
[[nodiscard]] ViewSteps make_view_steps(const Scene& scene, const PlannedRow& row, const Course& course, double end,
                                        const std::vector<std::int64_t>& event_of, const std::atomic<bool>& interrupt);

}  // namespace carom::app
