// Pairs with relative acceleration, and balls under gravity inside a circle: by hand, in the limit of none, and against
// Sturm.

#include "carom/solve/accelerated.hpp"

#include <gtest/gtest.h>

#include "carom/solve/quadratic.hpp"
#include "solve/oracle.hpp"
#include "solve/sturm.hpp"

namespace carom {
namespace {

using oracle::Digits300;
using V2 = Vec<double, 2>;
using V3 = Vec<double, 3>;
const double no = never<double>();

TEST(AcceleratedMeetTime, of_a_ball_that_falls_on_another) {
  EXPECT_EQ(meet_time(V2(10, 0), V2(0, 0), V2(-2, 0), 1.0), 3.0);   // 10 - t^2 = 1
  EXPECT_EQ(meet_time(V2(10, 0), V2(2, 0), V2(-2, 0), 2.0), 4.0);   // 10 + 2 t - t^2 = 2
  EXPECT_EQ(meet_time(V2(10, 0), V2(-1, 0), V2(2, 0), 1.0), no);    // held off before it arrives
  EXPECT_EQ(meet_time(V2(10, 0), V2(0, 0), V2(2, 0), 1.0), no);
}

TEST(AcceleratedMeetTime, grazing_a_parabola_is_no_meeting) {
  // The ball comes to rest, to turn back, at distance 1: 1 + (t - 3)^2.
  EXPECT_EQ(meet_time(V2(10, 0), V2(-6, 0), V2(2, 0), 1.0), no);
  EXPECT_NE(meet_time(V2(10, 0), V2(-6, 0), V2(2, 0), std::nextafter(1.0, 2.0)), no);
  EXPECT_EQ(meet_time(V2(10, 0), V2(-6, 0), V2(2, 0), std::nextafter(1.0, 0.0)), no);
}

TEST(AcceleratedMeetTime, of_an_overlapping_pair_follows_the_rule) {
  EXPECT_EQ(meet_time(V2(1, 0), V2(-1, 0), V2(2, 0), 1.0), 0.0);
  EXPECT_EQ(meet_time(V2(1, 0), V2(0, 0), V2(-2, 0), 1.0), 0.0);     // pressed together
  EXPECT_EQ(meet_time(V2(1, 0), V2(0, 0), V2(2, 0), 1.0), no);
  EXPECT_EQ(meet_time(V2(1, 0), V2(1, 0), V2(-2, 0), 1.0), 1.0);     // thrown up, comes back
  EXPECT_EQ(next_meet_time(V2(1, 0), V2(1, 0), V2(-2, 0)), 1.0);
  EXPECT_EQ(next_meet_time(V2(1, 0), V2(-1e-18, 0), V2(2, 0)), no);
}

TEST(AcceleratedMeetTime, without_acceleration_is_that_of_free_flight) {
  oracle::Random random(51);
  int meetings = 0;
  for (int i = 0; i < 2000; ++i) {
    const V3 r = random.direction<3>() * random.log_uniform(1.0, 10.0);
    const V3 v = random.direction<3>();
    const double t = meet_time(r, v, 1.0);
    const double s = meet_time(r, v, V3(0, 0, 0), 1.0);
    ASSERT_EQ(t == no, s == no);
    if (t == no) continue;
    ++meetings;
    EXPECT_NEAR(s / t, 1.0, (meet_time_error + root_error) * 0x1p-53);
    const double in = leave_time<double, 3>(r * 0.05, v, 1.0);
    const double out = leave_time<double, 3>(r * 0.05, v, V3(0, 0, 0), 1.0);
    EXPECT_NEAR(out / in, 1.0, (leave_time_error + root_error) * 0x1p-53);
  }
  EXPECT_GT(meetings, 100);
}

TEST(AcceleratedMeetTime, agrees_with_sturm) {
  oracle::Random random(52);
  int meetings = 0;
  double worst = 0.0;
  for (int i = 0; i < 400; ++i) {
    const V2 r = random.direction<2>() * random.log_uniform(1.01, 10.0);
    const V2 v = random.direction<2>() * random.log_uniform(0.01, 10.0) - r * random.uniform(0.0, 1.0);
    const V2 a = random.direction<2>() * random.log_uniform(0.01, 10.0);
    oracle::Coefficients c(5, Digits300(0));
    for (int k = 0; k < 2; ++k) {
      const Digits300 x(r[k]), w(v[k]), g(a[k]);
      c[0] += x * x;
      c[1] += 2 * x * w;
      c[2] += w * w + x * g;
      c[3] += w * g;
      c[4] += g * g / 4;
    }
    c[0] -= 1;
    const auto truth = oracle::first_fall(c, ldexp(Digits300(1), 60));
    const double t = meet_time(r, v, a, 1.0);
    ASSERT_EQ(truth.has_value(), t != no);
    if (!truth) continue;
    ++meetings;
    // Simple roots of inputs like these: the root itself to root_error, condition numbers up to 1e8 or so notwithstanding.
    worst = std::max(worst, oracle::error_in_u(t, *truth));
  }
  testing::Test::RecordProperty("worst_in_u", std::to_string(worst));
  EXPECT_LE(worst, root_error);
  EXPECT_GT(meetings, 100);
}

TEST(AcceleratedLeaveTime, of_a_ball_dropped_in_a_circle) {
  EXPECT_EQ(leave_time(V2(0, 0), V2(0, 0), V2(0, -2), 4.0), 2.0);
  EXPECT_EQ(leave_time(V2(0, 0), V2(0, 3), V2(0, -2), 4.0), 4.0);       // 3 t - t^2 = -4; the top is at 9/4 < 4
  // On the wall at the bottom, thrown up: 2 t - t^2 back to 0 at 2; at rest it is pressed down.
  EXPECT_EQ(chord_time(V2(0, -4), V2(0, 2), V2(0, -2)), 2.0);
  EXPECT_EQ(chord_time(V2(0, -4), V2(0, 0), V2(0, -2)), 0.0);
  EXPECT_EQ(chord_time(V2(0, -4), V2(0, 2), V2(0, 0)), 4.0);
}

}  // namespace
}  // namespace carom
