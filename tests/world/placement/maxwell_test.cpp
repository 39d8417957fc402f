#include "carom/world/placement/maxwell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "brute_force.hpp"

namespace carom {
namespace {

/// m sum v^2 / freedoms / kT - 1, in units of 2^-53.
double temperature_error(const Maxwell& m, const PageVector<double>& v, double freedoms) {
  long double sum = 0;
  for (const double x : v) sum += static_cast<long double>(x) * x;
  return static_cast<double>((m.mass * sum / freedoms / m.temperature - 1) * 0x1p53L);
}

TEST(Maxwell, has_the_exact_temperature_and_no_momentum) {
  double worst = 0.0;
  for (const SpaceKind space : {SpaceKind::periodic, SpaceKind::box, SpaceKind::open}) {
    for (int d = 1; d <= 3; ++d) {
      for (const std::int64_t n : {2, 3, 5, 17, 1000, 20000}) {
        const Maxwell m{n, d, 0.7, 3.1, 12, 0};
        const auto v = maxwell_velocities(m, space);
        ASSERT_EQ(v.size(), static_cast<std::size_t>(n * d));
        for (int k = 0; k < d; ++k) {
          long double sum = 0;  // exact: all components are multiples of one power of two
          for (std::size_t i = k; i < v.size(); i += d) sum += v[i];
          EXPECT_EQ(sum, 0);
        }
        const auto freedoms = static_cast<double>(d * (space == SpaceKind::periodic ? n - 1 : n));
        worst = std::max(worst, std::abs(temperature_error(m, v, freedoms)));
      }
    }
  }
  RecordProperty("ulp", std::to_string(worst));
  EXPECT_LT(worst, temperature_ulp);
}

TEST(Maxwell, leaves_a_single_ball_at_rest_only_in_a_periodic_cell) {
  const Maxwell m{1, 3, 2.0, 1.0, 1, 0};
  EXPECT_EQ(maxwell_velocities(m, SpaceKind::periodic), PageVector<double>(3, 0.0));
  EXPECT_LT(std::abs(temperature_error(m, maxwell_velocities(m, SpaceKind::box), 3.0)), temperature_ulp);
}

TEST(Maxwell, is_at_rest_without_temperature_or_with_infinite_mass) {
  const PageVector<double> rest(20, 0.0);
  EXPECT_EQ(maxwell_velocities({10, 2, 0.0, 1.0, 1, 0}, SpaceKind::box), rest);
  EXPECT_EQ(maxwell_velocities({10, 2, 1.0, std::numeric_limits<double>::infinity(), 1, 0}, SpaceKind::box), rest);
}

TEST(Maxwell, survives_extreme_units) {
  for (const double t : {1e-250, 1e250}) {
    const Maxwell m{100, 3, t, 1.0, 1, 0};
    const auto v = maxwell_velocities(m, SpaceKind::periodic);
    long double sum = 0;
    for (const double x : v) sum += static_cast<long double>(x) * x;
    EXPECT_NEAR(static_cast<double>(sum / 297 / static_cast<long double>(t)), 1.0, 1e-14);
  }
}

// One component of many balls: kurtosis 3 and equal shares of the axes, within four standard deviations.
TEST(Maxwell, is_normal_and_isotropic) {
  constexpr int n = 100'000;
  const auto v = maxwell_velocities({n, 3, 1.0, 1.0, 9, 0}, SpaceKind::box);
  std::array<double, 3> square{}, fourth{};
  for (std::size_t i = 0; i < v.size(); ++i) {
    square[i % 3] += v[i] * v[i] / n;
    fourth[i % 3] += v[i] * v[i] * v[i] * v[i] / n;
  }
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(square[k], 1.0, 4 * std::sqrt(2.0 / n));
    EXPECT_NEAR(fourth[k], 3.0, 4 * std::sqrt(96.0 / n));
  }
}

TEST(Maxwell, differs_between_seeds_and_entries) {
  const auto a = maxwell_velocities({9, 2, 1.0, 1.0, 1, 0}, SpaceKind::box);
  EXPECT_EQ(a, maxwell_velocities({9, 2, 1.0, 1.0, 1, 0}, SpaceKind::box));
  EXPECT_NE(a, maxwell_velocities({9, 2, 1.0, 1.0, 2, 0}, SpaceKind::box));
  EXPECT_NE(a, maxwell_velocities({9, 2, 1.0, 1.0, 1, 1}, SpaceKind::box));
}

}  // namespace
}  // namespace carom
