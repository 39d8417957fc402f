#include "completion.hpp"

#include <fmt/core.h>

namespace carom::app {

namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string command_names(const CommandTree& tree) {
  std::vector<std::string> names;
  for (const CommandText& command : tree.commands) names.push_back(command.name);
  return joined(names, " ");
}

std::string option_names(const CommandText& command) {
  std::vector<std::string> names;
  for (const OptionText& option : command.options)
    if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
  return joined(names, " ");
}

/// Between single quotes: a quote ends them, stands for itself, and begins them anew.
std::string single_quoted(const std::string& text) {
  std::string s = "'";
  for (const char c : text) s += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return s + "'";
}

std::string bash_case(const CommandText& command) {
  std::string values, words;
  for (const OptionText& option : command.options) {
    const std::string choices = joined(option.choices, " ");
    if (option.positional) words += choices;
    if (option.positional || option.value.empty()) continue;
    const std::string reply = choices.empty() ? "return" : "COMPREPLY=($(compgen -W \"" + choices + "\" -- \"$word\")); return";
    values += fmt::format("        {}) {} ;;\n", joined(option.names, "|"), reply);
  }
  std::string s = fmt::format("    {})\n", command.name);
  if (!values.empty()) s += "      case \"$before\" in\n" + values + "      esac\n";
  s += fmt::format("      if [[ $word == -* ]]; then COMPREPLY=($(compgen -W \"{}\" -- \"$word\"))", option_names(command));
  if (!words.empty()) s += fmt::format("\n      else COMPREPLY=($(compgen -W \"{}\" -- \"$word\"))", words);
  return s + "; fi ;;\n";
}

// What is not said here (scenes, folders, files) bash completes as file names.
std::string bash(const CommandTree& tree) {
  std::string s = "# Completion of carom's command line in bash: source <(carom completion bash)\n"
                  "_carom() {\n"
                  "  local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD - 1]}\"\n"
                  "  COMPREPLY=()\n"
                  "  if ((COMP_CWORD == 1)); then\n";
  s += fmt::format("    COMPREPLY=($(compgen -W \"{} {}\" -- \"$word\"))\n    return\n  fi\n", command_names(tree),
                   option_names(tree.program));
  s += "  case \"${COMP_WORDS[1]}\" in\n";
  for (const CommandText& command : tree.commands) s += bash_case(command);
  return s + "  esac\n}\ncomplete -o default -o filenames -F _carom carom\n";
}

/// Brackets and colons are signs of _arguments.
std::string zsh_text(const std::string& text) {
  std::string s;
  for (const char c : text) s += c == '[' || c == ']' || c == ':' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return s;
}

std::string zsh_action(const OptionText& option) {
  return option.choices.empty() ? "_files" : "(" + joined(option.choices, " ") + ")";
}

std::string zsh(const CommandTree& tree) {
  std::string s = "#compdef carom\n# Completion of carom's command line in zsh: carom completion zsh > DIR/_carom, DIR in $fpath\n"
                  "_carom() {\n  local -a commands\n  commands=(\n";
  for (const CommandText& command : tree.commands)
    s += "    " + single_quoted(command.name + ":" + zsh_text(command.description)) + "\n";
  s += "  )\n  if ((CURRENT == 2)); then\n    _describe command commands\n    return\n  fi\n"
       "  shift words\n  ((CURRENT--))\n  case $words[1] in\n";
  for (const CommandText& command : tree.commands) {
    s += fmt::format("    {})\n      _arguments", command.name);
    for (const OptionText& option : command.options) {
      if (option.positional) {
        s += " \\\n        " + single_quoted(":" + option.names.front() + ":" + zsh_action(option));
        continue;
      }
      for (const std::string& name : option.names) {
        std::string spec = "*" + name + "[" + zsh_text(option.description) + "]";
        if (!option.value.empty()) spec += ":" + zsh_text(option.choices.empty() ? option.value : "value") + ":" + zsh_action(option);
        s += " \\\n        " + single_quoted(spec);
      }
    }
    s += " ;;\n";
  }
  return s + "  esac\n}\n_carom \"$@\"\n";
}

std::string fish(const CommandTree& tree) {
  std::string s = "# Completion of carom's command line in fish: carom completion fish | source\n";
  for (const CommandText& command : tree.commands)
    s += fmt::format("complete -c carom -n __fish_use_subcommand -f -a {} -d {}\n", command.name, single_quoted(command.description));
  for (const CommandText& command : tree.commands) {
    for (const OptionText& option : command.options) {
      std::string line = fmt::format("complete -c carom -n '__fish_seen_subcommand_from {}'", command.name);
      if (option.positional && option.choices.empty()) continue;  // a file
      if (!option.positional)
        for (const std::string& name : option.names) line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.value.empty() && !option.positional) line += " -r";
      if (!option.choices.empty()) line += " -f -a " + single_quoted(joined(option.choices, " "));
      s += line + " -d " + single_quoted(option.description) + "\n";
    }
  }
  return s;
}

}  // namespace

std::string completion_script(const CommandTree& tree, const std::string& shell) {
  return shell == "bash" ? bash(tree) : shell == "zsh" ? zsh(tree) : fish(tree);
}

}  // namespace carom::app
