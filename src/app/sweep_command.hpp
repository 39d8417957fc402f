#pragma once
// carom sweep: many runs of a scene, apart in their starts or in any key, on all processors.

#include <CLI/App.hpp>

#include "console.hpp"
#include "exit_status.hpp"
#include "sweep_options.hpp"

namespace carom::app {

CLI::App* add_sweep_command(CLI::App& program, SweepOptions& options);

/// Throws InputError and OutputError.
ExitStatus sweep(const SweepOptions& options, const Console& console);

}  // namespace carom::app
