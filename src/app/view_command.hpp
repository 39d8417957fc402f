#pragma once
// carom view: runs a scene and writes one HTML page that replays it.

#include <cstdint>
#include <string>

#include <CLI/App.hpp>

#include "console.hpp"
#include "exit_status.hpp"
#include "scene_arguments.hpp"

namespace carom::app {

struct ViewOptions {
  SceneArguments scene;           ///< its file may be a folder
  std::string out;                ///< the page; empty: named after the scene, where the program was started
  std::string picture;            ///< SVG; empty: none
  std::string compare;            ///< DT or DT,METHOD; empty: no time steps
  std::int64_t most = 1'000'000;  ///< collisions that the page holds
};

CLI::App* add_view_command(CLI::App& program, ViewOptions& options);

/// Throws InputError and OutputError; on InputError nothing has been written.
ExitStatus view(const ViewOptions& options, const Console& console);

}  // namespace carom::app
