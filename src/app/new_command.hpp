#pragma once
// carom new: writes a commented scene from the gallery.

#include <string>

#include <CLI/App.hpp>

#include "console.hpp"
#include "exit_status.hpp"

namespace carom::app {

struct NewOptions {
  std::string name;   ///< of a scene of the gallery
  std::string out;    ///< file; empty: NAME.toml
  bool list = false;  ///< names the scenes instead
};

CLI::App* add_new_command(CLI::App& program, NewOptions& options);

/// Never overwrites. Throws InputError and OutputError.
ExitStatus new_scene(const NewOptions& options, const Console& console);

}  // namespace carom::app
