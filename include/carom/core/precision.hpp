#pragma once
// The arithmetic that a run is carried out in, as a user names it.

#include <cstdint>
#include <string>
#include <string_view>

namespace carom {

/// double (53 bits), long double (64 bits on x86), or a number of decimal digits (MPFR).
struct Precision {
  enum class Kind : std::uint8_t { ieee_double, long_double, decimal };

  Kind kind = Kind::ieee_double;
  int digits = 0;  ///< significant decimal digits, least_digits .. most_digits; decimal only

  static constexpr int least_digits = 17;
  static constexpr int most_digits = 100'000;

  [[nodiscard]] static constexpr Precision decimal(int digits) { return {Kind::decimal, digits}; }
  [[nodiscard]] bool is_double() const noexcept { return kind == Kind::ieee_double; }
  [[nodiscard]] std::string text() const;  ///< "double", "long-double", "50"
};

/// Reads what `text` gives. Throws InputError.
[[nodiscard]] Precision parse_precision(std::string_view text);

}  // namespace carom
