#pragma once
// A number as the user wrote it: its text, exact, beside the double nearest to it.

#include <cstddef>
#include <string>
#include <string_view>

namespace carom {

/// A decimal ("0.1", "-3e-5"), a rational ("1/3") or "inf". `value` is the double nearest to `text`.
/// A number set in code has no text; its exact value is that of the double.
struct Number {
  double value = 0.0;
  std::string text;

  Number() = default;
  Number(double v) : value(v) {}  // NOLINT(google-explicit-constructor): a double is a number
  operator double() const noexcept { return value; }  // NOLINT(google-explicit-constructor)
};

/// Characters of a number at most: enough for any precision that a run could bear, and read in milliseconds.
inline constexpr std::size_t longest_number = 10'000;

/// Reads a decimal or a rational and rounds it once. Underscores between digits are allowed, as in TOML.
/// Throws std::length_error if the text is longer than `longest_number`, std::invalid_argument if it is no number,
/// std::out_of_range if a finite one is no finite double.
/// A value that underflows to zero or to a subnormal double is out of range too.
[[nodiscard]] Number parse_number(std::string_view text);

}  // namespace carom
