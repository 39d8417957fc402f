// The elastic impact with what is known beforehand: where it is certain, its bits are those of resolve_impact; and it nearly
// always is.

#include "carom/law/elastic.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace carom {
namespace {

constexpr double infinite_mass = std::numeric_limits<double>::infinity();

class Dice {
 public:
  double between(double low, double high) { return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53; }
  /// Either sign, sizes from 2^-30 to 2^30.
  double any() { return std::ldexp(between(0.5, 1.0), static_cast<int>(between(-30, 30))) * (between(-1, 1) < 0 ? -1 : 1); }

 private:
  std::mt19937_64 bits_{9};
};

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

struct Seen {
  int certain = 0, different = 0, certain_in_lanes = 0;
};

/// The same impact, all components at a time.
template <int D>
void check_lanes(Seen& seen, const ElasticPair& pair, const Impact<double, D>& in, const double* high, const double* low) {
  WideLanes r;
  Lanes va = {}, vb = {}, after_a, after_b;
  for (int k = 0; k < D; ++k) {
    r.hi[k] = high[k];
    r.lo[k] = low[k];
    va[k] = in.va[k];
    vb[k] = in.vb[k];
  }
  double excess;
  if (!elastic_impact<D>(pair, r, va, vb, after_a, after_b, excess)) return;
  ++seen.certain_in_lanes;
  const Outcome<double, D> out = resolve_impact(in);
  for (int k = 0; k < D; ++k) seen.different += !same(out.va[k], after_a[k]) || !same(out.vb[k], after_b[k]);
}

/// Two bodies in contact but for rounding, one of them `periods` images of length `edge` away. `away`: relative error of the
/// distance.
template <int D>
Seen impacts(Dice& dice, int count, double ma, double mb, double periods, double edge, double away, bool wild) {
  Seen seen;
  const double sigma = dice.between(0.3, 0.7);
  const ElasticPair pair = elastic_pair(sigma, ma, mb, (periods + 1) * edge);
  for (int n = 0; n < count; ++n) {
    Vec<double, D> normal, xa, xb, va, vb;
    double turns[D];
    for (int k = 0; k < D; ++k) normal[k] = dice.between(-1, 1);
    normal /= std::sqrt(dot<double, D>(normal, normal));
    for (int k = 0; k < D; ++k) {
      turns[k] = std::nearbyint(dice.between(-periods, periods));
      xb[k] = dice.between(0, 1);
      xa[k] = xb[k] + turns[k] * edge - normal[k] * sigma * (1 + away * dice.between(-1, 1));
      va[k] = wild ? dice.any() : dice.between(-1, 1);
      vb[k] = mb == infinite_mass ? 0.0 : wild ? dice.any() : dice.between(-1, 1);
    }
    Impact<double, D> in;
    double high[D], low[D], after_a[D], after_b[D], excess;
    for (int k = 0; k < D; ++k) {
      in.r[k] = wide_difference<double>(xb[k], xa[k]) + wide_product<double>(turns[k], edge);
      const DoubleDouble shift = two_prod(turns[k], edge), image = two_sum(xb[k], shift.hi), r = two_diff(image.hi, xa[k]);
      high[k] = r.hi;
      low[k] = r.lo + (image.lo + shift.lo);
    }
    in.va = va;
    in.vb = vb;
    in.ma = ma;
    in.mb = mb;
    in.e = 1.0;
    const bool certain = elastic_impact<D>(pair, high, low, va.data(), vb.data(), after_a, after_b, excess);
    if (ma == mb) check_lanes<D>(seen, pair, in, high, low);
    if (!certain) continue;
    ++seen.certain;
    const Outcome<double, D> out = resolve_impact(in);
    for (int k = 0; k < D; ++k) seen.different += !same(out.va[k], after_a[k]) || !same(out.vb[k], after_b[k]);
  }
  return seen;
}

// Half of all pairs separate, which is never certain.
TEST(ElasticImpact, has_the_bits_of_resolve_impact) {
  Dice dice;
  constexpr int count = 20000;
  for (const double mb : {1.0, 0.3, 7e5, infinite_mass})
    for (const double away : {0.0, 1e-15, 5e-15}) {
      const Seen plane = impacts<2>(dice, count, 1.0, mb, 0, 0, away, false);
      const Seen space = impacts<3>(dice, count, 1.0, mb, 3, 1.37, away, false);
      EXPECT_EQ(plane.different, 0);
      EXPECT_EQ(space.different, 0);
      EXPECT_GT(plane.certain, 0.48 * count);
      EXPECT_GT(space.certain, 0.48 * count);
      EXPECT_LT(plane.certain, 0.52 * count);
      EXPECT_EQ(plane.certain_in_lanes, mb == 1.0 ? plane.certain : 0);
      EXPECT_EQ(space.certain_in_lanes, mb == 1.0 ? space.certain : 0);
    }
}

TEST(ElasticImpact, is_in_doubt_rather_than_wrong) {
  Dice dice;
  for (const double mb : {1.0, 1e-6, infinite_mass})
    for (const double away : {1e-13, 1e-10, 1e-3}) {
      EXPECT_EQ(impacts<2>(dice, 20000, 1.0, mb, 64, 1e3, away, true).different, 0);
      EXPECT_EQ(impacts<3>(dice, 20000, 1.0, mb, 64, 1e5, away, true).different, 0);
    }
}

// A gap of 2^-40 sigma: d^2 could show, so nothing is certain.
TEST(ElasticImpact, leaves_what_is_far_from_contact) {
  const ElasticPair pair = elastic_pair(1.0, 1.0, 1.0, 0);
  const double high[] = {1 + 0x1p-40, 0}, low[] = {0, 0}, va[] = {0.7, 0.1}, vb[] = {0, 0};
  double a[2], b[2], excess;
  EXPECT_FALSE(elastic_impact<2>(pair, high, low, va, vb, a, b, excess));
}

}  // namespace
}  // namespace carom
