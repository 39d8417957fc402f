// Restitution of viscoelastic spheres, against the equation of motion.

#include "carom/law/viscoelastic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

/// x'' = -x^(3/2) - B x^(1/2) x' from x = 0, x' = 1 to x'' = 0, by Runge and Kutta's fourth order: -x' there
/// [papers/viscoelastic.md, eq. 2], B = y^2.
double integrated(double B) {
  const auto force = [B](double x, double v) { return x > 0 ? -std::sqrt(x) * (x + B * v) : 0.0; };
  const double h = 1e-4;
  double x = 0, v = 1;
  while (true) {
    const double a1 = force(x, v), v1 = v;
    const double v2 = v + h / 2 * a1, a2 = force(x + h / 2 * v1, v2);
    const double v3 = v + h / 2 * a2, a3 = force(x + h / 2 * v2, v3);
    const double v4 = v + h * a3, a4 = force(x + h * v3, v4);
    const double X = x + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4), V = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    const double before = x + B * v, after = X + B * V;  // falls through 0 with the force
    if (V < 0 && after <= 0) return -(v + before / (before - after) * (V - v));
    x = X;
    v = V;
  }
}

TEST(Viscoelastic, is_what_the_equation_of_motion_gives) {
  for (const double y : {0.05, 0.1, 0.2, 0.3}) EXPECT_NEAR(viscoelastic_restitution(y), integrated(y * y), 4e-5) << y;
  for (const double y : {0.5, 0.7, 1.0, 1.5, 2.0})
    EXPECT_NEAR(viscoelastic_restitution(y), integrated(y * y), 0.009) << "the approximant's own error at y = " << y;
}

TEST(Viscoelastic, falls_from_1_and_never_exceeds_it) {
  EXPECT_EQ(viscoelastic_restitution(0.0), 1.0);
  for (double y = 1e-12; y < 1e-8; y *= 1.01) EXPECT_LE(viscoelastic_restitution(y), 1.0);
  double last = 1.0;
  for (double y = 1e-4; y < 1e6; y *= 1.1) {
    const double e = viscoelastic_restitution(y);
    EXPECT_LT(e, last) << y;
    EXPECT_GT(e, 0.0);
    last = e;
  }
}

TEST(Viscoelastic, argument_is_the_inverse) {
  EXPECT_EQ(viscoelastic_argument(1.0), 0.0);
  for (const double e : {1 - 1e-12, 0.999, 0.9, 0.5, 0.1, 1e-3, 1e-9})
    EXPECT_NEAR(viscoelastic_restitution(viscoelastic_argument(e)), e, 1e-15) << e;
}

TEST(Viscoelastic, tenth_root) {
  EXPECT_EQ(tenth_root(0.0), 0.0);
  EXPECT_EQ(tenth_root(1.0), 1.0);
  EXPECT_EQ(tenth_root(1024.0), 2.0);
  EXPECT_EQ(tenth_root(0x1p-60), 0x1p-6);
  for (double v = 1e-300; v < 1e300; v *= 37.7)
    EXPECT_NEAR(tenth_root(v) / static_cast<double>(std::pow(static_cast<long double>(v), 0.1L)), 1.0, 4e-16) << v;
}

}  // namespace
}  // namespace carom
