// Meeting of two bodies that grow, and flight inside a circle or sphere of a ball that grows: by hand, where the rates are
// equal, and on log-uniform random input against exact arithmetic.

#include "carom/solve/growing.hpp"

#include <gtest/gtest.h>

#include "solve/oracle.hpp"

namespace carom {
namespace {

using oracle::Digits100;
using oracle::Exact;
using V2 = Vec<double, 2>;
using V3 = Vec<double, 3>;
const double no = never<double>();

/// First t >= 0 at which |r + v t|^2 - (sigma + growth t)^2 is <= 0 and falling: from the coefficients, whose discriminant
/// is b^2 - a c itself; nothing: never.
template <int D>
std::optional<Digits100> meet(const Vec<double, D>& r, const Vec<double, D>& v, double sigma, double growth) {
  oracle::Terms<D> t = oracle::terms<D>(r, v, sigma);
  t.a -= Exact(growth) * Exact(growth);
  t.b -= Exact(sigma) * Exact(growth);
  t.d = t.b * t.b - t.a * t.c;
  const bool overlaps = t.c <= 0;
  if (overlaps && (t.b < 0 || (t.b == 0 && t.a < 0))) return Digits100(0);
  if (!overlaps && t.b < 0 && t.d > 0) return Digits100(t.c) / (sqrt(Digits100(t.d)) - Digits100(t.b));
  if (t.a >= 0 || (!overlaps && t.b < 0)) return {};
  if (t.d <= 0) return Digits100(Exact(-t.b / t.a));
  return (Digits100(t.b) + sqrt(Digits100(t.d))) / Digits100(-t.a);
}

template <int D>
double checked_meet(const Vec<double, D>& r, const Vec<double, D>& v, double sigma, double growth) {
  const double t = growing_meet_time<double, D>(r, v, sigma, growth);
  const std::optional<Digits100> truth = meet<D>(r, v, sigma, growth);
  EXPECT_EQ(truth.has_value(), t != no) << "r " << r.transpose() << " v " << v.transpose() << " sigma " << sigma
                                        << " growth " << growth << " t " << t;
  if (truth.has_value() != (t != no) || !truth) return 0.0;
  return oracle::error_in_u(t, *truth);
}

TEST(GrowingMeetTime, at_rest_the_gap_is_closed_by_growth_alone) {
  EXPECT_EQ(growing_meet_time(V2(10, 0), V2(0, 0), 1.0, 0.5), 18.0);
  EXPECT_EQ(growing_meet_time(V3(0, 0, -10), V3(0, 0, 0), 1.0, 0.5), 18.0);
}

TEST(GrowingMeetTime, one_that_recedes_is_caught_by_a_faster_growth_alone) {
  EXPECT_EQ(growing_meet_time(V2(3, 0), V2(1, 0), 1.0, 2.0), 2.0);   // 3 + t = 1 + 2 t
  EXPECT_EQ(growing_meet_time(V2(3, 0), V2(1, 0), 1.0, 1.0), no);    // the gap stays
  EXPECT_EQ(growing_meet_time(V2(3, 0), V2(1, 0), 1.0, 0.5), no);
  EXPECT_EQ(growing_meet_time(V2(3, 0), V2(-1, 0), 1.0, 1.0), 1.0);  // a = 0: 3 - t = 1 + t
  EXPECT_DOUBLE_EQ(growing_meet_time(V2(0, 3), V2(4, 0), 1.0, 5.0), (std::sqrt(97.0) - 5) / 9);  // 9 + 16 t^2 = (1 + 5 t)^2
}

TEST(GrowingMeetTime, without_growth_is_meet_time) {
  oracle::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const V3 r = random.direction<3>() * random.log_uniform(1.0, 10.0), v = random.direction<3>();
    const double t = meet_time<double, 3>(r, v, 1.0), s = growing_meet_time<double, 3>(r, v, 1.0, 0.0);
    EXPECT_EQ(t == no, s == no);
    if (t != no) {
      EXPECT_NEAR(s / t, 1.0, (meet_time_error + growing_time_error) * 0x1p-53);
    }
  }
}

TEST(GrowingMeetTime, of_overlapping_balls) {
  EXPECT_EQ(growing_meet_time(V2(0.9, 0), V2(0, 0), 1.0, 0.1), 0.0);
  EXPECT_EQ(growing_meet_time(V2(1.0, 0), V2(0.09, 0), 1.0, 0.1), 0.0);
  EXPECT_EQ(growing_meet_time(V2(1.0, 0), V2(0.11, 0), 1.0, 0.1), no);
  // Apart faster than they grow at first, and never out of the overlap: where it turns to fall again.
  const V2 r(0.5, 0), v(3, 0);
  EXPECT_EQ(checked_meet<2>(r, v, 1.0, 1.0), 0.0);
  EXPECT_LE(checked_meet<2>(V2(1 - 0x1p-30, 0), V2(0.5, 0.9), 1.0, 0.4), growing_time_error);
}

template <int D>
void expect_right_on_random_input(std::uint64_t seed) {
  oracle::Random random(seed);
  double worst = 0.0;
  int meetings = 0, misses = 0, caught = 0;
  for (int i = 0; i < 20000; ++i) {
    const double sigma = random.log_uniform(1e-10, 1e10), speed = random.log_uniform(1e-10, 1e10);
    const Vec<double, D> n = random.direction<D>(), m = random.across<D>(n);
    const double gap = random.whole(0, 3) == 0 ? random.log_uniform(1e-16, 1e-7) : random.log_uniform(1e-7, 100.0);
    const Vec<double, D> r = n * (sigma * (1 + random.sign() * gap));
    // Growth against speed: anything, or equal but for a little (a = 0), or such that the gap's rate is (b = 0).
    const double angle = random.uniform(0.0, 3.14159265358979), little = random.sign() * random.log_uniform(1e-17, 1e-1);
    double growth = speed * random.log_uniform(1e-6, 1e6);
    if (random.whole(0, 3) == 0) growth = speed * (1 + little);
    if (random.whole(0, 3) == 0) growth = speed * std::fabs(std::cos(angle)) * (1 + gap) * (1 + little);
    Vec<double, D> v = (n * std::cos(angle) + m * std::sin(angle)) * speed;
    if (random.whole(0, 3) == 0) {  // past one another by a little: from the point of touching, a time away
      const double later = random.log_uniform(1e-3, 1e2) * sigma / (speed + growth), reach = sigma + growth * later;
      v = (m * (reach * (1 + little)) - r) / later;
    }
    const double error = checked_meet<D>(r, v, sigma, growth);
    const double t = growing_meet_time<double, D>(r, v, sigma, growth);
    worst = std::max(worst, error);
    (t == no ? misses : meetings)++;
    caught += t != no && t > 0 && dot<double, D>(r, v) > 0;
  }
  EXPECT_LE(worst, growing_time_error);
  EXPECT_GT(meetings, 4000);
  EXPECT_GT(misses, 2000);
  EXPECT_GT(caught, 1000) << "pairs that recede and yet meet";
  ::testing::Test::RecordProperty("worst_error_in_u", std::to_string(worst));
}
TEST(GrowingMeetTime, is_right_on_random_input_in_2d) { expect_right_on_random_input<2>(11); }
TEST(GrowingMeetTime, is_right_on_random_input_in_3d) { expect_right_on_random_input<3>(12); }

TEST(GrowingMeetTime, in_higher_precision_is_the_same_root) {
  using Real = long double;
  oracle::Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const V3 r = random.direction<3>() * random.log_uniform(1.01, 10.0), v = random.direction<3>();
    const double growth = random.log_uniform(1e-3, 10.0);
    const double t = growing_meet_time<double, 3>(r, v, 1.0, growth);
    const Vec<Real, 3> x(r[0], r[1], r[2]), u(v[0], v[1], v[2]);
    const Real s = growing_meet_time<Real, 3>(x, u, Real(1), Real(growth));
    EXPECT_EQ(t == no, s == never<Real>());
    if (t != no) {
      EXPECT_NEAR(double(s / Real(t)), 1.0, growing_time_error * 0x1p-53);
    }
  }
}

// rho - growth t = |r + v t|: along the axis from the centre, 1 - t / 2 = 3 t / 2 at t = 1/2.
TEST(GrowingLeaveTime, head_on) {
  EXPECT_EQ(growing_leave_time(V2(0, 0), V2(1.5, 0), 1.0, 0.5), 0.5);
  EXPECT_EQ(growing_leave_time(V2(0, 0), V2(0, 0), 1.0, 0.5), 2.0);  // it fills the circle
  EXPECT_EQ(growing_leave_time(V2(0, 0), V2(0.5, 0), 1.0, 0.5), 1.0);  // a = 0
  EXPECT_EQ(growing_leave_time(V3(0, 0.25, 0), V3(0, -0.25, 0), 1.0, 0.5), 5.0 / 3);
}

// From wall to wall: |r| = rho, -2 b / a with b = r.v + rho growth, a = v.v - growth^2.
TEST(GrowingLeaveTime, from_wall_to_wall) {
  EXPECT_EQ(growing_chord_time(V2(1, 0), V2(-1.5, 0), 1.0, 0.5), 1.0);  // -1 + 1.5 = 1 - 0.5
  EXPECT_EQ(growing_chord_time(V2(1, 0), V2(-0.5, 0.1), 1.0, 0.5), 0.0) << "pressed to the wall";
  oracle::Random random(8);
  for (int i = 0; i < 1000; ++i) {
    const V2 r = random.direction<2>();
    const double growth = random.log_uniform(1e-6, 1e-1);
    const V2 v = -r * random.uniform(0.2, 1.0) + random.across<2>(r) * random.uniform(-1.0, 1.0);
    const double t = growing_chord_time<double, 2>(r, v, 1.0, growth);
    const V2 at = r + v * t;
    EXPECT_NEAR(std::sqrt(dot<double, 2>(at, at)), 1 - growth * t, 1e-14);
  }
}

}  // namespace
}  // namespace carom
