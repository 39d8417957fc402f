// Overlap functions of degree up to 4: by hand, degenerate, against Sturm's theorem in 300 digits over coefficients of
// 1e-100 .. 1e100, and against GSL.

#include "carom/solve/polynomial.hpp"

#include <array>

#include <gsl/gsl_poly.h>
#include <gtest/gtest.h>

#include "solve/oracle.hpp"
#include "solve/sturm.hpp"

namespace carom {
namespace {

using oracle::Digits300;
const double no = never<double>();
using C5 = std::array<double, 5>;
using W5 = std::array<DoubleDouble, 5>;

DoubleDouble rounded(const Digits300& x) {
  const double hi = double(x);
  return fast_two_sum(hi, double(Digits300(x - Digits300(hi))));
}

// lead (t - r0)(t - r1)(t - r2)(t - r3), to double-double.
W5 from_roots(const Digits300& lead, const std::array<Digits300, 4>& roots) {
  std::array<Digits300, 5> c{lead};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = k + 1; i > 0; --i) c[i] = c[i - 1] - roots[k] * c[i];
    c[0] = -roots[k] * c[0];
  }
  W5 w;
  for (std::size_t i = 0; i < 5; ++i) w[i] = rounded(c[i]);
  return w;
}

// The stated bound over |t - truth|: at most 1 if it is kept.
template <class C>
double share_of_bound(const C& c, double t, const Digits300& truth) {
  if (truth == 0) return t == 0 ? 0.0 : INFINITY;
  const double u = 0x1p-53;
  Digits300 size = 0;
  Digits300 slope = 0;
  Digits300 power = 1;
  for (std::size_t i = 0; i < c.size(); ++i) {
    size += abs(Digits300(narrow(c[i]))) * power;
    if (i > 0) slope += int(i) * Digits300(narrow(c[i])) * power / truth;
    power *= truth;
  }
  const Digits300 bound = root_error * u * truth + root_noise * u * u * size / abs(slope);
  return double(Digits300(abs(Digits300(t) - truth) / bound));
}

TEST(FirstFallOfPolynomial, by_hand) {
  EXPECT_EQ(first_fall(C5{24, -50, 35, -10, 1}), 1.0);    // (t - 1)(t - 2)(t - 3)(t - 4)
  EXPECT_EQ(first_fall(C5{-24, 50, -35, 10, -1}), 2.0);   // below and rising; falls at 2
  EXPECT_EQ(first_fall(C5{-24, -50, -35, 10, 1}), 0.0);   // below and falling
  EXPECT_EQ(first_fall(C5{16, 0, 0, 0, -1}), 2.0);
  EXPECT_EQ(first_fall(C5{16, 0, 0, 0, 1}), no);
  EXPECT_EQ(first_fall(C5{1, 1, 1, 1, 1}), no);
  EXPECT_EQ(first_fall(C5{-1, 1, 1, 1, 1}), no);          // rises for ever
  EXPECT_EQ(first_fall(C5{24, 50, 35, 10, 1}), no);       // all roots are past
  EXPECT_EQ(first_fall(C5{4, 0, -5, 0, 1}), 1.0);         // (t^2 - 1)(t^2 - 4)
}

TEST(FirstFallOfPolynomial, of_the_order_that_is_there) {
  EXPECT_EQ(first_fall(C5{6, -5, 1, 0, 0}), 2.0);
  EXPECT_EQ(first_fall(C5{6, -11, 6, -1, 0}), 1.0);
  EXPECT_EQ(first_fall(C5{8, 0, 0, -1, 0}), 2.0);
  EXPECT_EQ(first_fall(C5{3, -2, 0, 0, 0}), 1.5);
  EXPECT_EQ(first_fall(C5{3, 0, 0, 0, 0}), no);
  EXPECT_EQ(first_fall(C5{0, 0, 0, 0, 0}), no);
  EXPECT_EQ(first_fall(C5{-3, 0, 0, 0, 0}), no);
  EXPECT_EQ(first_fall(std::array{3.0, -2.0}), 1.5);
  EXPECT_EQ(first_fall(std::array{-3.0}), no);
}

TEST(FirstFallOfPolynomial, starting_at_zero_looks_at_the_first_derivative_that_is_there) {
  EXPECT_EQ(first_fall(C5{0, -1, 5, 0, 0}), 0.0);
  EXPECT_EQ(first_fall(C5{0, 0, -1, 5, 0}), 0.0);
  EXPECT_EQ(first_fall(C5{0, 0, 0, -1, 5}), 0.0);
  EXPECT_EQ(first_fall(C5{0, 0, 0, 0, -1}), 0.0);
  EXPECT_EQ(first_fall(C5{0, 0, 0, 0, 1}), no);
  EXPECT_EQ(first_fall(C5{0, 0, 0, 2, -1}), 2.0);
  EXPECT_EQ(first_fall(C5{0, 2, -3, 1, 0}), 1.0);          // t (t - 1)(t - 2)
  EXPECT_EQ(first_fall(C5{-1, 0, 0, 1, 0}), no);
}

TEST(FirstFallOfPolynomial, touching_without_falling_is_no_event) {
  EXPECT_EQ(first_fall(C5{1, -4, 6, -4, 1}), no);          // (t - 1)^4
  EXPECT_EQ(first_fall(C5{4, -12, 13, -6, 1}), no);        // (t - 1)^2 (t - 2)^2
  EXPECT_EQ(first_fall(C5{1, -2, 2, -2, 1}), no);          // (t - 1)^2 (t^2 + 1)
  EXPECT_EQ(first_fall(C5{3, -7, 5, -1, 0}), 3.0);         // (t - 1)^2 (3 - t) touches at 1, falls at 3
  EXPECT_EQ(first_fall(C5{6, -17, 17, -7, 1}), 2.0);       // (t - 1)^2 (t - 2)(t - 3)
  EXPECT_NEAR(first_fall(C5{1, -3, 3, -1, 0}), 1.0, 1e-9); // (1 - t)^3 falls, though all derivatives vanish there
}

TEST(FirstFallOfPolynomial, below_and_turning_before_it_gets_out) {
  EXPECT_EQ(first_fall(C5{-2, 4, -3, 2, -1}), 1.0);             // -(t - 1)^2 (t^2 + 1) - 1: turns at 1
  EXPECT_NEAR(first_fall(C5{-1, 4, -6, 4, -1}), 1.0, 1e-9);     // -(t - 1)^4 reaches 0 and turns
  // Turns below zero at 1, gets out later: the event is the first turn. f' = -(t - 1)(t - 2)(t - 3) 4.
  EXPECT_EQ(first_fall(C5{-100, 24, -22, 8, -1}), 1.0);
}

TEST(FirstFallOfPolynomial, grazing_is_decided_to_thirty_digits) {
  // ((t - x)^2 +- e)(t^2 + 1) for x = 1/3, sqrt(2), ...: no root with +, a fall near x with -.
  oracle::Random random(41);
  for (int i = 0; i < 300; ++i) {
    const Digits300 x = sqrt(Digits300(random.log_uniform(1e-3, 1e3)));
    for (const int sign : {+1, 0, -1}) {
      const Digits300 e = sign * ldexp(Digits300(x * x), -90);
      const std::array<Digits300, 5> c{x * x + e, -2 * x, x * x + e + 1, -2 * x, Digits300(1)};
      W5 w;
      for (std::size_t k = 0; k < 5; ++k) w[k] = rounded(c[k]);
      const double t = first_fall(w);
      if (sign >= 0) {
        EXPECT_EQ(t, no) << x << ' ' << sign;
      } else {
        EXPECT_LE(share_of_bound(w, t, Digits300(x - sqrt(-e))), 1.0) << x;
      }
    }
  }
}

// A quarter of the coefficients are of one size, the rest log-uniform in `from` .. `to`; any signs.
double worst_share_of_bound(std::uint64_t seed, int n, double from, double to, int& events) {
  oracle::Random random(seed);
  const Digits300 limit = ldexp(Digits300(1), 1400);
  double worst = 0.0;
  for (int i = 0; i < n; ++i) {
    const int degree = random.whole(1, 4);
    C5 c{};
    for (int k = 0; k <= degree; ++k)
      c[k] = random.sign() * (i % 4 == 0 ? random.uniform(0.5, 2.0) : random.log_uniform(from, to));
    const double t = first_fall(c);
    const auto truth = oracle::first_fall(oracle::Coefficients(c.begin(), c.begin() + degree + 1), limit);
    EXPECT_EQ(truth.has_value(), t != no) << testing::PrintToString(c);
    if (!truth || t == no) continue;
    ++events;
    // A turning point is a root of f'.
    const bool turning = abs(oracle::evaluate(oracle::slope({c.begin(), c.end()}), *truth) * *truth) <
                         abs(Digits300(c[0])) * Digits300("1e-30");
    if (turning) {
      worst = std::max(worst, share_of_bound(std::array{c[1], 2 * c[2], 3 * c[3], 4 * c[4]}, t, *truth));
    } else {
      worst = std::max(worst, share_of_bound(c, t, *truth));
    }
  }
  testing::Test::RecordProperty("worst_share_of_bound", std::to_string(worst));
  return worst;
}

TEST(FirstFallOfPolynomial, agrees_with_sturm_on_moderate_coefficients) {
  int events = 0;
  EXPECT_LE(worst_share_of_bound(42, 400, 1e-3, 1e3, events), 1.0);
  EXPECT_GT(events, 150);
}

TEST(FirstFallOfPolynomial, agrees_with_sturm_on_coefficients_200_powers_of_ten_apart) {
  int events = 0;
  EXPECT_LE(worst_share_of_bound(43, 400, 1e-100, 1e100, events), 1.0);
  EXPECT_GT(events, 150);
}

TEST(FirstFallOfPolynomial, separates_close_roots) {
  // Two of the roots 1e-12 .. 1e-1 apart (relative), the first two or the second and third.
  oracle::Random random(44);
  double worst = 0.0;
  for (int i = 0; i < 120; ++i) {
    std::array<Digits300, 4> roots;
    roots[0] = sqrt(Digits300(random.log_uniform(1e-3, 1e3)));
    for (int k = 1; k < 4; ++k) {
      const double apart = k == 1 + i % 2 ? random.log_uniform(1e-12, 1e-1) : random.uniform(0.5, 2.0);
      roots[k] = roots[k - 1] * (1 + Digits300(apart));
    }
    if (i % 3 == 0) roots[3] = -roots[3];
    const W5 w = from_roots(Digits300(i % 3 == 0 ? -1 : 1), roots);  // positive at 0, so it falls at the first root
    oracle::Coefficients c;
    for (const auto& x : w) c.push_back(Digits300(x.hi) + Digits300(x.lo));
    const auto truth = oracle::positive_roots(c, ldexp(Digits300(1), 100));
    ASSERT_EQ(truth.size(), i % 3 == 0 ? 3U : 4U);
    worst = std::max(worst, share_of_bound(w, first_fall(w), truth[0]));
  }
  RecordProperty("worst_share_of_bound", std::to_string(worst));
  EXPECT_LE(worst, 1.0);
}

TEST(FirstFallOfPolynomial, agrees_with_gsl) {
  oracle::Random random(45);
  gsl_poly_complex_workspace* workspace = gsl_poly_complex_workspace_alloc(5);
  int events = 0;
  for (int i = 0; i < 2000; ++i) {
    C5 c;
    for (double& x : c) x = random.uniform(-1.0, 1.0);
    c[0] = std::fabs(c[0]) + 0.01;
    std::array<double, 8> z{};
    ASSERT_EQ(gsl_poly_complex_solve(c.data(), 5, workspace, z.data()), 0);
    double first = no;
    bool doubtful = false;
    for (std::size_t k = 0; k < 8; k += 2) {
      if (z[k] <= 0) continue;
      doubtful = doubtful || (std::fabs(z[k + 1]) > 0 && std::fabs(z[k + 1]) < 1e-6 * z[k]);
      if (std::fabs(z[k + 1]) < 1e-9 * z[k]) first = std::min(first, z[k]);
    }
    if (doubtful) continue;
    const double t = first_fall(c);
    ASSERT_EQ(first == no, t == no);
    if (t == no) continue;
    ++events;
    EXPECT_NEAR(t / first, 1.0, 1e-9);
  }
  EXPECT_GT(events, 500);
  gsl_poly_complex_workspace_free(workspace);
}

TEST(FirstFallOfPolynomial, does_not_change_with_the_unit_of_time) {
  oracle::Random random(46);
  for (int i = 0; i < 500; ++i) {
    C5 c;
    for (double& x : c) x = random.uniform(-1.0, 1.0);
    const double t = first_fall(c);
    for (const int k : {-150, 77, 150}) {
      C5 scaled;
      for (int j = 0; j < 5; ++j) scaled[j] = std::ldexp(c[j], j * k + 100);
      EXPECT_EQ(first_fall(scaled), std::ldexp(t, -k));
    }
  }
}

TEST(NextFallOfPolynomial, drops_the_root_at_zero) {
  EXPECT_EQ(next_fall(std::array{6.0, -5.0, 1.0}), 2.0);          // t (t - 2)(t - 3)
  EXPECT_EQ(next_fall(std::array{6.0, -11.0, 6.0, -1.0}), 1.0);   // t (1 - t)(t - 2)(t - 3)
  EXPECT_EQ(next_fall(std::array{0.0, 2.0, -1.0}), 2.0);          // t^2 (2 - t)
  EXPECT_EQ(next_fall(std::array{0.0, -2.0, 1.0}), 0.0);          // pressed together
  EXPECT_EQ(next_fall(std::array{-1e-18, -2.0, 1.0}), 0.0);
  EXPECT_EQ(next_fall(std::array{-1e-18, 2.0, 1.0}), no);         // rounding of a plastic impact
  EXPECT_EQ(next_fall(std::array{0.0, 0.0, 0.0}), no);
  EXPECT_EQ(next_fall(std::array{1.0, 2.0, 1.0}), no);
}

TEST(FirstFallOfPolynomial, in_more_digits) {
  using oracle::Digits100;
  // t^4 - 10 t^2 + 1 has the roots sqrt(3) +- sqrt(2).
  const std::array<Digits100, 5> c{Digits100(1), Digits100(0), Digits100(-10), Digits100(0), Digits100(1)};
  EXPECT_LT(abs(first_fall(c) - (sqrt(Digits100(3)) - sqrt(Digits100(2)))), Digits100("1e-97"));
}

}  // namespace
}  // namespace carom
