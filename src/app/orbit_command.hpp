#pragma once
// carom orbit: an approximate periodic orbit, refined, and how stable it is.

#include <cstdint>
#include <string>

#include <CLI/App.hpp>

#include "console.hpp"
#include "exit_status.hpp"
#include "scene_arguments.hpp"

namespace carom::app {

struct OrbitOptions {
  SceneArguments scene;
  std::int64_t period = 0;           ///< collisions
  std::string precision = "double";  ///< of the result
  bool json = false;
};

CLI::App* add_orbit_command(CLI::App& program, OrbitOptions& options);

/// Throws InputError. A start from which no orbit is found is said on standard error: status 3.
ExitStatus orbit(const OrbitOptions& options, const Console& console);

}  // namespace carom::app
