#include "table_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "node_text.hpp"
#include "unbuilt.hpp"
#include "words.hpp"

namespace carom::scene_text {

namespace {

std::string_view type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number with a point or an exponent";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or a time";
  }
}

bool is_index(const std::string& part) { return part.find_first_not_of("0123456789") == std::string::npos; }

}  // namespace

TableReader::TableReader(Report& report, const toml::table& table, Path path)
    : report_(report), table_(table), path_(std::move(path)) {}

const toml::node* TableReader::take(std::string_view key) {
  known_.push_back(key);
  return table_.get(key);
}

void TableReader::wrong_type(const toml::node& node, const Path& path, std::string_view needed, std::string hint) {
  report_.refuse(node, path, dotted(path) + " is " + std::string(type_name(node)), std::string(needed), std::move(hint));
}

std::optional<Number> TableReader::read_number(const toml::node& node, const Path& path) {
  std::string text;
  if (const auto* integer = node.as_integer()) {
    text = report_.literal(node);
    if (text.find_first_of("xob") != std::string::npos) text = std::to_string(integer->get());
  } else if (const auto* real = node.as_floating_point()) {
    text = report_.literal(node);
    if (text.find("nan") != std::string::npos) return Number(real->get());
  } else if (const auto* string = node.as_string()) {
    text = string->get();
  } else {
    wrong_type(node, path, "a number is needed, or a string that holds one");
    return std::nullopt;
  }
  try {
    return parse_number(text);
  } catch (const std::length_error& error) {
    report_.refuse(node, path, dotted(path) + " is " + error.what(),
                   "a number has at most " + std::to_string(longest_number));
  } catch (const std::invalid_argument&) {
    report_.refuse(node, path, dotted(path) + " is " + in_quotes(text), "a number is needed",
                   "Write a decimal, or a rational as \"1/3\"");
  } catch (const std::out_of_range&) {
    report_.refuse(node, path, dotted(path) + " is " + text,
                   "double precision holds sizes from 2.3e-308 to 1.7e308, and 0");
  }
  return std::nullopt;
}

void TableReader::number(std::string_view key, Number& to) {
  if (const toml::node* node = take(key)) to = read_number(*node, path_ / std::string(key)).value_or(to);
}

void TableReader::number(std::string_view key, std::optional<Number>& to) {
  if (const toml::node* node = take(key)) to = read_number(*node, path_ / std::string(key)).value_or(Number());
}

Coordinates TableReader::read_coordinates(const toml::node& node, const Path& path) {
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    wrong_type(node, path, "an array of numbers is needed, one for each dimension", "Write [0, 0]");
    return {};
  }
  Coordinates components;
  for (std::size_t i = 0; i < array->size(); ++i) {
    components.push_back(read_number(*array->get(i), path / std::to_string(i)).value_or(Number()));
  }
  return components;
}

void TableReader::coordinates(std::string_view key, Coordinates& to) {
  const toml::node* node = take(key);
  if (node == nullptr) return;
  const Path path = path_ / std::string(key);
  to = read_coordinates(*node, path);
  if (const toml::array* array = node->as_array(); array != nullptr && array->empty()) {
    report_.refuse(*node, path, dotted(path) + " is empty", "a vector has one number for each dimension");
  }
}

void TableReader::vertices(std::string_view key, std::vector<Coordinates>& to) {
  const toml::node* node = take(key);
  if (node == nullptr) return;
  const Path path = path_ / std::string(key);
  const toml::array* array = node->as_array();
  if (array == nullptr) return wrong_type(*node, path, "an array of points is needed", "Write [[0, 0], [1, 0], [0, 1]]");
  for (std::size_t i = 0; i < array->size(); ++i) {
    to.push_back(read_coordinates(*array->get(i), path / std::to_string(i)));
  }
}

void TableReader::integer(std::string_view key, std::int64_t& to) {
  const toml::node* node = take(key);
  if (node == nullptr) return;
  if (const auto* value = node->as_integer()) {
    to = value->get();
    return;
  }
  std::string hint;
  if (const auto* real = node->as_floating_point(); real != nullptr && std::abs(real->get()) < 1e15) {
    hint = fmt::format("Write {:.0f}", real->get());
  }
  wrong_type(*node, path_ / std::string(key), "a whole number is needed", std::move(hint));
}

void TableReader::integer(std::string_view key, std::optional<std::int64_t>& to) {
  if (!has(key)) return (void)take(key);
  integer(key, to.emplace(0));
}

void TableReader::integer(std::string_view key, int& to) {
  std::int64_t wide = to;
  integer(key, wide);
  if (wide < std::numeric_limits<int>::min() || wide > std::numeric_limits<int>::max()) {
    return refuse(key, " is " + std::to_string(wide), "the number is too large");
  }
  to = static_cast<int>(wide);
}

void TableReader::seed(std::string_view key, std::uint64_t& to) {
  std::optional<std::int64_t> value;
  integer(key, value);
  if (!value) return;
  if (*value < 0) return refuse(key, " is " + std::to_string(*value), "a seed is 0 or more");
  to = static_cast<std::uint64_t>(*value);
}

void TableReader::flag(std::string_view key, bool& to) {
  const toml::node* node = take(key);
  if (node == nullptr) return;
  if (const auto* value = node->as_boolean()) {
    to = value->get();
  } else {
    wrong_type(*node, path_ / std::string(key), "true or false is needed");
  }
}

void TableReader::text(std::string_view key, std::string& to) {
  const toml::node* node = take(key);
  if (node == nullptr) return;
  if (const auto* value = node->as_string()) {
    to = value->get();
  } else {
    wrong_type(*node, path_ / std::string(key), "a string is needed");
  }
}

void TableReader::values(std::string_view key, std::vector<std::string>& to) {
  const toml::node* node = take(key);
  if (node == nullptr) return;
  const toml::array* array = node->as_array();
  if (array == nullptr || array->empty())
    return wrong_type(*node, path_ / std::string(key), "an array of values is needed", "Write [0.5, 1.0]");
  for (const toml::node& element : *array) to.push_back(node_text(report_, element));
}

std::optional<std::string> TableReader::read_word(std::string_view key) {
  const toml::node* node = take(key);
  if (node == nullptr) return std::nullopt;
  if (const auto* value = node->as_string()) return value->get();
  wrong_type(*node, path_ / std::string(key), "a word in quotes is needed");
  return std::nullopt;
}

void TableReader::unknown_word(std::string_view key, const std::string& word, const std::vector<std::string_view>& known) {
  if (is_unbuilt(feature(key), word)) {
    report_.refuse(*table_.get(key), path_ / std::string(key), unbuilt_message(feature(key), word),
                   std::string(unbuilt_reason), "Known: " + listed(known));
    return;
  }
  const std::string near = suggestion(word, known);
  const std::string all = "it is one of " + listed(known);
  refuse(key, " is " + in_quotes(word), all, near.rfind("Did", 0) == 0 ? near : "");
}

std::string TableReader::feature(std::string_view key) const {
  std::string s;
  for (const std::string& part : path_) {
    if (!is_index(part)) s += part + ".";
  }
  return s + std::string(key);
}

std::optional<TableReader> TableReader::table(std::string_view key) {
  const toml::node* node = take(key);
  if (node == nullptr) return std::nullopt;
  const Path path = path_ / std::string(key);
  if (const toml::table* inner = node->as_table()) return TableReader(report_, *inner, path);
  const bool is_array_of_tables = node->as_array() != nullptr && node->as_array()->is_homogeneous<toml::table>();
  wrong_type(*node, path, "a table is needed", is_array_of_tables ? fmt::format("Write [{}] once", dotted(path)) : "");
  return std::nullopt;
}

const toml::array* TableReader::read_tables(std::string_view key) {
  const toml::node* node = take(key);
  if (node == nullptr || node->is_array()) return node == nullptr ? nullptr : node->as_array();
  const Path path = path_ / std::string(key);
  wrong_type(*node, path, "an array of tables is needed", fmt::format("Write [[{}]]", dotted(path)));
  return nullptr;
}

void TableReader::refuse(std::string_view key, std::string what, std::string_view why, std::string hint) {
  const Path path = path_ / std::string(key);
  report_.refuse(*table_.get(key), path, dotted(path) + what, std::string(why), std::move(hint));
}

void TableReader::require(std::string_view key, std::string_view why, std::string_view hint) {
  if (has(key)) return;
  const Path path = path_ / std::string(key);
  report_.refuse(table_, path, dotted(path) + " is missing", std::string(why), std::string(hint));
}

void TableReader::misplaced(std::string_view key, std::string_view why) {
  if (take(key) != nullptr) refuse(key, " has no meaning here", why);
}

void TableReader::unbuilt(std::string_view key) {
  report_.refuse(*table_.get(key), path_ / std::string(key), unbuilt_message(feature(key)), std::string(unbuilt_reason));
}

void TableReader::finish() {
  for (const auto& [key, node] : table_) {
    const std::string_view name = key.str();
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    const toml::source_region& at = node.source().path && key.source().begin ? key.source() : node.source();
    if (is_unbuilt(feature(name))) {
      report_.add(at, unbuilt_message(feature(name)), std::string(unbuilt_reason));
    } else {
      const std::string place = path_.empty() ? "at the top of the scene" : "in " + dotted(path_);
      report_.add(at, "unknown key " + in_quotes(name) + " " + place, "", suggestion(name, known_));
    }
  }
}

}  // namespace carom::scene_text
