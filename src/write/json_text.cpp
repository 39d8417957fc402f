#include "json_text.hpp"

#include <cmath>

#include "carom/write/number_text.hpp"

namespace carom {

namespace {

void append_double(std::string& text, double x) {
  if (!std::isfinite(x)) {
    text += "null";
    return;
  }
  const std::size_t begin = text.size();
  append_number(text, x);
  if (text.find_first_of(".e", begin) == std::string::npos) text += ".0";  // a double stays one when it is read back
}

std::string quoted(const std::string& s) { return Json(s).dump(-1, ' ', false, Json::error_handler_t::replace); }

// `indent` counts the levels whose elements stand on lines of their own; -1: on one line from here on.
void append(std::string& text, const Json& j, int indent);

void start_line(std::string& text, int indent) {
  text += '\n';
  text.append(2 * static_cast<std::size_t>(indent), ' ');
}

void append_elements(std::string& text, const Json& j, int indent, bool on_lines) {
  bool first = true;
  for (auto it = j.begin(); it != j.end(); ++it) {
    if (!first) text += on_lines ? "," : ", ";
    first = false;
    if (on_lines) start_line(text, indent + 1);
    if (j.is_object()) text += quoted(it.key()) + ": ";
    append(text, *it, on_lines && j.is_object() ? indent + 1 : -1);
  }
  if (on_lines) start_line(text, indent);
}

void append(std::string& text, const Json& j, int indent) {
  if (j.is_object()) {
    text += '{';
    append_elements(text, j, indent, indent == 0 && !j.empty());
    text += '}';
  } else if (j.is_array()) {
    text += '[';
    append_elements(text, j, indent, indent >= 0 && !j.empty() && !j.front().is_number());
    text += ']';
  } else if (j.is_number_float()) {
    append_double(text, j.get<double>());
  } else if (j.is_string()) {
    text += quoted(j.get<std::string>());
  } else {
    text += j.dump();
  }
}

}  // namespace

std::string json_text(const Json& object) {
  std::string text;
  append(text, object, 0);
  return text + '\n';
}

std::string json_line(const Json& object) {
  std::string text;
  append(text, object, -1);
  return text;
}

}  // namespace carom
