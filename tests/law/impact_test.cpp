// The impact of two bodies against the same formula with a hundred digits.

#include "carom/law/impact.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

namespace carom {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;
constexpr double infinity = std::numeric_limits<double>::infinity();

class Dice {
 public:
  double between(double low, double high) { return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53; }
  /// Either sign, sizes from 2^-40 to 2^40.
  double any() { return std::ldexp(between(0.5, 1.0), static_cast<int>(between(-40, 40))) * (between(-1, 1) < 0 ? -1 : 1); }

 private:
  std::mt19937_64 bits_{4};
};

template <int D>
Impact<double, D> random_impact(Dice& dice, bool wild) {
  Impact<double, D> in;
  for (int k = 0; k < D; ++k) {
    in.r[k] = Wide<double>(wild ? dice.any() : dice.between(-1, 1));
    in.va[k] = wild ? dice.any() : dice.between(-1, 1);
    in.vb[k] = wild ? dice.any() : dice.between(-1, 1);
  }
  in.ma = wild ? std::abs(dice.any()) : dice.between(0.5, 2);
  in.mb = wild ? std::abs(dice.any()) : dice.between(0.5, 2);
  in.e = dice.between(0, 1) < 0.3 ? 1.0 : dice.between(0, 1);
  return in;
}

template <int D>
Impact<Exact, D> exactly(const Impact<double, D>& in) {
  Impact<Exact, D> out;
  for (int k = 0; k < D; ++k) {
    out.r[k] = Exact(in.r[k].hi) + Exact(in.r[k].lo);
    out.va[k] = in.va[k];
    out.vb[k] = in.vb[k];
  }
  out.ma = in.ma == infinity ? std::numeric_limits<Exact>::infinity() : Exact(in.ma);
  out.mb = in.mb == infinity ? std::numeric_limits<Exact>::infinity() : Exact(in.mb);
  out.e = in.e;
  return out;
}

double ulp(double x) { return std::nextafter(std::abs(x), infinity) - std::abs(x); }

/// Every velocity is the exact one rounded once: half an ulp, and 2^-98 of what it is a difference of.
template <int D>
void expect_rounded_once(bool wild, double share_of_infinite) {
  Dice dice;
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    Impact<double, D> in = random_impact<D>(dice, wild);
    if (dice.between(0, 1) < share_of_infinite) (dice.between(-1, 1) < 0 ? in.ma : in.mb) = infinity;
    const Outcome<double, D> got = resolve_impact<double, D>(in);
    const Outcome<Exact, D> want = resolve_impact<Exact, D>(exactly<D>(in));
    hits += got.impulse > 0;
    for (int k = 0; k < D; ++k) {
      const Exact size_a = abs(Exact(want.va[k] - Exact(in.va[k]))) + std::abs(in.va[k]);
      const Exact size_b = abs(Exact(want.vb[k] - Exact(in.vb[k]))) + std::abs(in.vb[k]);
      ASSERT_LE(double(Exact(abs(Exact(Exact(got.va[k]) - want.va[k])) - size_a * 0x1p-98)), 0.5 * ulp(got.va[k]))
          << D << "-D, case " << i;
      ASSERT_LE(double(Exact(abs(Exact(Exact(got.vb[k]) - want.vb[k])) - size_b * 0x1p-98)), 0.5 * ulp(got.vb[k]))
          << D << "-D, case " << i;
    }
    const double impulse = double(want.impulse), dissipated = double(want.dissipated);
    ASSERT_NEAR(got.impulse, impulse, 4 * ulp(impulse));
    ASSERT_NEAR(narrow(got.dissipated), dissipated, 4 * ulp(dissipated));
  }
  EXPECT_GT(hits, 8000);
  EXPECT_LT(hits, 12000);
}

TEST(Impact, each_velocity_is_rounded_once) {
  expect_rounded_once<1>(false, 0.2);
  expect_rounded_once<2>(false, 0.2);
  expect_rounded_once<3>(false, 0.2);
}

TEST(Impact, whatever_the_sizes) {
  expect_rounded_once<1>(true, 0.0);
  expect_rounded_once<2>(true, 0.0);
  expect_rounded_once<3>(true, 0.0);
}

// In exact arithmetic the books balance: m v^2 / 2 before + injected = after + dissipated, and the momenta of finite
// masses.
template <int D>
void expect_balance() {
  Dice dice;
  for (int i = 0; i < 2000; ++i) {
    Impact<double, D> rounded = random_impact<D>(dice, false);
    if (i % 4 == 0) rounded.ma = infinity;
    if (i % 4 == 1) rounded.mb = infinity;
    const Impact<Exact, D> in = exactly<D>(rounded);
    const Outcome<Exact, D> out = resolve_impact<Exact, D>(in);
    Exact gain = 0, momentum = 0, closing = 0, parting = 0;
    for (int k = 0; k < D; ++k) {
      if (i % 4 != 0) gain += in.ma * (out.va[k] * out.va[k] - in.va[k] * in.va[k]) / 2;
      if (i % 4 != 1) gain += in.mb * (out.vb[k] * out.vb[k] - in.vb[k] * in.vb[k]) / 2;
      if (i % 4 > 1) momentum += abs(Exact(in.ma * (out.va[k] - in.va[k]) + in.mb * (out.vb[k] - in.vb[k])));
      closing += (in.va[k] - in.vb[k]) * in.r[k];
      parting += (out.vb[k] - out.va[k]) * in.r[k];
    }
    ASSERT_LE(abs(Exact(gain + out.dissipated - out.injected)), Exact(1e-90));
    ASSERT_LE(momentum, Exact(1e-90));
    const Exact expected = closing > 0 ? Exact(in.e * closing) : Exact(-closing);  // parting already: left alone
    ASSERT_LE(abs(Exact(parting - expected)), Exact(1e-90));
  }
}

TEST(Impact, balances_energy_and_momentum_and_obeys_the_restitution) {
  expect_balance<1>();
  expect_balance<2>();
  expect_balance<3>();
}

TEST(Impact, bodies_never_pull) {
  Impact<double, 2> in;
  in.r = {Wide<double>(1.0), Wide<double>(0.0)};
  in.ma = 2.0;
  in.mb = 3.0;
  in.e = 0.5;
  in.va << -1.0, 2.0;
  in.vb << 1.0, 3.0;
  const Outcome<double, 2> parting = resolve_impact<double, 2>(in);
  EXPECT_EQ(parting.va, in.va);
  EXPECT_EQ(parting.vb, in.vb);
  EXPECT_EQ(parting.impulse, 0.0);
  in.vb = in.va;
  EXPECT_EQ((resolve_impact<double, 2>(in).impulse), 0.0) << "together";
}

TEST(Impact, equal_masses_on_a_line_exchange_velocities_bit_for_bit) {
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    Impact<double, 1> in;
    in.r = {Wide<double>(dice.between(1e-3, 1.0))};
    in.ma = in.mb = dice.between(0.1, 10);
    in.e = 1.0;
    in.va << dice.between(0.0, 1.0);
    in.vb << dice.between(-1.0, 0.0);
    const Outcome<double, 1> out = resolve_impact<double, 1>(in);
    ASSERT_EQ(out.va[0], in.vb[0]);
    ASSERT_EQ(out.vb[0], in.va[0]);
  }
}

// An infinite mass keeps its velocity, and a wall at rest across an axis turns one component round exactly.
TEST(Impact, infinite_masses_keep_their_velocity) {
  Impact<double, 3> in;
  in.r = {Wide<double>(0.0), Wide<double>(-1.0), Wide<double>(0.0)};
  in.va << 0.1, -0.7, 0.3;
  in.vb << 0.0, 0.0, 0.0;
  in.ma = 0.3;
  in.mb = infinity;
  in.e = 1.0;
  const Outcome<double, 3> out = resolve_impact<double, 3>(in);
  EXPECT_EQ(out.va, (Vec<double, 3>(0.1, 0.7, 0.3)));
  EXPECT_EQ(out.vb, in.vb);
  EXPECT_EQ(narrow(out.injected), 0.0);
  in.vb << 5.0, 0.25, 0.0;  // the wall comes towards the ball
  const Outcome<double, 3> pushed = resolve_impact<double, 3>(in);
  EXPECT_EQ(pushed.vb, in.vb);
  EXPECT_NEAR(pushed.va[1], 1.2, 1e-15);
  EXPECT_NEAR(narrow(pushed.injected), 0.5 * 0.3 * (1.2 * 1.2 - 0.7 * 0.7), 1e-16);
}

}  // namespace
}  // namespace carom
