#include "override.hpp"

#include <charconv>
#include <optional>
#include <utility>

#include "words.hpp"

namespace carom::scene_text {

namespace {

// a.0."b.c" -> {a, 0, b.c}. Nothing if a part is empty or a quote is left open.
std::optional<Path> split(std::string_view key) {
  Path path;
  while (true) {
    std::string part;
    if (!key.empty() && (key.front() == '"' || key.front() == '\'')) {
      const std::size_t end = key.find(key.front(), 1);
      if (end == std::string_view::npos) return std::nullopt;
      part = key.substr(1, end - 1);
      key.remove_prefix(end + 1);
    } else {
      part = key.substr(0, key.find('.'));
      key.remove_prefix(part.size());
      if (part.empty()) return std::nullopt;
    }
    path.push_back(std::move(part));
    if (key.empty()) return path;
    if (key.front() != '.') return std::nullopt;
    key.remove_prefix(1);
  }
}

std::optional<std::size_t> to_index(const std::string& part) {
  std::size_t i = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), i);
  if (error != std::errc() || end != part.data() + part.size()) return std::nullopt;
  return i;
}

class Setter {
 public:
  Setter(Report& report, std::size_t index) : report_(report), index_(index) {}

  void set(toml::table& scene) {
    const Override& o = report_.overrides()[index_];
    const std::optional<Path> path = split(o.key);
    if (!path) return problem("there is no key " + in_quotes(o.key), "a key is a dotted path, as ball.0.velocity");
    constexpr std::size_t deepest = 16;
    if (path->size() > deepest) return problem("there is no key " + in_quotes(o.key), "no key is that deep");
    toml::table value = report_.parse_override(index_);
    if (toml::node* v = value.get("value")) set(scene, *path, *v);
  }

 private:
  void set(toml::table& scene, const Path& path, toml::node& value) {
    toml::node* at = &scene;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const bool last = i + 1 == path.size();
      const Path above(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(i));
      if (toml::table* table = at->as_table()) {
        if (last || !table->contains(path[i])) assign(*table, path[i], last ? value : *new_table().get("value"));
        at = table->get(path[i]);
      } else if (toml::array* array = at->as_array()) {
        const std::optional<std::size_t> element = to_index(path[i]);
        if (!element || *element >= array->size()) return no_element(above, path[i], array->size());
        if (last) replace(*array, *element, value);
        at = array->get(*element);
      } else {
        return problem(dotted(above) + " has no " + in_quotes(path[i]), "it is a value, not a table");
      }
    }
  }

  static void assign(toml::table& table, const std::string& key, toml::node& value) {
    value.visit([&](auto& v) { table.insert_or_assign(key, std::move(v)); });
  }

  static void replace(toml::array& array, std::size_t i, toml::node& value) {
    value.visit([&](auto& v) { array.replace(array.cbegin() + static_cast<std::ptrdiff_t>(i), std::move(v)); });
  }

  void no_element(const Path& array, const std::string& part, std::size_t size) {
    problem("there is no " + dotted(array / part),
            dotted(array) + " has " + std::to_string(size) + (size == 1 ? " element" : " elements") + ", numbered from 0");
  }

  // An empty table, kept in one that knows this override as its source.
  toml::table& new_table() {
    created_ = Document("value = {}").parse(std::to_string(index_ + 1));
    return created_;
  }

  void problem(std::string what, std::string why) { report_.add_override(index_, std::move(what), std::move(why)); }

  Report& report_;
  std::size_t index_;
  toml::table created_;
};

}  // namespace

void apply_overrides(toml::table& scene, Report& report) {
  for (std::size_t i = 0; i < report.overrides().size(); ++i) Setter(report, i).set(scene);
}

}  // namespace carom::scene_text
