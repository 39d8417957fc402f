#pragma once
// Numbers as text: the shortest that reads back as the same double.

#include <cstdint>
#include <string>

#include "carom/core/number.hpp"

namespace carom {

/// Appends the shortest text that reads back as `x`, whatever the locale: "0.1", "5", "1e+22", "-0", "inf", "nan".
void append_number(std::string& text, double x);
void append_number(std::string& text, std::int64_t x);
/// All its digits where it has a text.
void append_number(std::string& text, const Number& x);

[[nodiscard]] std::string number_text(double x);

/// The exact value in hexadecimal: "0x1p-12".
[[nodiscard]] std::string hex_text(double x);

}  // namespace carom
