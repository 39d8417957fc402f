#include "scene_arguments.hpp"

#include <array>
#include <utility>

#include "carom/core/error.hpp"

namespace carom::app {

namespace {

// Options that are short for --set.
struct Short {
  const char* option;
  const char* key;
  std::string SceneArguments::*value;
};
constexpr std::array shorts{Short{"--until", "run.until", &SceneArguments::until},
                            Short{"--events", "run.events", &SceneArguments::events}};

std::vector<Override> overrides(const SceneArguments& arguments) {
  std::vector<Override> list;
  std::vector<Problem> problems;
  for (const std::string& text : arguments.set) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      problems.push_back(
          {"", 0, "--set " + text, "it has the form KEY=VALUE", "For instance --set collision.restitution=0.9"});
    } else {
      list.push_back({text.substr(0, equals), text.substr(equals + 1)});
    }
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  for (const Short& s : shorts)
    if (const std::string& value = arguments.*s.value; !value.empty()) list.push_back({s.key, value});
  return list;
}

// Messages name what the user wrote.
std::vector<Problem> in_users_words(std::vector<Problem> problems, const SceneArguments& arguments) {
  for (Problem& p : problems)
    for (const Short& s : shorts) {
      const std::string set = "--set " + std::string(s.key) + "=" + arguments.*s.value;
      if (!(arguments.*s.value).empty() && p.what.starts_with(set))
        p.what.replace(0, set.size(), s.option + (" " + arguments.*s.value));
    }
  return problems;
}

}  // namespace

void add_scene_arguments(CLI::App& command, SceneArguments& arguments) {
  command.add_option("SCENE", arguments.file, "Scene file (TOML)")->required();
  command
      .add_option("--set", arguments.set, "Overrides a key by its dotted path, as ball.0.velocity=[1,0]; may be repeated")
      ->type_name("KEY=VALUE")
      ->type_size(1)
      ->allow_extra_args(false);
}

Scene read_scene(const SceneArguments& arguments) {
  const std::vector<Override> list = overrides(arguments);
  try {
    return read_scene_file(arguments.file, list);
  } catch (const InputError& error) {
    throw InputError(in_users_words(error.problems(), arguments));
  }
}

}  // namespace carom::app
