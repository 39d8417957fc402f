#pragma once
// Ctrl-C and termination end a run at the next event instead of killing it.

#include <atomic>

namespace carom::app {

/// While it lives, the first SIGINT or SIGTERM is caught; a second one kills. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Polled by the run. Who sets it ends the run, too.
  [[nodiscard]] std::atomic<bool>& flag() const noexcept;

  /// The signal that was caught; 0: none.
  [[nodiscard]] int signal() const noexcept;
};

}  // namespace carom::app
