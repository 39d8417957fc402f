// Proofs that a polynomial is positive over an interval: never one that is wrong, and one wherever there is room.

#include "carom/certify/positivity.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "certify/enclosure.hpp"
#include "sim/scenes.hpp"

namespace carom::certify {
namespace {

using carom::testing::Dice;

template <class I>
Polynomial<I> times_root(const Polynomial<I>& p, double root) {
  Polynomial<I> q(p.size() + 1, I(0.0));
  for (std::size_t k = 0; k < p.size(); ++k) {
    q[k + 1] = q[k + 1] + p[k];
    q[k] = q[k] - I(root) * p[k];
  }
  return q;
}

template <class I>
Proof over(const Polynomial<I>& p, double from, double to, int depth = 40) {
  return positive(bernstein(p, I(from), I(to)), depth);
}

// (t - 1)(t - 3) is positive before 1 and after 3.
TEST(Positive, knows_a_parabola) {
  const Polynomial<Outward> p{3.0, -4.0, 1.0};
  EXPECT_EQ(over(p, -2.0, 0.999), Proof::yes);
  EXPECT_EQ(over(p, 3.001, 100.0), Proof::yes);
  EXPECT_EQ(over(p, 0.0, 2.0), Proof::no);
  EXPECT_EQ(over(p, 0.0, 4.0), Proof::no) << "both ends are positive, the middle is not";
  EXPECT_EQ(over(p, 0.0, 1.0), Proof::unknown) << "it is 0 at the end";
}

// t^2 - 2 t + 1 + gap has its minimum gap at 1.
TEST(Positive, tells_a_near_miss_from_a_graze) {
  EXPECT_EQ(over(Polynomial<Outward>{1.0 + 0x1p-30, -2.0, 1.0}, 0.0, 3.0), Proof::yes);
  EXPECT_NE(over(Polynomial<Outward>{1.0, -2.0, 1.0}, 0.0, 3.0), Proof::yes);
  const Bits scope(400);
  const Enclosure gap = Enclosure::near("1e-100");
  EXPECT_EQ(over(Polynomial<Enclosure>{Enclosure(1.0) + gap, -2.0, 1.0}, 0.0, 3.0, 400), Proof::yes);
  EXPECT_EQ(over(Polynomial<Enclosure>{Enclosure(1.0) - gap, -2.0, 1.0}, 0.0, 3.0, 400), Proof::no);
}

// Random roots: the truth is known from them.
TEST(Positive, is_never_wrong) {
  Dice dice(4);
  int proven = 0, refuted = 0;
  for (int n = 0; n < 4000; ++n) {
    const int degree = 1 + static_cast<int>(dice.between(0.0, 4.0));
    Polynomial<Outward> p{Outward(dice.between(-1.0, 1.0))};
    double sign = p[0].lower > 0 ? 1.0 : -1.0;
    bool root_inside = false;
    for (int k = 0; k < degree; ++k) {
      const double root = dice.between(-3.0, 3.0);
      p = times_root(p, root);
      root_inside = root_inside || (root > -1.0 && root < 1.0);
      if (root >= 1.0) sign = -sign;
    }
    const Proof proof = over(p, -1.0, 1.0);
    const bool is_positive_there = !root_inside && sign > 0;
    EXPECT_FALSE(proof == Proof::yes && !is_positive_there);
    EXPECT_FALSE(proof == Proof::no && is_positive_there);
    proven += proof == Proof::yes;
    refuted += proof == Proof::no;
  }
  EXPECT_GT(proven, 500);
  EXPECT_GT(proven + refuted, 3950) << "what is undecided is rare";
}

// Of two that take turns at least one is positive: t - 1 and 2 - t on [0, 3]; not so t - 2 and 1 - t.
TEST(OnePositive, follows_the_turns) {
  const auto ways = [](double a, double b) {
    return std::vector<std::vector<Outward>>{bernstein(Polynomial<Outward>{-a, 1.0}, Outward(0.0), Outward(3.0)),
                                             bernstein(Polynomial<Outward>{b, -1.0}, Outward(0.0), Outward(3.0))};
  };
  EXPECT_EQ(one_positive(ways(1.0, 2.0), 40), Proof::yes);
  EXPECT_EQ(one_positive(ways(1.0, 1.0 + 0x1p-20), 40), Proof::yes);
  EXPECT_EQ(one_positive(ways(2.0, 1.0), 40), Proof::no);
  EXPECT_NE(one_positive(ways(1.5, 1.5), 40), Proof::yes);
}

// (t - 2)(t^2 + 1): without its root it is positive everywhere.
TEST(WithoutRoot, divides) {
  const Polynomial<Outward> p{-2.0, 1.0, -2.0, 1.0};
  const Polynomial<Outward> q = without_root(p, Outward(2.0));
  ASSERT_EQ(q.size(), 3u);
  EXPECT_NEAR(q[0].lower, 1.0, 1e-15);
  EXPECT_NEAR(q[1].lower, 0.0, 1e-15);
  EXPECT_NEAR(q[2].lower, 1.0, 1e-15);
  EXPECT_EQ(over(q, -10.0, 10.0), Proof::yes);
}

}  // namespace
}  // namespace carom::certify
