#pragma once
// What must hold in every run, whatever the scene.

#include <atomic>
#include <cstdint>
#include <string>

namespace carom::testing {

struct Verdict {
  bool refused = false;  ///< the scene is wrong, and the reader or the world says so
  std::int64_t collisions = 0;
  double energy_error = 0.0;    ///< largest error of the balance, over what rounding explains (rounding_books.hpp)
  double momentum_error = 0.0;  ///< and of the total momentum
  std::string complaint;        ///< empty: nothing is wrong
};

inline constexpr std::int64_t most_collisions = 200;

/// Runs the scene twice, by the composition that it gets and by another queue and search: no overlap deeper than rounding
/// and no ball out of what encloses it at a full audit every few collisions, energy and momentum balanced to what the
/// roundings of the run add up to (rounding_books.hpp), no event in the past, everything finite, no elastic run given up
/// unless its balls are wedged (wedged.hpp), one log.
/// `interrupt`, set by another thread, ends a run that does not end.
[[nodiscard]] Verdict judge_scene(const std::string& text, const std::atomic<bool>& interrupt);

}  // namespace carom::testing
