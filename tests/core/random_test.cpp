#include "carom/core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

namespace carom {
namespace {

// The known answers that Random123 publishes for philox4x32 with 10 rounds (tests/kat_vectors): zeros, ones, digits of pi.
static_assert(philox4x32({0, 0}, {0, 0, 0, 0}) == PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
static_assert(philox4x32({~0u, ~0u}, {~0u, ~0u, ~0u, ~0u}) ==
              PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});

TEST(Philox, gives_the_published_answer_at_run_time) {
  volatile std::uint32_t first = 0xa4093822;
  const PhiloxCounter expected{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1};
  EXPECT_EQ(philox4x32({first, 0x299f31d0}, {0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}), expected);
}

TEST(UnitInterval, spans_the_multiples_of_its_step_below_one) {
  EXPECT_EQ(unit_interval(0, 0), 0.0);
  EXPECT_EQ(unit_interval(0, 0x7ff), 0.0);
  EXPECT_EQ(unit_interval(0, 0x800), 0x1p-53);
  EXPECT_EQ(unit_interval(~0u, ~0u), 1.0 - 0x1p-53);
}

/// Largest distance of the empirical distribution of a sample from `cumulative`, times sqrt(n).
/// Kolmogorov: above 1.95 with probability 1e-3.
template <typename Cumulative>
double kolmogorov_smirnov(std::vector<double> sample, Cumulative cumulative) {
  std::sort(sample.begin(), sample.end());
  const double n = static_cast<double>(sample.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double p = cumulative(sample[i]), k = static_cast<double>(i);
    largest = std::max({largest, (k + 1.0) / n - p, p - k / n});
  }
  return largest * std::sqrt(n);
}

TEST(RandomStream, draws_uniformly) {
  std::vector<double> sample;
  RandomStream draw(7, 3);
  for (int i = 0; i < 200'000; ++i) sample.push_back(draw.uniform());
  EXPECT_LT(kolmogorov_smirnov(sample, [](double x) { return x; }), 1.95);
  // Successive draws: the correlation of n pairs is within 4 / sqrt(n).
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < sample.size(); ++i) sum += 12.0 * (sample[i] - 0.5) * (sample[i + 1] - 0.5);
  EXPECT_LT(std::abs(sum / 200'000.0), 4.0 / std::sqrt(200'000.0));
}

TEST(RandomStream, is_a_function_of_seed_stream_and_use) {
  RandomStream a(1, 2, 3), again(1, 2, 3), seed(1ull << 32, 2, 3), stream(1, 2 + (1ull << 32), 3), use(1, 2, 4);
  const double first = a.uniform();
  EXPECT_EQ(first, again.uniform());
  EXPECT_NE(first, seed.uniform());
  EXPECT_NE(first, stream.uniform());
  EXPECT_NE(first, use.uniform());
}

TEST(RandomStream, keeps_its_bits) {
  RandomStream draw(42, 1);
  EXPECT_EQ(draw.uniform(), 0x1.499bb49028f4p-7);
  EXPECT_EQ(draw.normal(), -0x1.645bb438a8b64p-2);
  EXPECT_EQ(draw.normal(), -0x1.ed9274404030ap-2);
  EXPECT_EQ(draw.normal(), -0x1.03790701d8cfcp-2);
}

double error_in_ulp(double x) {
  using Wide = boost::multiprecision::cpp_bin_float_50;
  const Wide truth = log(Wide(x));
  const double nearest = truth.convert_to<double>();
  const double ulp = std::nextafter(std::abs(nearest), INFINITY) - std::abs(nearest);
  return std::abs((truth - Wide(natural_log(x))).convert_to<double>()) / ulp;
}

TEST(NaturalLog, Bound) {
  double worst = 0.0;
  RandomStream draw(1, 1);
  for (int i = 0; i < 5'000; ++i) {
    const double u = draw.uniform(), v = draw.uniform();
    worst = std::max(worst, error_in_ulp(std::ldexp(0.5 + 0.5 * u, -static_cast<int>(v * 104))));
    worst = std::max(worst, error_in_ulp(1.0 - 0.5 * u * std::ldexp(1.0, -static_cast<int>(v * 50))));
  }
  for (const double x : {0.5, 0x1p-104, 1.0 - 0x1p-53, 0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bccp-1})
    worst = std::max(worst, error_in_ulp(x));
  RecordProperty("ulp", std::to_string(worst));
  EXPECT_LT(worst, natural_log_ulp);
  EXPECT_GT(worst, 0.5 * natural_log_ulp) << "the stated bound is too wide";
  EXPECT_EQ(natural_log(1.0), 0.0);
}

TEST(RandomStream, draws_normally) {
  constexpr int n = 400'000;
  std::vector<double> sample;
  for (int i = 0; i < n / 4; ++i) {
    RandomStream draw(5, static_cast<std::uint64_t>(i));  // as velocities are drawn: a few from each of many streams
    for (int k = 0; k < 4; ++k) sample.push_back(draw.normal());
  }
  double m1 = 0, m2 = 0, m3 = 0, m4 = 0;
  for (const double z : sample) m1 += z / n, m2 += z * z / n, m3 += z * z * z / n, m4 += z * z * z * z / n;
  // Variances of the means of z, z^2, z^3, z^4: 1, 2, 15, 96 over n. Four standard deviations:
  EXPECT_NEAR(m1, 0.0, 4 * std::sqrt(1.0 / n));
  EXPECT_NEAR(m2, 1.0, 4 * std::sqrt(2.0 / n));
  EXPECT_NEAR(m3, 0.0, 4 * std::sqrt(15.0 / n));
  EXPECT_NEAR(m4, 3.0, 4 * std::sqrt(96.0 / n));
  EXPECT_LT(kolmogorov_smirnov(sample, [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }), 1.95);
  // Neighbouring streams are independent, and so are the two variates of one polar step, in sign and in size.
  double between = 0.0, within = 0.0, sizes = 0.0;
  for (std::size_t i = 0; i + 4 < sample.size(); i += 4) {
    between += sample[i] * sample[i + 4];
    within += sample[i] * sample[i + 1];
    sizes += (sample[i] * sample[i] - 1.0) * (sample[i + 1] * sample[i + 1] - 1.0) / 2.0;
  }
  const double pairs = n / 4.0;
  EXPECT_LT(std::abs(between / pairs), 4 / std::sqrt(pairs));
  EXPECT_LT(std::abs(within / pairs), 4 / std::sqrt(pairs));
  EXPECT_LT(std::abs(sizes / pairs), 4 / std::sqrt(pairs));
}

}  // namespace
}  // namespace carom
