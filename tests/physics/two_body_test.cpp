// One collision of two balls against the formulas of the textbook, in one, two and three dimensions.
//
//   v1 = (m1 u1 + m2 u2 - e m2 (u1 - u2)) / (m1 + m2),   v2 = (m1 u1 + m2 u2 + e m1 (u1 - u2)) / (m1 + m2)
// along the line of centres; across it nothing changes. Kinetic energy lost: (1 - e^2) mu (u1 - u2)^2 / 2.

#include <gtest/gtest.h>

#include "sim/scenes.hpp"

namespace carom {
namespace {

using namespace testing;

constexpr double tolerance = 1e-14;

Coordinates along_x(int dimension, double x) {
  Coordinates c(static_cast<std::size_t>(dimension), 0.0);
  c[0] = x;
  return c;
}

struct HeadOn {
  double e, v1, v2, loss;
};

TEST(TwoBody, head_on_in_every_dimension) {
  for (const HeadOn& expected : {HeadOn{1.0, -2.2, 3.8, 0.0}, HeadOn{0.5, -0.4, 2.6, 16.2}, HeadOn{0.0, 1.4, 1.4, 21.6}})
    for (int d = 1; d <= 3; ++d) {
      Scene scene = open_space(d);
      scene.collision.restitution = expected.e;
      scene.balls = {ball(along_x(d, -3.0), along_x(d, 5.0), 0.5, 2.0), ball(along_x(d, 3.0), along_x(d, -1.0), 0.25, 3.0)};
      const Result result = run_until(scene, 10.0);
      ASSERT_EQ(result.log.size(), 1u) << "e " << expected.e << " in " << d << "-D";
      EXPECT_NEAR(result.log[0].time, (6.0 - 0.75) / 6.0, tolerance);
      EXPECT_NEAR(result.balls[0].velocity[0], expected.v1, tolerance);
      EXPECT_NEAR(result.balls[1].velocity[0], expected.v2, tolerance);
      for (std::size_t k = 1; k < std::size_t(d); ++k) {
        EXPECT_EQ(result.balls[0].velocity[k], 0.0);
        EXPECT_EQ(result.balls[1].velocity[k], 0.0);
      }
      EXPECT_NEAR(result.summary.energy.dissipated, expected.loss, 1e-14 * 30);
      EXPECT_LE(result.summary.energy.relative_error, tolerance);
      ASSERT_TRUE(result.summary.momentum.relative_error.has_value());
      EXPECT_LE(*result.summary.momentum.relative_error, tolerance);
    }
}

// Half-ball hit: the line of centres is at 30 degrees, and equal balls part at a right angle.
TEST(TwoBody, oblique_hit_on_an_equal_ball_at_rest) {
  Scene scene = open_space(2);
  scene.balls = {ball({-5.0, 1.0}, {1.0, 0.0}, 1.0), ball({0.0, 0.0}, {0.0, 0.0}, 1.0)};
  const Result result = run_until(scene, 10.0);
  ASSERT_EQ(result.log.size(), 1u);
  EXPECT_NEAR(result.log[0].time, 3.267949192431123, tolerance * 4);  // 5 - sqrt(3)
  const auto &a = result.balls[0].velocity, &b = result.balls[1].velocity;
  const double root = std::sqrt(3.0) / 4.0;
  EXPECT_NEAR(a[0], 0.25, tolerance);
  EXPECT_NEAR(a[1], root, tolerance);
  EXPECT_NEAR(b[0], 0.75, tolerance);
  EXPECT_NEAR(b[1], -root, tolerance);
  EXPECT_NEAR(a[0] * b[0] + a[1] * b[1], 0.0, tolerance);
}

// The lecture's recipe (normal and tangent parts) in long double, on random oblique hits.
TEST(TwoBody, oblique_hits_follow_the_normal_and_tangent_recipe) {
  using Wider = long double;
  Dice dice(11);
  for (int d = 2; d <= 3; ++d)
    for (int i = 0; i < 300; ++i) {
      const double e = i % 3 == 0 ? 1.0 : i % 3 == 1 ? 0.5 : 0.0;
      Scene scene = open_space(d);
      scene.collision.restitution = e;
      const double r1 = dice.between(0.2, 1.0), r2 = dice.between(0.2, 1.0), m1 = dice.between(0.1, 10),
                   m2 = dice.between(0.1, 10);
      Coordinates x1, x2, u1, u2;
      for (int k = 0; k < d; ++k) {
        x1.push_back(k == 0 ? -3.0 : dice.between(-0.1, 0.1));
        x2.push_back(k == 0 ? 3.0 : dice.between(-0.1, 0.1));
        u1.push_back(k == 0 ? dice.between(0.5, 2.0) : dice.between(-0.02, 0.02));
        u2.push_back(k == 0 ? dice.between(-2.0, 0.3) : dice.between(-0.02, 0.02));
      }
      scene.balls = {ball(x1, u1, r1, m1), ball(x2, u2, r2, m2)};
      const Result result = run_until(scene, 100.0);
      ASSERT_EQ(result.log.size(), 1u) << d << "-D, case " << i;
      std::array<Wider, 3> n{};
      Wider length = 0, un1 = 0, un2 = 0;
      for (int k = 0; k < d; ++k) {
        n[k] = Wider(result.log[0].partner.position[k]) - result.log[0].ball.position[k];
        length += n[k] * n[k];
      }
      length = std::sqrt(length);
      EXPECT_NEAR(double(length), r1 + r2, 1e-14);
      for (int k = 0; k < d; ++k) {
        n[k] /= length;
        un1 += n[k] * Wider(u1[k]);
        un2 += n[k] * Wider(u2[k]);
      }
      const Wider common = (m1 * un1 + m2 * un2) / (Wider(m1) + m2);
      const Wider vn1 = common - e * m2 * (un1 - un2) / (Wider(m1) + m2),
                  vn2 = common + e * m1 * (un1 - un2) / (Wider(m1) + m2);
      for (int k = 0; k < d; ++k) {
        EXPECT_NEAR(result.balls[0].velocity[k], double(Wider(u1[k]) + (vn1 - un1) * n[k]), tolerance);
        EXPECT_NEAR(result.balls[1].velocity[k], double(Wider(u2[k]) + (vn2 - un2) * n[k]), tolerance);
      }
      const Wider mu = Wider(m1) * m2 / (Wider(m1) + m2);
      EXPECT_NEAR(result.log[0].dissipated, double(mu * (1 - Wider(e) * e) * (un1 - un2) * (un1 - un2) / 2), 1e-13);
      EXPECT_NEAR(result.log[0].impulse, double(mu * (1 + Wider(e)) * (un1 - un2)), 1e-13);
    }
}

// A fixed ball is a wall, and so is a very heavy one, up to its lightness.
TEST(TwoBody, a_fixed_ball_reflects) {
  Scene scene = open_space(2);
  scene.balls = {ball({-5.0, 0.0}, {1.0, 0.0}, 1.0), ball({0.0, 0.0}, {0.0, 0.0}, 1.0)};
  scene.balls[1].fixed = true;
  const Result result = run_until(scene, 10.0);
  ASSERT_EQ(result.log.size(), 1u);
  EXPECT_EQ(result.balls[0].velocity[0], -1.0);
  EXPECT_EQ(result.balls[1].position[0], 0.0);
  EXPECT_EQ(result.summary.energy.relative_error, 0.0);
  EXPECT_FALSE(result.summary.momentum.relative_error.has_value());
}

// Without loss or wall: e between 0 and 1 is the ratio of the relative normal speeds for every material rule of the scene.
TEST(TwoBody, restitution_is_looked_up_pair_before_smaller_before_default) {
  Scene scene = open_space(1);
  scene.collision.restitution = 0.9;
  MaterialSpec ivory, rubber, lead;
  ivory.name = "ivory";
  ivory.restitution = 0.75;
  rubber.name = "rubber";
  rubber.restitution = 0.5;
  lead.name = "lead";
  lead.restitution = 0.25;
  scene.materials = {ivory, rubber, lead};
  MaterialPairSpec pair;
  pair.first = "rubber";
  pair.second = "ivory";
  pair.restitution = 0.625;
  scene.material_pairs = {pair};
  const auto ratio = [&](const std::string& a, const std::string& b) {
    Scene s = scene;
    s.balls = {ball({0.0}, {1.0}), ball({2.0}, {-1.0})};
    s.balls[0].material = a;
    s.balls[1].material = b;
    const Result result = run_until(s, 5.0);
    return (result.balls[1].velocity[0] - result.balls[0].velocity[0]) / 2.0;
  };
  EXPECT_EQ(ratio("ivory", "rubber"), 0.625);
  EXPECT_EQ(ratio("ivory", "lead"), 0.25);
  EXPECT_EQ(ratio("", "lead"), 0.25);
  EXPECT_NEAR(ratio("", ""), 0.9, 1e-15);
}

}  // namespace
}  // namespace carom
