#pragma once
// Units of a world: powers of two, so that converting never rounds.

#include <bit>
#include <cmath>
#include <cstdint>

namespace carom {

/// A world computes in units of 2^length, 2^time, 2^mass of the user's units; 2^time is the epoch length L.
struct Units {
  int length = 0;
  int time = 0;
  int mass = 0;

  [[nodiscard]] int velocity() const noexcept { return length - time; }
  [[nodiscard]] int acceleration() const noexcept { return length - 2 * time; }
  [[nodiscard]] int momentum() const noexcept { return mass + velocity(); }
  [[nodiscard]] int angular_momentum() const noexcept { return momentum() + length; }
  [[nodiscard]] int energy() const noexcept { return mass + 2 * velocity(); }

  /// L in the user's unit of time.
  [[nodiscard]] double epoch_length() const noexcept { return std::ldexp(1.0, time); }
};

/// x 2^exponent, exact within the range of Real.
template <class Real>
[[nodiscard]] inline Real scaled(const Real& x, int exponent) {
  using std::ldexp;
  return ldexp(x, exponent);
}

/// The same: one rounding, either way, where the result is subnormal.
[[nodiscard]] inline double scaled(const double& x, int exponent) {
  if (exponent < -1022 || exponent > 1023) return std::ldexp(x, exponent);
  return x * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

}  // namespace carom
