#pragma once
// carom plot: figures of a folder of results, drawn by gnuplot.

#include <string>

#include <CLI/App.hpp>

#include "console.hpp"
#include "exit_status.hpp"

namespace carom::app {

struct PlotOptions {
  std::string folder;
  std::string format = "svg";  ///< svg or png
  std::string out;             ///< folder for the figures; empty: plots in the folder
};

CLI::App* add_plot_command(CLI::App& program, PlotOptions& options);

/// Throws InputError and OutputError.
ExitStatus plot(const PlotOptions& options, const Console& console);

}  // namespace carom::app
