#include "carom/scene/read.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

#include "carom/scene/tables.hpp"
#include "override.hpp"
#include "reading.hpp"
#include "rules.hpp"
#include "tables.hpp"
#include "words.hpp"

namespace carom {

namespace scene_text {

namespace {

// The node at a path, or the innermost table on the way to it; null if even the first part is not there.
const toml::node* nearest_node(const toml::table& root, const Path& path) {
  const toml::node* found = nullptr;
  const toml::node* at = &root;
  for (const std::string& part : path) {
    if (const toml::table* table = at->as_table()) {
      at = table->get(part);
    } else if (const toml::array* array = at->as_array()) {
      at = array->get(std::stoul(part));  // the rules number what the reader has numbered
    } else {
      break;
    }
    if (at == nullptr) break;
    found = at;
  }
  return found;
}

}  // namespace

Reading read_all(std::string_view text, const std::string& file, const std::vector<Override>& overrides) {
  Report report(text, file, overrides);
  toml::table root = report.parse_file();
  if (!report.problems().empty()) return {{}, report.problems()};  // nothing can be said beyond a syntax error

  apply_overrides(root, report);
  Scene scene = read_tables(root, report);
  scene.file = file;
  for (Finding& f : findings(scene)) {
    if (!std::all_of(f.keys.begin(), f.keys.end(), [&](const Path& key) { return report.judged(key); })) continue;
    report.add(nearest_node(root, f.keys.front()), std::move(f.what), std::move(f.why), std::move(f.hint));
  }
  if (report.problems().empty()) scene = with_tables(std::move(scene));
  return {std::move(scene), report.problems()};
}

}  // namespace scene_text

Scene read_scene(std::string_view text, const std::string& file, const std::vector<Override>& overrides) {
  scene_text::Reading reading = scene_text::read_all(text, file, overrides);
  if (!reading.problems.empty()) throw InputError(std::move(reading.problems));
  return std::move(reading.scene);
}

Scene read_scene_file(const std::string& path, const std::vector<Override>& overrides) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in || !text) {
    const std::string why = errno != 0 ? std::strerror(errno) : "no text in it";
    throw InputError(Problem{"", 0, "cannot read the scene file " + scene_text::in_quotes(path), why, "Check its name, or write one: carom new --list"});
  }
  return read_scene(text.str(), path, overrides);
}

}  // namespace carom
