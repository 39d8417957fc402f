#include "carom/observe/enskog.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace carom {

double sphere_area(int dimension) {
  return dimension == 1 ? 2.0 : dimension == 2 ? 2 * std::numbers::pi : 4 * std::numbers::pi;
}

double enskog_free_time(const Subject& s) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (s.space == SpaceKind::open || s.free == 0) return unknown;
  const double d = s.dimension, count = static_cast<double>(s.free);
  double diameter = 0, mass = 0, twice_energy = 0, filled = 0;
  for (std::uint32_t i = 0; i < s.mass.size(); ++i) {
    if (!s.moves_freely(i)) continue;
    diameter += 2 * s.radius[i] / count;
    mass += s.mass[i] / count;
    filled += sphere_area(s.dimension) / d * std::pow(s.radius[i], d);
    for (const double v : s.velocity[i]) twice_energy += s.mass[i] * v * v;
  }
  const double eta = filled / s.volume(), left = 1 - eta;
  const double contact = s.dimension == 1   ? 1 / left
                         : s.dimension == 2 ? (1 - 7 * eta / 16) / (left * left)
                                            : (1 - eta / 2) / (left * left * left);
  const double speed = std::sqrt(twice_energy / (d * count * mass * std::numbers::pi));
  const double rate = sphere_area(s.dimension) * count / s.volume() * std::pow(diameter, d - 1) * contact * speed;
  return diameter > 0 && rate > 0 && std::isfinite(rate) ? 1 / rate : unknown;
}

}  // namespace carom
