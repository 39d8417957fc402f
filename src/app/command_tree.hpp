#pragma once
// The commands and options of the program, as data: what completion and the manual page are made from.

#include <string>
#include <vector>

#include <CLI/App.hpp>

namespace carom::app {

struct OptionText {
  std::vector<std::string> names;    ///< "-o", "--out"; of an argument without dashes its name, "SCENE"
  std::string value;                 ///< what its value is called, "DIR"; empty: it takes none
  std::vector<std::string> choices;  ///< the values that there are; empty: any
  std::string description;
  bool positional = false;
};

struct CommandText {
  std::string name, description;
  std::vector<OptionText> options;
  std::string footer;  ///< examples and more
};

/// The program itself, then each command by name.
struct CommandTree {
  CommandText program;
  std::vector<CommandText> commands;
};

[[nodiscard]] CommandTree command_tree(const CLI::App& program);

}  // namespace carom::app
