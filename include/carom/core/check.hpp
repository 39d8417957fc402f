#pragma once
// Contracts between parts of carom. A violation is a bug in the program, never the user's fault.

#include <cstdio>
#include <cstdlib>

namespace carom::detail {
[[noreturn]] inline void broken_contract(const char* kind, const char* text, const char* file, int line) {
  std::fprintf(stderr, "carom: %s violated: %s (%s:%d). This is a bug in carom.\n", kind, text, file, line);
  std::abort();
}
}  // namespace carom::detail

// On in Debug and RelWithDebInfo, off in Release (CMake defines CAROM_CHECKS).
#ifdef CAROM_CHECKS
#define CAROM_EXPECT(condition) \
  ((condition) ? void(0) : ::carom::detail::broken_contract("precondition", #condition, __FILE__, __LINE__))
#define CAROM_ENSURE(condition) \
  ((condition) ? void(0) : ::carom::detail::broken_contract("postcondition", #condition, __FILE__, __LINE__))
#else
#define CAROM_EXPECT(condition) void(0)
#define CAROM_ENSURE(condition) void(0)
#endif
