#pragma once
// Numbers of the Maxwell distribution in d dimensions.

#include <cmath>
#include <numbers>

namespace carom {

/// sqrt(2/n) Gamma((n + 1)/2) / Gamma(n/2): mean of the length of n normal variables over the root of its mean square;
/// n > 0. Relative error below 1e-11.
[[nodiscard]] inline double mean_length_ratio(double n) {
  if (n > 1e3)
    return 1 - 1 / (4 * n) * (1 - 1 / (8 * n) * (1 + 5 / (4 * n)));  // Stirling's series; next term 21/(2048 n^4)
  return std::sqrt(2 / n) * std::exp(std::lgamma((n + 1) / 2) - std::lgamma(n / 2));
}

/// Probability that |v| < speed in d = 1, 2 or 3 dimensions, with a variance of kT/m for each component.
[[nodiscard]] inline double maxwell_below(double speed, double kT_over_m, int dimension) {
  const double x = speed * speed / (2 * kT_over_m);
  if (dimension == 2) return -std::expm1(-x);
  const double line = std::erf(std::sqrt(x));
  return dimension == 1 ? line : line - 2 * std::numbers::inv_sqrtpi * std::sqrt(x) * std::exp(-x);
}

}  // namespace carom
