#pragma once
// What the command line says of a sweep.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene_arguments.hpp"

namespace carom::app {

struct SweepOptions {
  SceneArguments scene;
  std::vector<std::string> vary;      ///< as --vary takes it
  std::optional<std::int64_t> count;  ///< runs at each combination; none: as in the scene
  std::optional<std::uint64_t> seed;  ///< none: as in the scene
  bool zip = false;
  int threads = 0;                    ///< 0: as many as there are processors
  std::string precision = "double";
  std::string out;                    ///< folder for rows; empty: none are kept
  bool resume = false;                ///< goes on with the rows in `out`
  bool final = false;                 ///< rows with the state of every ball at the end
  bool rows = false;                  ///< prints the rows, as CSV or, with json, as JSON lines
  bool json = false;
  bool quiet = false;
};

}  // namespace carom::app
