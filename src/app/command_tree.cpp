#include "command_tree.hpp"

#include <algorithm>

#include "gallery.hpp"

namespace carom::app {

namespace {

/// "{a,b,c}", as CLI11 shows a set of values.
std::vector<std::string> choices_in(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.find('}');
  std::vector<std::string> choices;
  if (open == std::string::npos || close == std::string::npos) return choices;
  for (std::size_t from = open + 1; from <= close;) {
    const std::size_t to = std::min(type.find(',', from), close);
    choices.push_back(type.substr(from, to - from));
    from = to + 1;
  }
  return choices;
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  text.description = option.get_description();
  text.positional = option.get_positional();
  if (text.positional) text.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  if (option.get_items_expected_max() == 0) return text;
  const std::string type = option.get_type_name();  // NAME, NAME:a rule, or NAME:{a,b}
  text.choices = choices_in(type);
  text.value = text.choices.empty() ? type.substr(0, type.find(':')) : "";
  for (const std::string& choice : text.choices) text.value += (text.value.empty() ? "" : "|") + choice;
  return text;
}

CommandText text_of(const CLI::App& app) {
  CommandText text{app.get_name(), app.get_description(), {}, app.get_footer()};
  for (const CLI::Option* option : app.get_options()) text.options.push_back(text_of(*option));
  return text;
}

}  // namespace

CommandTree command_tree(const CLI::App& program) {
  CommandTree tree{text_of(program), {}};
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    tree.commands.push_back(text_of(*command));
  std::sort(tree.commands.begin(), tree.commands.end(),
            [](const CommandText& a, const CommandText& b) { return a.name < b.name; });
  for (CommandText& command : tree.commands)
    for (OptionText& option : command.options)
      if (command.name == "new" && option.positional)
        for (const GalleryScene& scene : gallery()) option.choices.emplace_back(scene.name);
  return tree;
}

}  // namespace carom::app
