#include "carom/write/number_text.hpp"

#include <charconv>

#include <fmt/core.h>

namespace carom {

namespace {

template <class T>
void append_shortest(std::string& text, T x) {
  char digits[32];  // the longest double is -2.2250738585072014e-308
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, x);
  text.append(digits, end);
}

}  // namespace

void append_number(std::string& text, double x) { append_shortest(text, x); }
void append_number(std::string& text, std::int64_t x) { append_shortest(text, x); }

void append_number(std::string& text, const Number& x) {
  if (x.text.empty()) {
    append_number(text, x.value);
  } else {
    text += x.text;
  }
}

std::string number_text(double x) {
  std::string text;
  append_number(text, x);
  return text;
}

std::string hex_text(double x) { return fmt::format("{:a}", x); }

}  // namespace carom
