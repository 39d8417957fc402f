#include "words.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/core.h>

namespace carom::scene_text {

namespace {

// Levenshtein's distance, a swap of neighbours counted as one (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last.back();
}

constexpr std::size_t longest_known = 64;  // no key of carom is as long; keeps the distance cheap

}  // namespace

std::string in_quotes(std::string_view word) { return '"' + std::string(word) + '"'; }

std::string toml_string(const std::string& value) {
  std::string s = "\"";
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      s += '\\';
      s += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      s += fmt::format("\\u{:04X}", static_cast<unsigned>(byte));
    } else {
      s += c;
    }
  }
  return s + '"';
}

std::string listed(const std::vector<std::string_view>& words) {
  std::string s;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) s += i + 1 == words.size() ? " or " : ", ";
    s += in_quotes(words[i]);
  }
  return s;
}

std::string suggestion(std::string_view word, const std::vector<std::string_view>& known) {
  std::string_view best;
  std::size_t least = word.size() > longest_known ? 0 : std::max<std::size_t>(1, (word.size() + 1) / 3) + 1;
  for (const std::string_view candidate : known) {
    if (least == 0) break;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < least && distance < candidate.size()) {
      least = distance;
      best = candidate;
    }
  }
  if (!best.empty()) return "Did you mean " + in_quotes(best) + "?";
  return known.empty() ? std::string() : "Known: " + listed(known);
}

}  // namespace carom::scene_text
