#pragma once
// carom run: moves a scene to its end, writes its files and prints what came out.

#include <optional>
#include <string>

#include <CLI/App.hpp>

#include "console.hpp"
#include "exit_status.hpp"
#include "scene_arguments.hpp"

namespace carom::app {

struct RunOptions {
  SceneArguments scene;
  std::string precision = "double";
  std::string resume;  ///< checkpoint to go on from; empty: none
  std::string checkpoint;  ///< file for the state at the end; empty: as in the scene
  std::string out;     ///< folder for the output files; empty: where the program was started
  std::optional<int> live;  ///< port of the page to watch it by; 0: any. None: not served
  bool json = false;   ///< the result as one JSON object
  bool final = false;  ///< with the state of every ball at the end
  bool quiet = false;  ///< no progress, no table, no notes
};

CLI::App* add_run_command(CLI::App& program, RunOptions& options);

/// Throws InputError and OutputError; then nothing has been printed.
ExitStatus run(const RunOptions& options, const Console& console);

}  // namespace carom::app
