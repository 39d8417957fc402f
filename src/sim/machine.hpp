#pragma once
// What the processor that this runs on can do, of what was compiled.

namespace carom {

/// Included where CAROM_HAVE_AVX2_TARGET says whether the kernels for it were compiled.
[[nodiscard]] inline bool machine_has_avx2() {
#if defined(CAROM_HAVE_AVX2_TARGET)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
  return false;
#endif
}

}  // namespace carom
