#include "new_command.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

#include <fmt/core.h>

#include "carom/core/error.hpp"
#include "carom/write/output_file.hpp"
#include "gallery.hpp"
#include "scene/words.hpp"

namespace carom::app {

namespace {

/// The first comment line of a scene.
std::string_view subject(std::string_view text) {
  std::string_view line = text.substr(0, text.find('\n'));
  while (!line.empty() && (line.front() == '#' || line.front() == ' ')) line.remove_prefix(1);
  while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

void list(std::ostream& out) {
  std::size_t width = 0;
  for (const GalleryScene& scene : gallery()) width = std::max(width, scene.name.size());
  for (const GalleryScene& scene : gallery()) out << fmt::format("{:<{}}  {}\n", scene.name, width, subject(scene.text));
}

const GalleryScene& find(const std::string& name) {
  std::vector<std::string_view> names;
  for (const GalleryScene& scene : gallery()) {
    if (scene.name == name) return scene;
    names.push_back(scene.name);
  }
  const std::string near = scene_text::suggestion(name, names);
  const bool is_near = near.starts_with("Did you mean");  // else it lists them all, on one line
  throw InputError(Problem{"", 0, "there is no scene " + scene_text::in_quotes(name) + " in the gallery", "",
                           (is_near ? near + " " : "") + "All of them: carom new --list"});
}

void write_new(const std::string& path, std::string_view text) {
  const auto fail = [&path] { throw OutputError(fmt::format("cannot write \"{}\": {}. Name another file with --out FILE.", path, std::strerror(errno))); };
  std::FILE* file = std::fopen(path.c_str(), "wbx");
  if (file == nullptr && errno == EEXIST)
    throw InputError(Problem{"", 0, scene_text::in_quotes(path) + " is there already", "carom new overwrites nothing",
                             "Choose another name with --out FILE"});
  if (file == nullptr) fail();
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (std::fclose(file) != 0 || !written) fail();
}

}  // namespace

CLI::App* add_new_command(CLI::App& program, NewOptions& options) {
  CLI::App* command = program.add_subcommand("new", "Writes a commented scene from the gallery");
  command->add_option("NAME", options.name, "Scene of the gallery");
  command->add_option("--out", options.out, "File to write. DEFAULT: NAME.toml here")->type_name("FILE");
  command->add_flag("--list", options.list, "Lists the scenes of the gallery");
  command->footer("Example:\n  carom new --list\n  carom new break_shot\n  carom run break_shot.toml");
  return command;
}

ExitStatus new_scene(const NewOptions& options, const Console& console) {
  if (options.list) {
    list(console.out);
    return ExitStatus::done;
  }
  if (options.name.empty())
    throw InputError(Problem{"", 0, "NAME is missing", "it says which scene to write", "See carom new --list"});
  const GalleryScene& scene = find(options.name);
  const std::string path = options.out.empty() ? options.name + ".toml" : options.out;
  write_new(path, scene.text);
  console.out << fmt::format("Wrote {}. Run it: carom run {}\n", path, path);
  return ExitStatus::done;
}

}  // namespace carom::app
