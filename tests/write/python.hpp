#pragma once
// Python, where a test has a file read by somebody else.

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "write/text_file.hpp"

namespace carom::test {

/// A python3 that has this module; none: there is no such one here.
inline std::optional<std::string> python_with(const std::string& module) {
  for (const char* python : {"python3", "/usr/bin/python3"})
    if (std::system((std::string(python) + " -c 'import " + module + "' > /dev/null 2>&1").c_str()) == 0) return python;
  return std::nullopt;
}

/// Runs a command in a shell. Returns whether it succeeded, and what it printed.
inline std::pair<bool, std::string> printed_by(const std::string& command) {
  std::FILE* pipe = popen(("{ " + command + "\n} 2>&1").c_str(), "r");
  if (pipe == nullptr) return {false, "cannot start " + command};
  std::string text;
  char part[4096];
  while (const std::size_t n = std::fread(part, 1, sizeof part, pipe)) text.append(part, n);
  return {pclose(pipe) == 0, text};
}

}  // namespace carom::test
