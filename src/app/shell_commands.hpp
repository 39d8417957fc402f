#pragma once
// carom completion, carom man: what a shell wants to know of the program.

#include <string>

#include <CLI/App.hpp>

namespace carom::app {

struct CompletionOptions {
  std::string shell;
};

CLI::App* add_completion_command(CLI::App& program, CompletionOptions& options);
CLI::App* add_man_command(CLI::App& program);

}  // namespace carom::app
