// The program carom.

#include <csignal>
#include <string>
#include <vector>

#include "command_line.hpp"

int main(int count, char** words) {
  using namespace carom::app;
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is a failed write, which is told, and no end
  const std::vector<std::string> arguments(words + (count > 0 ? 1 : 0), words + count);
  return static_cast<int>(perform(parse(arguments), Console::standard()));
}
