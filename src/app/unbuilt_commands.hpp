#pragma once
// Commands of the interface that are not there yet: refused by name.

#include <string_view>

namespace carom::app {

[[nodiscard]] bool is_unbuilt_command(std::string_view name);

}  // namespace carom::app
