#pragma once
// Scripts by which shells complete the words of a command line.

#include <string>

#include "command_tree.hpp"

namespace carom::app {

/// `shell` is bash, zsh or fish.
[[nodiscard]] std::string completion_script(const CommandTree& tree, const std::string& shell);

}  // namespace carom::app
