#pragma once
// The scene of a command line: a file, and what is set over it.

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "carom/scene/read.hpp"
#include "carom/scene/scene.hpp"

namespace carom::app {

struct SceneArguments {
  std::string file;
  std::vector<std::string> set;  ///< KEY=VALUE
  std::string until, events;     ///< as they were written; empty: as in the scene
};

/// SCENE and --set.
void add_scene_arguments(CLI::App& command, SceneArguments& arguments);

/// Throws InputError.
[[nodiscard]] Scene read_scene(const SceneArguments& arguments);

}  // namespace carom::app
