#pragma once
// carom check: how far a scene's run can be believed.

#include <string>

#include <CLI/App.hpp>

#include "console.hpp"
#include "exit_status.hpp"
#include "scene_arguments.hpp"

namespace carom::app {

struct CheckOptions {
  SceneArguments scene;
  std::int64_t audits = 100;  ///< full audits along the run
  std::int64_t horizon = 20'000;  ///< collisions compared with high precision at most
  bool json = false;
};

CLI::App* add_check_command(CLI::App& program, CheckOptions& options);

/// Runs the scene, audits it, runs it again by another queue and search, and back in time. `stopped` if overlaps are found
/// or the logs differ. Throws InputError.
ExitStatus check(const CheckOptions& options, const Console& console);

}  // namespace carom::app
