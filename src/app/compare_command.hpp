#pragma once
// carom compare: what a time step costs on a scene, method by method and step by step.

#include <string>

#include <CLI/App.hpp>

#include "console.hpp"
#include "exit_status.hpp"
#include "scene_arguments.hpp"

namespace carom::app {

struct CompareOptions {
  SceneArguments scene;
  std::string dt;       ///< [time] with commas between them
  std::string methods;  ///< with commas; empty, and no engines: all of carom's own
  std::string engines;  ///< with commas
  std::string out;      ///< folder for rows.csv, position_error.csv and events.csv; empty: none is written
  bool json = false;    ///< the result as one JSON object
};

CLI::App* add_compare_command(CLI::App& program, CompareOptions& options);

/// Runs the scene exactly once, then each stepper beside it. Throws InputError and OutputError.
ExitStatus compare(const CompareOptions& options, const Console& console);

}  // namespace carom::app
