#include "carom/world/placement/radius.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "carom/core/random.hpp"

namespace carom {
namespace {

TEST(CubeRoot, is_exact_on_cubes) {
  for (int n = 0; n < 1000; ++n) EXPECT_EQ(cube_root(static_cast<double>(n) * n * n), n);
  EXPECT_EQ(cube_root(0x1p-1020), 0x1p-340);
  EXPECT_EQ(cube_root(0x1p+1023), 0x1p+341);
}

TEST(CubeRoot, Bound) {
  using Wide = boost::multiprecision::cpp_bin_float_50;
  RandomStream draw(1, 1);
  double worst = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const double x = std::ldexp(0.5 + 0.5 * draw.uniform(), static_cast<int>(draw.uniform() * 2000) - 1000);
    const double y = cube_root(x), ulp = std::nextafter(y, INFINITY) - y;
    // y^3 - x = (y - t)(3 t^2) to first order in the error, t the root.
    const Wide error = (Wide(y) * Wide(y) * Wide(y) - Wide(x)) / (3 * Wide(y) * Wide(y));
    worst = std::max(worst, std::abs(error.convert_to<double>()) / ulp);
  }
  RecordProperty("ulp", std::to_string(worst));
  EXPECT_LT(worst, cube_root_ulp);
}

TEST(Radius, fills_what_was_asked) {
  for (int d = 1; d <= 3; ++d) {
    const double r = radius_for_packing(0.3, 700, 123.0, d);
    EXPECT_NEAR(700 * ball_volume(r, d) / 123.0, 0.3, 1e-15) << d;
  }
  EXPECT_EQ(radius_for_packing(0.5, 10, 20.0, 1), 0.5);  // 10 rods of length 1 on half of 20
  EXPECT_NEAR(ball_volume(1.0, 2), 3.14159265358979, 1e-14);
  EXPECT_NEAR(ball_volume(1.0, 3), 4.18879020478639, 1e-14);
}

}  // namespace
}  // namespace carom
