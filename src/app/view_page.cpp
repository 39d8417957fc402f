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

namespace {

void append(std::string& text, const PageParts::Text& pieces) {
  for (const std::string_view piece : pieces) text += piece;
}

void append_element(std::string& text, std::string_view attributes, std::string_view content) {
  ((((text += "<script ") += attributes) += '>') += content) += "</script>";
}

std::string json_attributes(std::string_view id) { return "type=\"application/json\" id=\"" + std::string(id) + '"'; }
std::string bytes_attributes(std::string_view id) {
  return "type=\"application/octet-stream\" id=\"" + std::string(id) + '"';
}

std::string base64(std::string_view bytes) {
  std::string text;
  append_base64(text, bytes);
  return text;
}

void append_end(std::string& text, const PageParts& parts, int dimension) {
  append(text, parts.middle);
  append(text, dimension == 3 ? parts.solid : parts.flat);
  append(text, parts.tail);
}

}  // namespace

std::string live_page(const PageParts& parts, int dimension, const Json& scene, std::string_view start) {
  std::string text;
  append(text, parts.head);
  append_element(text, json_attributes("scene"), json_in_page(scene));
  append_element(text, bytes_attributes("start"), base64(start));
  append_end(text, parts, dimension);
  return text;
}

ViewPage::ViewPage(std::string path, const PageParts& parts, int dimension)
    : file_(std::move(path)), parts_(parts), dimension_(dimension) {
  append(file_.line(), parts.head);
  file_.end_line();
}

void ViewPage::element(std::string_view attributes, std::string_view text) {
  append_element(file_.line(), attributes, text);
  file_.end_line();
}

void ViewPage::json(std::string_view id, const Json& object) { element(json_attributes(id), json_in_page(object)); }
void ViewPage::bytes(std::string_view id, std::string_view data) { element(bytes_attributes(id), base64(data)); }
void ViewPage::chunk(std::string_view data) { element("type=\"application/octet-stream\" class=\"chunk\"", base64(data)); }

void ViewPage::finish() {
  append_end(file_.line(), parts_, dimension_);
  file_.end_line();
  file_.close();
}

}  // namespace carom::app
