#include "reading.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>

#include "carom/write/number_text.hpp"

namespace carom {

LineReader::LineReader(const std::string& path) : path_(path) {
  errno = 0;
  in_.open(path, std::ios::binary);
  if (!in_ || in_.peek() == std::ifstream::traits_type::eof())
    throw InputError(Problem{"", 0, "cannot read \"" + path + "\"", errno != 0 ? std::strerror(errno) : "the file is empty",
                             "Check the name"});
}

bool LineReader::next(std::string& line) {
  if (!std::getline(in_, line)) return false;
  ++line_;
  if (line.ends_with('\r')) line.pop_back();
  return true;
}

void LineReader::refuse(const std::string& what, const std::string& why, const std::string& hint) const {
  throw InputError(Problem{path_, line_, what, why, hint});
}

Number LineReader::number(std::string_view text) const {
  double value = 0.0;
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || digits.empty())
    refuse("\"" + std::string(text) + "\" is no number", "a number is needed here");
  Number number(value);
  if (std::isfinite(value) && number_text(value) != digits) number.text = digits;
  return number;
}

std::int64_t LineReader::integer(std::string_view text) const {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty())
    refuse("\"" + std::string(text) + "\" is no whole number", "a whole number is needed here");
  return value;
}

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\v\f\r";
  std::vector<std::string_view> words;
  for (std::size_t from = line.find_first_not_of(blanks); from != std::string_view::npos;) {
    const std::size_t to = std::min(line.find_first_of(blanks, from), line.size());
    words.push_back(line.substr(from, to - from));
    from = line.find_first_not_of(blanks, to);
  }
  return words;
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t from = 0;;) {
    const std::size_t to = std::min(line.find(',', from), line.size());
    cells.push_back(line.substr(from, to - from));
    if (to == line.size()) return cells;
    from = to + 1;
  }
}

}  // namespace carom
