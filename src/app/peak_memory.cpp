#include "peak_memory.hpp"

#include <cstdlib>
#include <fstream>
#include <string>

#include <sys/resource.h>

namespace carom::app {

double peak_memory_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) / 1024;  // KiB
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // KiB on Linux
}

bool forget_peak_memory() {
  std::ofstream refs("/proc/self/clear_refs");
  refs << 5;
  refs.flush();
  return refs.good();
}

}  // namespace carom::app
