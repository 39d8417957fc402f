// The program carom.

#include <string>
#include <vector>

#include "command_line.hpp"

int main(int count, char** words) {
  using namespace carom::app;
  const std::vector<std::string> arguments(words + (count > 0 ? 1 : 0), words + count);
  return static_cast<int>(perform(parse(arguments), Console::standard()));
}
