#include "node_text.hpp"

#include <sstream>

#include "words.hpp"

namespace carom::scene_text {

std::string node_text(Report& report, const toml::node& node) {
  if (node.is_number() || node.is_boolean()) return report.literal(node);
  if (const auto* text = node.as_string()) return toml_string(text->get());
  std::string s;
  if (const toml::array* array = node.as_array()) {
    for (const toml::node& element : *array) s += (s.empty() ? "" : ", ") + node_text(report, element);
    return "[" + s + "]";
  }
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table)
      s += (s.empty() ? "" : ", ") + toml_string(std::string(key.str())) + " = " + node_text(report, value);
    return "{" + s + "}";
  }
  std::ostringstream date;
  node.visit([&](const auto& value) { date << value; });
  return date.str();
}

}  // namespace carom::scene_text
