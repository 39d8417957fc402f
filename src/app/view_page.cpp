#include "view_page.hpp"

#include <utility>

#include "write/base64.hpp"

namespace carom::app {

std::string json_in_page(const Json& object) {
  std::string text;
  for (const char c : json_text(object)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

ViewPage::ViewPage(std::string path, const PageParts& parts, int dimension)
    : file_(std::move(path)), parts_(parts), dimension_(dimension) {
  put(parts.head);
  file_.end_line();
}

void ViewPage::put(const PageParts::Text& text) {
  for (const std::string_view piece : text) file_.line() += piece;
}

void ViewPage::element(std::string_view attributes, std::string_view text) {
  std::string& line = file_.line();
  ((line += "<script ") += attributes) += '>';
  line += text;
  line += "</script>";
  file_.end_line();
}

void ViewPage::json(std::string_view id, const Json& object) {
  element("type=\"application/json\" id=\"" + std::string(id) + '"', json_in_page(object));
}

void ViewPage::bytes(std::string_view id, std::string_view data) {
  std::string text;
  append_base64(text, data);
  element("type=\"application/octet-stream\" id=\"" + std::string(id) + '"', text);
}

void ViewPage::chunk(std::string_view data) {
  std::string text;
  append_base64(text, data);
  element("type=\"application/octet-stream\" class=\"chunk\"", text);
}

void ViewPage::finish() {
  put(parts_.middle);
  put(dimension_ == 3 ? parts_.solid : parts_.flat);
  put(parts_.tail);
  file_.end_line();
  file_.close();
}

}  // namespace carom::app
