#include "carom/core/number.hpp"
#include "carom/core/rational.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include "carom/core/check.hpp"

namespace carom {

namespace {

using boost::multiprecision::cpp_int;
using Limits = std::numeric_limits<double>;

// (-1)^negative * digits * 10^exponent. `digits` has no leading zero; empty means 0.
struct Decimal {
  bool negative = false;
  std::string digits;
  std::int64_t exponent = 0;

  // The value is in [10^(m-1), 10^m) with m = magnitude().
  [[nodiscard]] std::int64_t magnitude() const { return static_cast<std::int64_t>(digits.size()) + exponent; }
};

struct Fraction {
  bool negative = false;
  std::string numerator, denominator;  // without leading zeros; an empty numerator means 0
};

// Far beyond any double, and far from overflow when the length of a text is added.
constexpr std::int64_t exponent_cap = 1'000'000'000'000;
// Nothing outside 10^-400..10^400 is near a finite, normal double.
constexpr std::int64_t magnitude_cap = 400;

[[nodiscard]] bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool take_sign(std::string_view& s) {
  const bool negative = !s.empty() && s.front() == '-';
  if (!s.empty() && (s.front() == '-' || s.front() == '+')) s.remove_prefix(1);
  return negative;
}

// digit (_? digit)*, or nothing at all.
std::optional<std::string> take_digits(std::string_view& s) {
  std::string digits;
  while (!s.empty()) {
    if (s.front() == '_' && !digits.empty() && s.size() > 1 && is_digit(s[1])) s.remove_prefix(1);
    if (!is_digit(s.front())) break;
    digits += s.front();
    s.remove_prefix(1);
  }
  if (digits.empty()) return std::nullopt;
  return digits;
}

void drop_leading_zeros(std::string& digits) { digits.erase(0, digits.find_first_not_of('0')); }

std::optional<Decimal> scan_decimal(std::string_view s) {
  Decimal d;
  d.negative = take_sign(s);
  const auto whole = take_digits(s);
  if (!whole) return std::nullopt;
  d.digits = *whole;
  if (!s.empty() && s.front() == '.') {
    s.remove_prefix(1);
    const auto decimals = take_digits(s);
    if (!decimals) return std::nullopt;
    d.digits += *decimals;
    d.exponent -= static_cast<std::int64_t>(decimals->size());
  }
  if (!s.empty() && (s.front() == 'e' || s.front() == 'E')) {
    s.remove_prefix(1);
    const bool negative = take_sign(s);
    const auto digits = take_digits(s);
    if (!digits) return std::nullopt;
    std::int64_t e = 0;
    for (const char c : *digits) e = std::min(exponent_cap, 10 * e + (c - '0'));
    d.exponent += negative ? -e : e;
  }
  if (!s.empty()) return std::nullopt;
  drop_leading_zeros(d.digits);
  return d;
}

std::optional<Fraction> scan_fraction(std::string_view s) {
  Fraction f;
  f.negative = take_sign(s);
  auto numerator = take_digits(s);
  if (!numerator || s.empty() || s.front() != '/') return std::nullopt;
  s.remove_prefix(1);
  auto denominator = take_digits(s);
  if (!denominator || !s.empty()) return std::nullopt;
  drop_leading_zeros(*numerator);
  drop_leading_zeros(*denominator);
  if (denominator->empty()) return std::nullopt;
  f.numerator = std::move(*numerator);
  f.denominator = std::move(*denominator);
  return f;
}

[[noreturn]] void refuse_range(std::string_view text) {
  throw std::out_of_range("\"" + std::string(text) + "\" does not fit double precision");
}

// Checked before any big integer is built, so that "1e999999999" costs nothing.
void require_range(std::int64_t magnitude, std::string_view text) {
  if (std::abs(magnitude) > magnitude_cap) refuse_range(text);
}

double require_normal(double v, bool is_zero, std::string_view text) {
  if (is_zero) return v;
  if (!std::isfinite(v) || std::abs(v) < Limits::min()) refuse_range(text);
  return v;
}

cpp_int power_of_ten(std::int64_t n) { return boost::multiprecision::pow(cpp_int(10), static_cast<unsigned>(n)); }

Rational to_rational(const Decimal& d, std::string_view text) {
  if (d.digits.empty()) return 0;
  require_range(d.magnitude(), text);
  const cpp_int digits((d.negative ? "-" : "") + d.digits);
  if (d.exponent >= 0) return Rational(digits * power_of_ten(d.exponent));
  return Rational(digits, power_of_ten(-d.exponent));
}

Rational to_rational(const Fraction& f, std::string_view text) {
  if (f.numerator.empty()) return 0;
  require_range(static_cast<std::int64_t>(f.numerator.size()) - static_cast<std::int64_t>(f.denominator.size()), text);
  return Rational(cpp_int((f.negative ? "-" : "") + f.numerator), cpp_int(f.denominator));
}

double to_double(const Decimal& d, std::string_view text) {
  double v = 0.0;
  if (!d.digits.empty()) {
    require_range(d.magnitude(), text);
    const std::string plain = d.digits + "e" + std::to_string(d.exponent);
    std::from_chars(plain.data(), plain.data() + plain.size(), v);  // leaves 0 where it reports a range error
  }
  return require_normal(d.negative ? -v : v, d.digits.empty(), text);
}

Rational exact_of_double(double v) {
  // |v| = m 2^(e - 53) with an integer m < 2^53.
  int e = 0;
  const auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(v, &e), 53));
  e -= 53;
  const cpp_int scale = cpp_int(1) << static_cast<unsigned>(std::abs(e));
  return e >= 0 ? Rational(cpp_int(m) * scale) : Rational(cpp_int(m), scale);
}

}  // namespace

Rational exact(const Number& number) {
  CAROM_EXPECT(std::isfinite(number.value));
  if (number.text.empty()) return exact_of_double(number.value);
  if (const auto decimal = scan_decimal(number.text)) return to_rational(*decimal, number.text);
  if (const auto fraction = scan_fraction(number.text)) return to_rational(*fraction, number.text);
  throw std::invalid_argument("\"" + number.text + "\" has no exact value");
}

Number parse_number(std::string_view text) {
  if (text.size() > longest_number) throw std::length_error("a number of " + std::to_string(text.size()) + " characters");
  Number number;
  number.text = text;
  if (text == "inf" || text == "+inf" || text == "-inf") {
    number.value = text.front() == '-' ? -Limits::infinity() : Limits::infinity();
  } else if (const auto decimal = scan_decimal(text)) {
    number.value = to_double(*decimal, text);
  } else if (const auto fraction = scan_fraction(text)) {
    number.value = require_normal(nearest_double(to_rational(*fraction, text)), fraction->numerator.empty(), text);
  } else {
    throw std::invalid_argument("\"" + std::string(text) + "\" is not a number");
  }
  return number;
}

double nearest_double(const Rational& r) {
  constexpr int lowest_bit = Limits::min_exponent - Limits::digits;  // -1074: the unit of the subnormals
  cpp_int n = abs(numerator(r));
  cpp_int d = denominator(r);
  if (n == 0) return 0.0;
  const double sign = r < 0 ? -1.0 : 1.0;

  // n/d is in (2^(e-1), 2^(e+1)); after the comparison, in [2^e, 2^(e+1)).
  std::int64_t e = static_cast<std::int64_t>(msb(n)) - static_cast<std::int64_t>(msb(d));
  if (e > Limits::max_exponent + 1) return sign * Limits::infinity();
  if (e < lowest_bit - 2) return sign * 0.0;
  if (e >= 0 ? n < (d << static_cast<unsigned>(e)) : (n << static_cast<unsigned>(-e)) < d) --e;

  // n/d = (q + remainder/d) 2^last, where 2^last is the last bit that a double of this size holds.
  const int last = std::max(static_cast<int>(e) - (Limits::digits - 1), lowest_bit);
  (last >= 0 ? d : n) <<= static_cast<unsigned>(std::abs(last));
  cpp_int q, remainder;
  divide_qr(n, d, q, remainder);
  const int half = cpp_int(2 * remainder).compare(d);
  if (half > 0 || (half == 0 && bit_test(q, 0))) ++q;
  return sign * std::ldexp(static_cast<double>(q.convert_to<std::uint64_t>()), last);
}

}  // namespace carom
