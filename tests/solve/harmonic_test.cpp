// Overlap functions on a circular path, g0 + g1 sin + g2 (1 - cos): by hand, and on log-uniform random coefficients against 60
// digits, written there as one shifted cosine. The decision has to be right always, the time within its bound.

#include "carom/solve/harmonic.hpp"

#include <numbers>
#include <random>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

namespace carom {
namespace {

using Digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;
constexpr double pi = std::numbers::pi;

ArcGap<double> arc(double speed, double gap, double rate, double bend) { return {speed, gap, rate, bend}; }

/// f = A + R cos(w s - phi) falls at phi + acos(-A / R); a turning point is at phi. Negative: never.
Digits truth(double speed, double gap, double rate, double bend) {
  const Digits w = speed, g1 = Digits(rate) / w, g2 = 2 * Digits(bend) / (w * w);
  const Digits A = gap + g2, R = sqrt(Digits(g1 * g1 + g2 * g2)), phi = atan2(g1, Digits(-g2));
  const Digits turn = 8 * atan(Digits(1));
  if (!(gap > 0) && (rate < 0 || (rate == 0 && bend < 0))) return 0;
  Digits angle = phi;
  if (abs(A) < R) {
    angle += acos(Digits(-A / R));
  } else if (gap > 0) {
    return -1;
  }
  while (angle < 0) angle += turn;
  while (angle >= turn) angle -= turn;
  return angle / w;
}

TEST(ArcFall, of_a_ball_that_circles_above_a_line) {
  // On a circle of radius 1 about (0, 1.5), from its right end upwards: the line y = 1 is crossed at 7/6 of pi.
  EXPECT_NEAR(first_fall(arc(1.0, 0.5, 1.0, 0.0)), 7 * pi / 6, 1e-15);
  EXPECT_NEAR(first_fall(arc(2.0, 0.5, 2.0, 0.0)), 7 * pi / 12, 1e-15);
  EXPECT_EQ(first_fall(arc(1.0, 1.0, 1.0, 0.0)), never<double>()) << "the circle touches the line and does not cross it";
  EXPECT_EQ(first_fall(arc(1.0, 1.5, 1.0, 0.0)), never<double>());
}

TEST(ArcFall, below_the_line_falls_now_or_where_it_turns) {
  EXPECT_EQ(first_fall(arc(1.0, -0.1, -1.0, 0.0)), 0.0);
  EXPECT_EQ(first_fall(arc(1.0, 0.0, 0.0, -1.0)), 0.0);
  EXPECT_NEAR(first_fall(arc(1.0, -2.0, 1.0, 0.0)), pi / 2, 1e-15) << "never above: the top of its path";
  EXPECT_EQ(first_fall(arc(1.0, -2.0, 0.0, 0.0)), never<double>()) << "at rest";
  EXPECT_EQ(first_fall(arc(1.0, 2.0, 0.0, 0.0)), never<double>());
}

TEST(ArcFall, of_a_slow_turn_is_that_of_a_parabola) {
  for (const double speed : {1e-3, 1e-9, 1e-200})
    EXPECT_NEAR(first_fall(arc(speed, 3.0, -4.0, 1.0)), 1.0, 10 * speed * speed + 2e-16) << speed;
}

TEST(ArcReturn, drops_the_contact_by_state) {
  // Leaves a line at an angle of 0.3 and is bent back to it: the chord spans twice that angle.
  for (const double gap : {0.0, 1e-17, -1e-17})
    EXPECT_NEAR(return_to_contact(arc(1.0, gap, std::sin(0.3), -0.5 * std::cos(0.3))), 0.6, 1e-15) << gap;
  EXPECT_NEAR(return_to_contact(arc(1.0, 0.0, std::sin(0.3), 0.5 * std::cos(0.3))), 2 * pi - 0.6, 2e-15);
  EXPECT_EQ(return_to_contact(arc(1.0, 1e-17, -1e-17, -0.5)), 0.0) << "pressed to it";
  EXPECT_EQ(return_to_contact(arc(1.0, -1e-17, -1e-17, 0.5)), never<double>()) << "touches it once a turn";
}

TEST(ArcFall, is_right_on_random_coefficients) {
  std::mt19937_64 bits(20240611);
  const auto unit = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  const auto number = [&](double range) { return std::exp2(range * (2 * unit() - 1)) * ((bits() & 1) != 0 ? 1 : -1); };
  double worst = 0;
  int roots = 0;
  for (int n = 0; n < 4000; ++n) {
    const double range = n % 2 == 0 ? 40 : 3;
    const double speed = std::abs(number(range / 2)), gap = number(range), rate = number(range), bend = number(range);
    const double t = first_fall(arc(speed, gap, rate, bend));
    const Digits exact = truth(speed, gap, rate, bend);
    ASSERT_EQ(t == never<double>(), exact < 0) << speed << ' ' << gap << ' ' << rate << ' ' << bend;
    if (!(exact > 0)) continue;
    ++roots;
    const Digits c2 = bend + Digits(speed) * speed * gap / 4, d = Digits(rate) * rate - 4 * gap * c2;
    if (abs(d) < ldexp(Digits(rate) * rate, -40)) continue;
    const Digits error = abs(Digits(t / exact - 1));
    worst = std::max(worst, static_cast<double>(error) * 0x1p53);
  }
  EXPECT_GT(roots, 1000);
  EXPECT_LE(worst, arc_fall_error);
  EXPECT_GT(worst, 1.0) << "the bound is tried";
}

}  // namespace
}  // namespace carom
