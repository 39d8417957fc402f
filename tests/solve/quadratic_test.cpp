// Meeting of two balls in free flight and flight inside a circle or sphere: by hand, in the degenerate cases, and on
// log-uniform random input against exact arithmetic. The decision has to be right always, the time within its bound.

#include "carom/solve/quadratic.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "solve/oracle.hpp"

namespace carom {
namespace {

using oracle::Exact;
using V2 = Vec<double, 2>;
using V3 = Vec<double, 3>;
const double no = never<double>();
double up(double x) { return std::nextafter(x, INFINITY); }
double down(double x) { return std::nextafter(x, -INFINITY); }

// Asserts the decision, returns the error of the time in u.
template <int D>
double checked_meet(const Vec<double, D>& r, const Vec<double, D>& v, double sigma) {
  const double t = meet_time<double, D>(r, v, sigma);
  const std::optional<oracle::Digits100> truth = oracle::meet<D>(r, v, sigma);
  EXPECT_EQ(truth.has_value(), t != no) << "r " << r.transpose() << " v " << v.transpose() << " sigma " << sigma;
  if (truth.has_value() != (t != no) || !truth) return 0.0;
  return oracle::error_in_u(t, *truth);
}

template <int D>
double checked_leave(const Vec<double, D>& r, const Vec<double, D>& v, double rho) {
  const double t = leave_time<double, D>(r, v, rho);
  const std::optional<oracle::Digits100> truth = oracle::leave<D>(r, v, rho);
  EXPECT_EQ(truth.has_value(), t != no) << "r " << r.transpose() << " v " << v.transpose() << " rho " << rho;
  if (truth.has_value() != (t != no) || !truth) return 0.0;
  return oracle::error_in_u(t, *truth);
}

TEST(MeetTime, head_on_and_oblique) {
  EXPECT_EQ(meet_time(V2(10, 0), V2(-2, 0), 1.0), 4.5);
  // Offset 3, sigma 5: the centres are 4 apart along the flight.
  EXPECT_EQ(meet_time(V2(10, 3), V2(-1, 0), 5.0), 6.0);
  EXPECT_EQ(meet_time(V3(10, 0, 3), V3(-2, 0, 0), 5.0), 3.0);
}

TEST(MeetTime, misses_when_separating) {
  EXPECT_EQ(meet_time(V2(10, 0), V2(2, 0), 1.0), no);
  EXPECT_EQ(meet_time(V2(10, 0), V2(0, 2), 1.0), no);
  EXPECT_EQ(meet_time(V2(10, 0), V2(0, 0), 1.0), no);
  EXPECT_EQ(meet_time(V2(10, 6), V2(-1, 0), 5.0), no);
}

TEST(MeetTime, of_overlapping_balls_is_now_or_never) {
  for (const double x : {0.5, 1 - 0x1p-53, 1.0}) {
    EXPECT_EQ(meet_time(V2(x, 0), V2(-1, 0.2), 1.0), 0.0) << x;
    EXPECT_EQ(meet_time(V2(x, 0), V2(-1e-200, 1), 1.0), 0.0) << x;
    EXPECT_EQ(meet_time(V2(x, 0), V2(0, 1), 1.0), no) << x;
    EXPECT_EQ(meet_time(V2(x, 0), V2(1e-200, 1), 1.0), no) << x;
  }
  EXPECT_EQ(meet_time(V2(0, 0), V2(1, 0), 1.0), no);  // concentric: neither falls nor rises to first order
}

TEST(MeetTime, sign_of_approach_is_exact_where_products_cancel) {
  // r.v = +-2^-104 of its terms, overlapping.
  const double x = 1 + 0x1p-52;
  const double y = 1 - 0x1p-52;
  EXPECT_EQ(meet_time(V2(x, 1), V2(y, -1), 2.0), 0.0);   // (1 + e)(1 - e) - 1 = -e^2
  EXPECT_EQ(meet_time(V2(-x, 1), V2(y, 1), 2.0), no);    // +e^2
  EXPECT_EQ(meet_time(V2(x, 1), V2(x, -x * x), 2.0), oracle::meet<2>(V2(x, 1), V2(x, -x * x), 2.0) ? 0.0 : no);
}

TEST(MeetTime, one_ulp_decides_grazing) {
  // Flight along x at height y past a sphere of radius sigma.
  for (const double sigma : {1.0, 0.1, 3.7e5, 1e-30}) {
    for (const double x : {1.5, 40.0, 1e9}) {
      EXPECT_EQ(meet_time(V2(x * sigma, sigma), V2(-1, 0), sigma), no);
      EXPECT_EQ(meet_time(V2(x * sigma, up(sigma)), V2(-1, 0), sigma), no);
      EXPECT_LE(meet_time(V2(x * sigma, down(sigma)), V2(-1, 0), sigma), x * sigma);
      EXPECT_LE(checked_meet(V2(x * sigma, down(sigma)), V2(-1, 0), sigma), meet_time_error);
      EXPECT_LE(checked_meet(V2(x * sigma, down(sigma)), V2(-0.3, 0), sigma), meet_time_error);
    }
  }
}

TEST(MeetTime, one_ulp_decides_grazing_in_any_direction) {
  // v = -(3, 4), n = (4, -3): r = p (3, 4) + m n grazes sigma = 5 m exactly. In 3-D (1, 2, 2) and (2, 1, -2), sigma = 3 m.
  int meetings = 0;
  for (const double p : {1.0, 77.0, 1e6 + 1}) {
    for (const double m : {1.0, 3.0, 1001.0}) {
      const V2 r(3 * p + 4 * m, 4 * p - 3 * m);
      const V3 q(p + 2 * m, 2 * p + m, 2 * p - 2 * m);
      EXPECT_EQ(meet_time(r, V2(-3, -4), 5 * m), no);
      EXPECT_EQ(meet_time(q, V3(-1, -2, -2), 3 * m), no);
      for (const double x : {down(r[0]), up(r[0])}) {
        const V2 moved(x, r[1]);
        EXPECT_LE(checked_meet<2>(moved, V2(-3, -4), 5 * m), meet_time_error);
        meetings += meet_time(moved, V2(-3, -4), 5 * m) != no;
      }
      for (const double x : {down(q[0]), up(q[0])}) {
        const V3 moved(x, q[1], q[2]);
        EXPECT_LE(checked_meet<3>(moved, V3(-1, -2, -2), 3 * m), meet_time_error);
        meetings += meet_time(moved, V3(-1, -2, -2), 3 * m) != no;
      }
    }
  }
  EXPECT_EQ(meetings, 18);  // moved towards the other ball: one of the two directions, each time
}

// Gap and distance to grazing log-uniform; lengths, speeds and their units over many powers of ten.
template <int D>
void expect_right_on_random_input(std::uint64_t seed) {
  oracle::Random random(seed);
  double worst = 0.0;
  int meetings = 0;
  int misses = 0;
  for (int i = 0; i < 8000; ++i) {
    const double sigma = random.log_uniform(1e-20, 1e20);
    const double speed = random.log_uniform(1e-20, 1e20);
    const Vec<double, D> along = random.direction<D>();
    const Vec<double, D> aside = random.across<D>(along);
    // Impact parameter: anywhere, or within a log-uniform distance of grazing from either side.
    const double offset =
        i % 2 == 0 ? random.uniform(0.0, 1.2) : 1.0 + random.sign() * random.log_uniform(1e-18, 1e-1);
    // Distance along the flight: log-uniform beyond contact, up to 1e6 diameters.
    const double contact = offset < 1 ? std::sqrt((1 - offset) * (1 + offset)) : 0.0;
    const double before = contact + random.log_uniform(1e-17, 1e6);
    const Vec<double, D> r = (aside * offset - along * before) * sigma;
    const Vec<double, D> v = along * speed;
    worst = std::max(worst, checked_meet<D>(r, v, sigma));
    ++(meet_time<double, D>(r, v, sigma) == no ? misses : meetings);
  }
  testing::Test::RecordProperty("worst_in_u", std::to_string(worst));
  EXPECT_LE(worst, meet_time_error);
  EXPECT_GT(worst, meet_time_error / 20);  // the sample comes near the bound
  EXPECT_GT(meetings, 2000);
  EXPECT_GT(misses, 1000);
}
TEST(MeetTime, is_right_and_within_its_bound_2d) { expect_right_on_random_input<2>(11); }
TEST(MeetTime, is_right_and_within_its_bound_3d) { expect_right_on_random_input<3>(12); }

// sigma is the double nearest to the distance at which r + v t passes, or a few ulp beside it: d = 0 to rounding.
template <int D>
void expect_right_at_grazing(std::uint64_t seed) {
  oracle::Random random(seed);
  int meetings = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec<double, D> r = random.direction<D>() * random.log_uniform(1e-5, 1e5);
    const Vec<double, D> v = random.direction<D>() * random.log_uniform(1e-5, 1e5);
    if (!(dot<double, D>(r, v) < 0)) continue;
    const auto terms = oracle::terms<D>(r, v, 0.0);  // d = -|r x v|^2
    double sigma = double(Exact(sqrt(Exact(-terms.d / terms.a))));
    for (int k = random.whole(-3, 3); k != 0; k -= k > 0 ? 1 : -1) sigma = k > 0 ? up(sigma) : down(sigma);
    EXPECT_LE(checked_meet<D>(r, v, sigma), meet_time_error);
    meetings += meet_time<double, D>(r, v, sigma) != no;
  }
  EXPECT_GT(meetings, 500);
  EXPECT_LT(meetings, 1500);
}
TEST(MeetTime, is_right_at_grazing_2d) { expect_right_at_grazing<2>(13); }
TEST(MeetTime, is_right_at_grazing_3d) { expect_right_at_grazing<3>(14); }

TEST(MeetTime, keeps_its_precision_close_to_contact) {
  // r.r - sigma^2 cancels all but a few bits: gaps of 1 to 1000 ulp, head on and at 80 degrees.
  for (int k = 1; k < 1000; k = 2 * k + 1) {
    const double x = 1 + k * 0x1p-52;
    EXPECT_LE(checked_meet(V2(x, 0), V2(-1, 0), 1.0), meet_time_error);
    EXPECT_LE(checked_meet(V2(x, 0), V2(-0.17, 0.98), 1.0), meet_time_error);
    EXPECT_LE(checked_meet(V3(0.6 * x, 0.8, 0), V3(-0.3, -0.4, 3), 1.0), meet_time_error);
  }
}

TEST(MeetTime, does_not_change_with_the_unit) {
  // Powers of two up to 2^400, far beyond where a sigma^2 overflows: the same digits.
  oracle::Random random(15);
  for (int i = 0; i < 500; ++i) {
    const V3 r = random.direction<3>() * random.log_uniform(1.0, 10.0);
    const V3 v = random.direction<3>();
    const double t = meet_time(r, v, 1.0);
    for (const double length : {0x1p-400, 0x1p400})
      for (const double speed : {0x1p-400, 0x1p400}) {
        const double scaled = meet_time<double, 3>(r * length, v * speed, length);
        if (t == no) {
          EXPECT_EQ(scaled, no);
        } else if (std::isnormal(t * (length / speed))) {
          EXPECT_NEAR(scaled / (length / speed) / t, 1.0, meet_time_error * 0x1p-53);
        }
      }
  }
}

TEST(MeetTime, of_speeds_whose_squares_underflow) {
  // Down to 2^-850 the same digits, and the same decision beside a grazing path.
  oracle::Random random(17);
  for (int i = 0; i < 500; ++i) {
    const V3 r = random.direction<3>() * random.log_uniform(1.0, 10.0);
    const V3 v = random.direction<3>();
    const double t = meet_time(r, v, 1.0);
    for (const double speed : {0x1p-500, 0x1p-600, 0x1p-833}) {
      const double slow = meet_time<double, 3>(r, v * speed, 1.0);
      if (t == no) {
        EXPECT_EQ(slow, no);
      } else {
        EXPECT_NEAR(slow * speed / t, 1.0, meet_time_error * 0x1p-53);
      }
    }
  }
  for (const double b : {1.0, std::nextafter(1.0, 2.0), std::nextafter(1.0, 0.0)})
    EXPECT_EQ(meet_time(V2(-5, b), V2(0x1p-833, 0), 1.0) == no, b >= 1.0);
}

TEST(MeetTime, is_symmetric_in_the_pair) {
  oracle::Random random(16);
  for (int i = 0; i < 2000; ++i) {
    const V2 r = random.direction<2>() * random.log_uniform(1.0, 3.0);
    const V2 v = random.direction<2>();
    EXPECT_EQ(meet_time(r, v, 1.0), (meet_time<double, 2>(-r, -v, 1.0)));
  }
}

TEST(MeetTime, of_points_is_never) {
  EXPECT_EQ(meet_time(V2(1, 1), V2(-1, -1), 0.0), no);
  EXPECT_EQ(meet_time(V2(1, 3), V2(-1, -1), 0.0), no);
}

TEST(MeetTime, in_more_digits) {
  using oracle::Digits100;
  using Vec2 = Vec<Digits100, 2>;
  const Digits100 third = Digits100(1) / 3;
  // Offset 1/3, sigma 1: t = 2 - sqrt(8)/3.
  const Digits100 t = meet_time<Digits100, 2>(Vec2(Digits100(2), third), Vec2(Digits100(-1), Digits100(0)), Digits100(1));
  EXPECT_LT(abs(t - (2 - sqrt(Digits100(8)) / 3)), Digits100("1e-98"));
}

TEST(LeaveTime, from_inside) {
  EXPECT_EQ(leave_time(V2(0, 0), V2(2, 0), 3.0), 1.5);
  EXPECT_EQ(leave_time(V2(1, 0), V2(2, 0), 3.0), 1.0);
  EXPECT_EQ(leave_time(V2(1, 0), V2(-2, 0), 3.0), 2.0);
  EXPECT_EQ(leave_time(V2(0, 3), V2(-1, 0), 5.0), 4.0);
  EXPECT_EQ(leave_time(V3(0, 3, 0), V3(0, 0, 1), 5.0), 4.0);
  EXPECT_EQ(leave_time(V2(1, 0), V2(0, 0), 3.0), no);
}

TEST(LeaveTime, from_outside_follows_the_overlap_rule) {
  EXPECT_EQ(leave_time(V2(4, 0), V2(1, 0), 3.0), 0.0);    // outward bound: now
  EXPECT_EQ(leave_time(V2(3, 0), V2(1, 0), 3.0), 0.0);
  EXPECT_EQ(leave_time(V2(3, 0), V2(0, 1), 3.0), 0.0);    // along the wall: curves away from it
  EXPECT_EQ(leave_time(V2(4, 0), V2(-1, 0), 3.0), 7.0);   // inward bound: through, and out on the other side
  EXPECT_EQ(leave_time(V2(-4, 5), V2(2, 0), 3.0), 2.0);   // never gets in: where it is nearest
  EXPECT_EQ(leave_time(V2(-4, 3), V2(2, 0), 3.0), 2.0);   // reaches 0 and turns there
  EXPECT_EQ(leave_time(V2(4, 0), V2(0, 0), 3.0), no);     // at rest: not falling
}

template <int D>
void expect_leaving_right(std::uint64_t seed) {
  oracle::Random random(seed);
  double worst = 0.0;
  for (int i = 0; i < 8000; ++i) {
    const double rho = random.log_uniform(1e-20, 1e20);
    const Vec<double, D> n = random.direction<D>();
    const Vec<double, D> m = random.across<D>(n);
    // Depth below the wall and angle with it log-uniform, or anywhere inside; some outside.
    const double depth = i % 3 == 0 ? random.uniform(-0.5, 1.0) : random.sign() * random.log_uniform(1e-17, 0.5);
    const double angle = i % 3 == 0 ? random.uniform(-3.2, 3.2) : random.sign() * random.log_uniform(1e-17, 1.0);
    const Vec<double, D> r = n * (rho * (1 - depth));
    const Vec<double, D> v = (m * std::cos(angle) + n * std::sin(angle)) * random.log_uniform(1e-20, 1e20);
    worst = std::max(worst, checked_leave<D>(r, v, rho));
  }
  testing::Test::RecordProperty("worst_in_u", std::to_string(worst));
  EXPECT_LE(worst, leave_time_error);
  EXPECT_GT(worst, leave_time_error / 20);
}
TEST(LeaveTime, is_right_and_within_its_bound_2d) { expect_leaving_right<2>(17); }
TEST(LeaveTime, is_right_and_within_its_bound_3d) { expect_leaving_right<3>(18); }

TEST(ChordTime, is_the_other_root) {
  EXPECT_EQ(chord_time(V2(3, 0), V2(-2, 0)), 3.0);
  EXPECT_EQ(chord_time(V2(3, 0), V2(-1, 1)), 3.0);
  EXPECT_EQ(chord_time(V2(3, 0), V2(0, 1)), 0.0);
  EXPECT_EQ(chord_time(V2(3, 0), V2(1e-17, 1)), 0.0);  // outward by rounding: along the wall
  EXPECT_EQ(chord_time(V2(3, 0), V2(0, 0)), no);
}

TEST(ChordTime, is_within_its_bound_along_the_wall) {
  // r.v cancels to 1e-17 of its terms: whispering galleries.
  oracle::Random random(19);
  double worst = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const V3 n = random.direction<3>();
    const V3 m = random.across<3>(n);
    const V3 r = n * random.log_uniform(1e-10, 1e10);
    const V3 v = (m - n * random.log_uniform(1e-17, 1e3)) * random.log_uniform(1e-10, 1e10);
    const auto terms = oracle::terms<3>(r, v, 0.0);
    if (terms.b >= 0) {
      EXPECT_EQ(chord_time(r, v), 0.0);
    } else {
      worst = std::max(worst, oracle::error_in_u(chord_time(r, v), Exact(-2 * terms.b / terms.a)));
    }
  }
  testing::Test::RecordProperty("worst_in_u", std::to_string(worst));
  EXPECT_LE(worst, chord_time_error);
  EXPECT_GT(worst, 1.0);
}

TEST(PairTerms, double_double_and_exact_agree) {
  oracle::Random random(20);
  const auto value = [](const Scaled& x) { return std::ldexp(x.mantissa, int(x.exponent)); };
  for (int i = 0; i < 500; ++i) {
    const V3 r = random.direction<3>();
    const V3 v = random.direction<3>();
    const PairTerms fast = pair_terms<3>(r, v, 0.5);
    const PairTerms exact = exact_pair_terms(r.data(), v.data(), 0.5, 3);
    EXPECT_NEAR(value(fast.a) / value(exact.a), 1.0, 0x1p-51);
    EXPECT_NEAR(value(fast.b) / value(exact.b), 1.0, 0x1p-51);
    EXPECT_NEAR(value(fast.c) / value(exact.c), 1.0, 0x1p-51);
    EXPECT_NEAR(value(fast.d) / value(exact.d), 1.0, 0x1p-51);
  }
}

TEST(PairTerms, exact_ones_hold_any_finite_input) {
  // sigma / |r| = 2^-2000: d = a sigma^2 - 0 when aimed at the centre, 4 2^-2000 / ... in size.
  const double huge = 0x1p1000;
  const double tiny = 0x1p-1000;
  const double r[] = {huge, 0.0};
  const double v[] = {-huge, 0.0};
  const PairTerms terms = exact_pair_terms(r, v, tiny, 2);
  EXPECT_EQ(terms.d.mantissa, 0.5);
  EXPECT_EQ(terms.d.exponent, 1);  // 2^2000 2^-2000 = 1 = 0.5 2^1
  EXPECT_EQ(meet_time(V2(huge, 0), V2(-huge, 0), tiny), 1.0);
  EXPECT_EQ(meet_time(V2(huge, 0), V2(-huge, std::numeric_limits<double>::denorm_min()), tiny), 1.0);
}

}  // namespace
}  // namespace carom
