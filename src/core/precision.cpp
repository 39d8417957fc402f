#include "carom/core/precision.hpp"

#include <charconv>

#include "carom/core/error.hpp"

namespace carom {

std::string Precision::text() const {
  switch (kind) {
    case Kind::ieee_double:
      return "double";
    case Kind::long_double:
      return "long-double";
    case Kind::decimal:
      return std::to_string(digits);
  }
  return "";
}

Precision parse_precision(std::string_view text) {
  if (text == "double") return {};
  if (text == "long-double") return {Precision::Kind::long_double, 0};
  int digits = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), digits);
  if (error != std::errc() || end != text.data() + text.size() || digits < Precision::least_digits ||
      digits > Precision::most_digits)
    throw InputError(Problem{"", 0, "precision \"" + std::string(text) + "\"",
                             "it is double, long-double, or a number of decimal digits from " +
                                 std::to_string(Precision::least_digits) + " to " + std::to_string(Precision::most_digits),
                             "Try 50"});
  return Precision::decimal(digits);
}

}  // namespace carom
