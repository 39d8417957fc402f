#pragma once
// What the process has needed.

namespace carom::app {

[[nodiscard]] double peak_memory_mb();  ///< [MiB] largest resident memory of the process so far

}  // namespace carom::app
