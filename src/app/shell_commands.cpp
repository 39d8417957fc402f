#include "shell_commands.hpp"

#include <CLI/Validators.hpp>

namespace carom::app {

CLI::App* add_completion_command(CLI::App& program, CompletionOptions& options) {
  CLI::App* command = program.add_subcommand("completion", "Prints the script by which a shell completes carom's command line");
  command->add_option("SHELL", options.shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->footer(
      "Example:\n  carom completion bash > ~/.local/share/bash-completion/completions/carom\n"
      "  carom completion fish > ~/.config/fish/completions/carom.fish");
  return command;
}

CLI::App* add_man_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("man", "Prints the manual page");
  command->footer("Example:\n  carom man | man -l -");
  return command;
}

}  // namespace carom::app
