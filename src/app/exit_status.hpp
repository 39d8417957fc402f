#pragma once
// What the program's exit status says.

namespace carom::app {

enum class ExitStatus : int {
  done = 0,
  bug = 1,          ///< in carom
  wrong_input = 2,  ///< the scene or the command line; nothing was written
  stopped = 3,      ///< going on would be meaningless, or output could not be written
};

/// Ended by a signal: 130 on Ctrl-C, 143 on termination.
[[nodiscard]] constexpr ExitStatus ended_by(int signal) noexcept { return static_cast<ExitStatus>(128 + signal); }

}  // namespace carom::app
