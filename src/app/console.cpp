#include "console.hpp"

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string_view>

namespace carom::app {

Console Console::standard() {
  const auto set = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
  };
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
  const bool colour = isatty(STDOUT_FILENO) != 0 && !set("NO_COLOR") && !dumb;
  return {std::cout, std::cerr, isatty(STDERR_FILENO) != 0 && !dumb, colour ? Colour::on : Colour::off};
}

}  // namespace carom::app
