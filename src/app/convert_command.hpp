#pragma once
// carom convert: trajectories into one another, and snapshots into scenes.

#include <cstdint>
#include <optional>
#include <string>

#include <CLI/App.hpp>

#include "console.hpp"
#include "exit_status.hpp"

namespace carom::app {

struct ConvertOptions {
  std::string file;
  std::string to;                     ///< a format (csv, h5, xyz, toml) or a file name with such an ending; empty: toml
  std::string out;                    ///< file to write; empty: by `to`
  std::optional<std::int64_t> frame;  ///< from 0; negative: from the end. None: all, or the last for a scene
  std::optional<double> radius;       ///< [length] where the file has none
  double temperature = 1.0;           ///< k_B T [energy] where a scene needs velocities and the file has none
  std::uint64_t seed = 1;             ///< of those
};

CLI::App* add_convert_command(CLI::App& program, ConvertOptions& options);

/// Throws InputError and OutputError.
ExitStatus convert(const ConvertOptions& options, const Console& console);

}  // namespace carom::app
