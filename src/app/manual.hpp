#pragma once
// The manual page.

#include <string>

#include "command_tree.hpp"

namespace carom::app {

/// carom(1), for `man`.
[[nodiscard]] std::string manual_page(const CommandTree& tree);

}  // namespace carom::app
