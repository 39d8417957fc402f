#pragma once
// From the words of a command line to a command, and from a command to an exit status.

#include <string>
#include <variant>
#include <vector>

#include "bench_command.hpp"
#include "certify_command.hpp"
#include "check_command.hpp"
#include "compare_command.hpp"
#include "console.hpp"
#include "convert_command.hpp"
#include "exit_status.hpp"
#include "explain_command.hpp"
#include "new_command.hpp"
#include "orbit_command.hpp"
#include "plot_command.hpp"
#include "run_command.hpp"
#include "sweep_command.hpp"
#include "view_command.hpp"

namespace carom::app {

/// Something to say and nothing to do: help, the version, or what is wrong with the command line.
struct Answer {
  ExitStatus status = ExitStatus::done;
  std::string text;
};

using Command = std::variant<Answer, RunOptions, CheckOptions, CompareOptions, ConvertOptions, ExplainOptions, NewOptions, PlotOptions,
                             BenchOptions, CertifyOptions, ViewOptions, SweepOptions,
                             OrbitOptions>;

/// `words` are the arguments without the program's name.
[[nodiscard]] Command parse(const std::vector<std::string>& words);

/// Carries the command out. Errors become messages and an exit status.
ExitStatus perform(const Command& command, const Console& console);

}  // namespace carom::app
