#pragma once
// carom explain: what was composed for a scene and why, and what is not modelled.

#include <CLI/App.hpp>

#include "console.hpp"
#include "exit_status.hpp"
#include "scene_arguments.hpp"

namespace carom::app {

struct ExplainOptions {
  SceneArguments scene;
  bool json = false;
};

CLI::App* add_explain_command(CLI::App& program, ExplainOptions& options);

/// Throws InputError.
ExitStatus explain(const ExplainOptions& options, const Console& console);

}  // namespace carom::app
