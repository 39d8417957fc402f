#include "document.hpp"

#include <algorithm>
#include <utility>

namespace carom::scene_text {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool continues_code_point(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

bool is_literal(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '+' || c == '-' || c == '.' ||
         c == '_';
}

constexpr int deepest_key = 8;  // dots in one key; no key of carom has more than 3

// The place after the string that starts at s[i], or the end of the line or text that cuts it off.
std::size_t end_of_string(std::string_view s, std::size_t i) {
  const char quote = s[i];
  const bool multi_line = i + 2 < s.size() && s[i + 1] == quote && s[i + 2] == quote;
  const std::string delimiter(multi_line ? 3 : 1, quote);
  for (i += delimiter.size(); i < s.size(); ++i) {
    if (quote == '"' && s[i] == '\\') {
      ++i;
    } else if (s.substr(i, delimiter.size()) == delimiter) {
      i += delimiter.size();
      for (int extra = 0; multi_line && extra < 2 && i < s.size() && s[i] == quote; ++extra) ++i;
      return i;
    } else if (s[i] == '\n' && !multi_line) {
      return i;
    }
  }
  return s.size();
}

// Where a key has too many dots, or npos. A parsed table is freed recursively, so the parser must not see
// keys of many thousand parts.
std::size_t too_deep_at(std::string_view s) {
  int dots = 0;
  for (std::size_t i = 0; i < s.size();) {
    const char c = s[i];
    if (c == '"' || c == '\'') {
      i = end_of_string(s, i);
      continue;
    }
    if (c == '#') i = std::min(s.find('\n', i), s.size());
    if (c == '.') {
      if (++dots > deepest_key) return i;
    } else if (std::string_view(",=[]{}#\n").find(c) != std::string_view::npos) {
      dots = 0;
    }
    ++i;
  }
  return std::string_view::npos;
}

}  // namespace

Document::Document(std::string text) : text_(std::move(text)) {
  line_starts_.push_back(std::string_view(text_).substr(0, 3) == byte_order_mark ? byte_order_mark.size() : 0);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') line_starts_.push_back(i + 1);
  }
  last_offset_ = line_starts_.front();
}

toml::table Document::parse(std::string_view name) const {
  if (const std::size_t at = too_deep_at(text_); at != std::string_view::npos) {
    const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), at);
    throw toml::parse_error("a key with too many dots",
                            toml::source_position{static_cast<toml::source_index>(after - line_starts_.begin()), 1}, {});
  }
  return toml::parse(std::string_view(text_), name);
}

std::string Document::literal(const toml::source_position& start) {
  if (start.line < 1 || start.line > line_starts_.size()) return {};
  if (start.line != last_.line || start.column < last_.column) {
    last_ = {start.line, 1};
    last_offset_ = line_starts_[start.line - 1];
  }
  while (last_.column < start.column && last_offset_ < text_.size()) {  // columns count code points
    ++last_offset_;
    while (last_offset_ < text_.size() && continues_code_point(text_[last_offset_])) ++last_offset_;
    ++last_.column;
  }
  std::size_t end = last_offset_;
  while (end < text_.size() && is_literal(text_[end])) ++end;
  return text_.substr(last_offset_, end - last_offset_);
}

}  // namespace carom::scene_text
