// The images that a path through a lattice is said to come near hold all that it meets, in the order in which it does.

#include "carom/predict/lattice_ray.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "carom/solve/quadratic.hpp"

namespace carom {
namespace {

class Dice {
 public:
  double between(double low, double high) { return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 bits_{5};
};

template <int D>
struct Found {
  double flight = never<double>();
  std::array<int, D> image{};
};

template <int D>
double flight_to(const Vec<double, D>& r, const Vec<double, D>& g, const Vec<double, D>& edge, const std::array<int, D>& n,
                 double sigma) {
  Vec<double, D> at = r;
  for (int k = 0; k < D; ++k) at[k] += n[k] * edge[k];
  return meet_time<double, D>(at, g, sigma);
}

/// The first of all images up to `range` periods away.
template <int D>
Found<D> by_looking_at_all(const Vec<double, D>& r, const Vec<double, D>& g, const Vec<double, D>& edge, double sigma, int range) {
  Found<D> found;
  std::array<int, D> n;
  n.fill(-range);
  while (true) {
    const double t = flight_to<D>(r, g, edge, n, sigma);
    if (t < found.flight) found = {t, n};
    int k = 0;
    while (k < D && ++n[k] > range) n[k++] = -range;
    if (k == D) return found;
  }
}

template <int D>
Found<D> by_columns(const Vec<double, D>& r, const Vec<double, D>& g, const Vec<double, D>& edge, double sigma, int columns) {
  Vec<double, D> per_edge;
  for (int k = 0; k < D; ++k) per_edge[k] = 1 / edge[k];
  const LatticeRay<D> ray(r.data(), g.data(), sigma, edge.data(), per_edge.data());
  Found<D> found;
  for (double column = ray.first(); columns-- > 0; column += 1) {
    for (int corner = 0; corner < 1 << (D - 1); ++corner) {
      std::array<int, D> n;
      for (int k = 0, bit = 0; k < D; ++k)
        n[k] = static_cast<int>(k == ray.axis ? ray.sense * column : ray.row(k, column) + (corner >> bit++ & 1));
      const double t = flight_to<D>(r, g, edge, n, sigma);
      if (t < found.flight) found = {t, n};
      if (t < never<double>()) {
        EXPECT_GE(t, ray.entry(column));
        EXPECT_LE(t, ray.entry(column + 1));
      }
    }
    if (found.flight < never<double>()) return found;
  }
  return found;
}

template <int D>
void compare(int count, double share, int range) {
  Dice dice;
  int met = 0;
  for (int m = 0; m < count; ++m) {
    Vec<double, D> r, g, edge;
    double least = never<double>();
    for (int k = 0; k < D; ++k) {
      edge[k] = dice.between(0.5, 2);
      least = edge[k] < least ? edge[k] : least;
      r[k] = dice.between(-1, 1) * edge[k];
      g[k] = dice.between(-1, 1) * (dice.between(0, 1) < 0.1 ? 1e-9 : 1);
      if (dice.between(0, 1) < 0.03) g[k] = 0;
    }
    if (g == Vec<double, D>::Zero()) continue;
    const double sigma = share * least;
    const Found<D> all = by_looking_at_all<D>(r, g, edge, sigma, range);
    const Found<D> some = by_columns<D>(r, g, edge, sigma, 3 * range);
    // What lies beyond the range looked at is met later than anything within.
    bool inside = true;
    for (int k = 0; k < D; ++k) inside = inside && std::abs(some.image[static_cast<std::size_t>(k)]) < range;
    if (!inside) continue;
    if (all.flight == never<double>() && some.flight == never<double>()) continue;
    ++met;
    ASSERT_EQ(all.flight, some.flight) << m;
    ASSERT_EQ(all.image, some.image) << m;
  }
  EXPECT_GT(met, count / 2);
}

TEST(LatticeRay, finds_the_first_image_in_the_plane) {
  compare<2>(3000, 0.499, 12);
  compare<2>(3000, 0.2, 12);
}
TEST(LatticeRay, finds_the_first_image_in_space) {
  compare<3>(400, 0.499, 7);
  compare<3>(400, 0.3, 7);
}

}  // namespace
}  // namespace carom
