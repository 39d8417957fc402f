#include "peak_memory.hpp"

#include <sys/resource.h>

namespace carom::app {

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // KiB on Linux
}

}  // namespace carom::app
