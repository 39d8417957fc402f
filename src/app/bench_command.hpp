#pragma once
// carom bench: collisions per second on this machine.

#include <vector>

#include <CLI/App.hpp>

#include "bench.hpp"
#include "console.hpp"
#include "exit_status.hpp"

namespace carom::app {

struct BenchOptions {
  std::vector<std::int64_t> balls{1000, 10000, 100000};
  std::vector<double> packing;  ///< empty: 0.3 and 0.49 in 3-D, 0.3 and 0.65 in 2-D, 0.3 in 1-D
  std::vector<std::string> scenes;  ///< files; if any, these are measured and no gases
  BenchCase common;
  std::string search, queue;    ///< empty: chosen by carom
  bool json = false;
};

CLI::App* add_bench_command(CLI::App& program, BenchOptions& options);

/// Throws InputError.
ExitStatus bench(const BenchOptions& options, const Console& console);

}  // namespace carom::app
