#pragma once
// Randomness as a function of counters: the same bits for the same (seed, stream, draw) on every machine, whoever asks
// first.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace carom {

using PhiloxKey = std::array<std::uint32_t, 2>;
using PhiloxCounter = std::array<std::uint32_t, 4>;

/// Philox4x32-10 [Salmon2011, sec. 4.3]: ten rounds of two 32 x 32 bit products, a bijection of the counter for every key.
[[nodiscard]] constexpr PhiloxCounter philox4x32(PhiloxKey key, PhiloxCounter counter) noexcept {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

/// The upper 53 of 64 random bits as a multiple of 2^-53 in [0, 1).
[[nodiscard]] constexpr double unit_interval(std::uint32_t high, std::uint32_t low) noexcept {
  return static_cast<double>(((std::uint64_t{high} << 32) | low) >> 11) * 0x1p-53;
}

/// Largest error of `natural_log` below 1, in units of the last place (measured by random_test, NaturalLog).
inline constexpr double natural_log_ulp = 1.0;

/// ln x for a normal x > 0, from + - * / alone.
///   x = m 2^e, m in [sqrt(1/2), sqrt(2));  ln m = 2 atanh f, f = (m - 1) / (m + 1), |f| <= 0.1716
/// The series of atanh is cut after f^21: truncation below 2e-19 of the first term. e ln 2 is added in two parts.
[[nodiscard]] inline double natural_log(double x) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto e = static_cast<std::int64_t>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFFu) | 0x3FF0000000000000u);  // [1, 2)
  if (m >= 0x1.6a09e667f3bcdp0) {                                                        // sqrt(2)
    m *= 0.5;
    ++e;
  }
  constexpr double high = 0x1.62e42fee00000p-1, low = 0x1.a39ef35793c76p-33;  // ln 2; 33 bits, so e * high is exact
  const double d = m - 1.0, f = d / (m + 1.0), s = f * f;
  double tail = 1.0 / 21;
  for (int k = 19; k >= 3; k -= 2) tail = tail * s + 1.0 / k;
  // 2 f = d - f d, so the leading term d stays exact.
  const double exponent = static_cast<double>(e);
  return exponent * high + (d - (f * (d - 2.0 * (s * tail)) - exponent * low));
}

/// The stream number `stream` of a seed, as consecutive draws. Equal arguments give equal draws; no two streams share a
/// block.
class RandomStream {
 public:
  /// `stream` is mostly a ball's number, `use` tells apart what the draws are for.
  constexpr RandomStream(std::uint64_t seed, std::uint64_t stream, std::uint32_t use = 0) noexcept
      : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
        counter_{0, use, static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32)} {}

  /// Uniform on the multiples of 2^-53 in [0, 1). At most 2^33 draws a stream.
  constexpr double uniform() noexcept {
    if (half_used_) {
      half_used_ = false;
      return unit_interval(block_[2], block_[3]);
    }
    block_ = philox4x32(key_, counter_);
    ++counter_[0];
    half_used_ = true;
    return unit_interval(block_[0], block_[1]);
  }

  /// Standard normal: the polar method [Marsaglia1964]. With (a, b) uniform in the unit disk and s = a^2 + b^2,
  /// a sqrt(-2 ln s / s) and b sqrt(-2 ln s / s) are independent. Error below 5 ulp, at most 12 standard deviations.
  double normal() noexcept {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    double a = 0, b = 0, s = 0;
    do {
      a = 2.0 * uniform() - 1.0;
      b = 2.0 * uniform() - 1.0;
      s = a * a + b * b;
    } while (s >= 1.0 || s == 0.0);
    const double factor = std::sqrt(-2.0 * natural_log(s) / s);
    spare_ = b * factor;
    has_spare_ = true;
    return a * factor;
  }

 private:
  PhiloxKey key_;
  PhiloxCounter counter_;
  PhiloxCounter block_{};
  double spare_ = 0.0;
  bool half_used_ = false;
  bool has_spare_ = false;
};

}  // namespace carom
