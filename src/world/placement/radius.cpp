#include "carom/world/placement/radius.hpp"

#include <bit>
#include <cmath>
#include <numbers>

namespace carom {

double cube_root(double x) {
  if (!(x > 0.0)) return 0.0;
  const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52) - 1023;
  const int third = (exponent + 1200) / 3 - 400;  // floor of exponent / 3
  const auto power_of_two = [](int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52); };
  const double m = x * power_of_two(-third) * power_of_two(-third) * power_of_two(-third);  // [1, 8)
  double y = 0.75 + 0.25 * m - 0.0138 * m * m;                                              // within 15 %
  for (int i = 0; i < 6; ++i) y -= (y * y * y - m) / (3.0 * y * y);
  return y * power_of_two(third);
}

double dimensional_root(double x, int dimension) {
  return dimension == 1 ? x : dimension == 2 ? std::sqrt(x) : cube_root(x);
}

double dimensional_power(double x, int dimension) { return dimension == 1 ? x : dimension == 2 ? x * x : x * x * x; }

namespace {
double unit_ball(int dimension) {
  return dimension == 1 ? 2.0 : dimension == 2 ? std::numbers::pi : 4.0 * std::numbers::pi / 3.0;
}
}  // namespace

double ball_volume(double radius, int dimension) { return unit_ball(dimension) * dimensional_power(radius, dimension); }

double region_volume(const Region& region) {
  double volume = 1.0;
  for (int k = 0; k < region.dimension; ++k) volume *= region.length(k);
  return volume;
}

double radius_for_packing(double packing, std::int64_t count, double volume, int dimension) {
  return dimensional_root(packing * volume / (static_cast<double>(count) * unit_ball(dimension)), dimension);
}

}  // namespace carom
