#pragma once
// From what an engine says of its contacts to what a step reports: which contact begins, lasts, or ends.

#include <compare>
#include <cstdint>
#include <map>
#include <vector>

#include "carom/sim/stepper.hpp"
#include "layout.hpp"

namespace carom::game_engine {

struct ContactKey {
  EventKind kind = EventKind::none;
  std::uint32_t ball = 0, partner = 0;
  std::int32_t feature = 0;

  friend auto operator<=>(const ContactKey&, const ContactKey&) = default;
};

/// What ends a run of contact: a step in which it was not seen, or the engine's word alone.
enum class RunEnd : std::uint8_t { silence, word };

class ContactRuns {
 public:
  explicit ContactRuns(RunEnd end) : end_(end) {}

  /// The engine has this pair in contact in the present step. Called again, the deeper overlap and the sum of the impulses
  /// hold.
  void touch(const ContactKey& key, double overlap, double impulse);

  /// The engine says that a contact is over.
  void end(const ContactKey& key) { runs_.erase(key); }

  /// Gives the contacts of the step to `sink`, in the order in which they were first seen.
  void finish_step(const Layout& layout, double time, std::int64_t step, const StepSink& sink);

 private:
  struct Run {
    bool counted = false;     ///< its impulse was reported
    std::int64_t found = -1;  ///< place in found_; -1: not seen in this step
  };
  struct Found {
    ContactKey key;
    bool counts = false;
    double overlap = 0.0, impulse = 0.0;
  };

  RunEnd end_;
  std::map<ContactKey, Run> runs_{};
  std::vector<Found> found_{};
};

/// The key of a contact between two parties, at least one of them a ball. `x` is where the ball of a wall contact is.
[[nodiscard]] ContactKey contact_key(const Party& a, const Party& b, const Point& x, const Point& drift);

}  // namespace carom::game_engine
