// Gaps that are lines and parabolas in time: the overlap rule in every sign and order, and the bounds.

#include "carom/solve/gap.hpp"

#include <gtest/gtest.h>

#include "solve/oracle.hpp"

namespace carom {
namespace {

using oracle::Digits100;
using oracle::Exact;
const double no = never<double>();

TEST(GapTime, is_gap_over_closing_speed) {
  EXPECT_EQ(gap_time(3.0, -2.0), 1.5);
  EXPECT_EQ(gap_time(0.0, -2.0), 0.0);
  EXPECT_EQ(gap_time(-1e-16, -2.0), 0.0);
  EXPECT_EQ(gap_time(3.0, 0.0), no);
  EXPECT_EQ(gap_time(-3.0, 0.0), no);
  EXPECT_EQ(gap_time(-3.0, 1.0), no);
}

TEST(FirstFall, of_a_parabola_by_hand) {
  // (t - 1)(t - 2): above, falls at 1.
  EXPECT_EQ(first_fall(2.0, -3.0, 1.0), 1.0);
  // -(t - 1)(t - 2): below and rising, above from 1, falls at 2.
  EXPECT_EQ(first_fall(-2.0, 3.0, -1.0), 2.0);
  // -(t + 1)(t - 2): above, falls at 2; and the same thrown upwards and downwards.
  EXPECT_EQ(first_fall(2.0, 1.0, -1.0), 2.0);
  EXPECT_EQ(first_fall(2.0, -1.0, -1.0), 1.0);
  EXPECT_EQ(first_fall(4.0, 0.0, -1.0), 2.0);
  // (t + 1)(t + 2): all is past.
  EXPECT_EQ(first_fall(2.0, 3.0, 1.0), no);
  // A line.
  EXPECT_EQ(first_fall(2.0, -4.0, 0.0), 0.5);
  EXPECT_EQ(first_fall(2.0, 4.0, 0.0), no);
}

TEST(FirstFall, follows_the_overlap_rule_when_overlapping) {
  EXPECT_EQ(first_fall(-1.0, -1.0, 5.0), 0.0);  // falling now
  EXPECT_EQ(first_fall(0.0, -1.0, 5.0), 0.0);
  EXPECT_EQ(first_fall(0.0, 0.0, -1.0), 0.0);   // the second derivative decides
  EXPECT_EQ(first_fall(-1.0, 0.0, -1.0), 0.0);
  EXPECT_EQ(first_fall(-1.0, 1.0, 0.0), no);    // rising for ever
  EXPECT_EQ(first_fall(-1.0, 0.0, 1.0), no);
  EXPECT_EQ(first_fall(0.0, 1.0, 1.0), no);
  EXPECT_EQ(first_fall(0.0, 0.0, 0.0), no);     // constant: not falling
  EXPECT_EQ(first_fall(-1.0, 0.0, 0.0), no);
  EXPECT_EQ(first_fall(0.0, 3.0, -1.0), 3.0);   // rising through 0, back at 3
  EXPECT_EQ(first_fall(-2.0, 2.0, -1.0), 1.0);  // -(t - 1)^2 - 1 never gets out: the turning point
  EXPECT_EQ(first_fall(-1.0, 2.0, -1.0), 1.0);  // -(t - 1)^2 just reaches 0
}

TEST(FirstFall, grazing_is_decided_by_one_ulp) {
  // (t - 1)^2 touches and does not fall below.
  EXPECT_EQ(first_fall(1.0, -2.0, 1.0), no);
  EXPECT_EQ(first_fall(1.0 + 0x1p-52, -2.0, 1.0), no);
  // (t - 1)^2 - 2^-53: falls at 1 - 2^-26.5, in which plain arithmetic sees no root.
  const Exact root = 1 - sqrt(Exact(0x1p-53));
  EXPECT_LE(oracle::error_in_u(first_fall(1.0 - 0x1p-53, -2.0, 1.0), root), parabola_error);
  // 0.1 is not 1/10: 0.1 t^2 - 2 * 0.1 t + 0.1 is still a square.
  EXPECT_EQ(first_fall(0.1, -0.2, 0.1), no);
}

TEST(NextFall, drops_the_root_at_zero) {
  EXPECT_EQ(next_fall(3.0, -1.0), 3.0);
  EXPECT_EQ(next_fall(3.0, 0.0), no);
  EXPECT_EQ(next_fall(3.0, 1.0), no);
  EXPECT_EQ(next_fall(0.0, -1.0), 0.0);     // pressed to the wall
  EXPECT_EQ(next_fall(-1e-17, -1.0), 0.0);
  EXPECT_EQ(next_fall(-1e-17, 1.0), no);    // the rounding of a plastic impact does not make it fall
}

// Coefficients log-uniform in 1e-15 .. 1e15 with either sign, and a third of them with g1^2 within some ulp of 4 g0 g2.
TEST(FirstFall, of_a_parabola_is_right_and_within_its_bound) {
  oracle::Random random(31);
  double worst = 0.0;
  int events = 0;
  int misses = 0;
  for (int i = 0; i < 9000; ++i) {
    const double g0 = random.sign() * random.log_uniform(1e-15, 1e15);
    const double g2 = random.sign() * random.log_uniform(1e-15, 1e15);
    double g1 = random.sign() * random.log_uniform(1e-15, 1e15);
    if (i % 3 == 0 && g0 * g2 > 0) g1 = std::copysign(2 * std::sqrt(g0 * g2) * (1 + random.whole(-3, 3) * 0x1p-52), g1);
    const double t = first_fall(g0, g1, g2);

    // The two roots and the turning point, exactly; then the rule by looking at the signs in between.
    const Exact a(g2), b(g1), c(g0);
    const Exact d = b * b - 4 * a * c;
    std::optional<Digits100> truth;
    if (c <= 0 && b < 0) {
      truth = Digits100(0);
    } else if (d > 0) {
      // f falls at (-b - s) / 2a whatever the sign of a, f' = -s there; the same as 2c / (-b + s).
      const Digits100 s = sqrt(Digits100(d));
      const Digits100 root = b > 0 ? (-Digits100(b) - s) / Digits100(2 * a) : Digits100(2 * c) / (s - Digits100(b));
      if (root > 0) truth = root;
    } else if (c <= 0 && a < 0) {
      truth = Digits100(Exact(-b / (2 * a)));
    }
    ASSERT_EQ(truth.has_value(), t != no) << std::hexfloat << g0 << ' ' << g1 << ' ' << g2;
    ++(truth ? events : misses);
    if (truth) worst = std::max(worst, oracle::error_in_u(t, *truth));
  }
  testing::Test::RecordProperty("worst_in_u", std::to_string(worst));
  EXPECT_LE(worst, parabola_error);
  EXPECT_GT(events, 2000);
  EXPECT_GT(misses, 2000);
}

TEST(FirstFall, of_a_parabola_in_more_digits) {
  const Digits100 t = first_fall(Digits100(1), Digits100(-3), Digits100(1));
  EXPECT_LT(abs(t - (3 - sqrt(Digits100(5))) / 2), Digits100("1e-98"));
}

}  // namespace
}  // namespace carom
