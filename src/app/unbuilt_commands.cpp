#include "unbuilt_commands.hpp"

#include <algorithm>
#include <array>

namespace carom::app {

namespace {

// A name is deleted when its command is there.
constexpr std::array<std::string_view, 1> unbuilt{"orbit"};

}  // namespace

bool is_unbuilt_command(std::string_view name) { return std::find(unbuilt.begin(), unbuilt.end(), name) != unbuilt.end(); }

}  // namespace carom::app
