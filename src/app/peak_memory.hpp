#pragma once
// Memory of this process.

namespace carom::app {

/// Largest resident memory so far, in MiB: since the start, or since it was forgotten.
[[nodiscard]] double peak_memory_mb();

/// From now on the peak is counted anew, from what is resident now. False where the system cannot (Linux can).
bool forget_peak_memory();

}  // namespace carom::app
