#pragma once
// What must hold in every run, whatever the scene.

#include <atomic>
#include <cstdint>
#include <string>

namespace carom::testing {

struct Verdict {
  bool refused = false;  ///< the scene is wrong, and the reader or the world says so
  std::int64_t collisions = 0;
  double energy_error = 0.0;  ///< of the balance, in units of 2^-53 (16 + collisions) times the energy that was rounded
  std::string complaint;      ///< empty: nothing is wrong
};

inline constexpr std::int64_t most_collisions = 200;

/// Runs the scene twice, by the composition that it gets and by another queue and search: no overlap deeper than rounding
/// and no ball out of what encloses it at a full audit every few collisions, energy balanced to 2^-53 (16 + collisions) of
/// what was rounded, momentum to 1e-14, no event in the past, everything finite, no elastic run given up, one log.
/// `interrupt`, set by another thread, ends a run that does not end.
[[nodiscard]] Verdict judge_scene(const std::string& text, const std::atomic<bool>& interrupt);

}  // namespace carom::testing
