// All pairs nearer than a range, against every pair with every image.

#include "observe/pair_distances.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace carom {
namespace {

template <int D>
std::vector<double> by_cells(const Triple& edge, double range, const std::vector<Triple>& points) {
  std::vector<double> squares;
  PairDistances<D>(edge, range).each(points, [&](double s) { squares.push_back(s); });
  std::sort(squares.begin(), squares.end());
  return squares;
}

template <int D>
std::vector<double> by_images(const Triple& edge, double range, const std::vector<Triple>& points) {
  std::vector<double> squares;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      double nearest = 0;
      for (int k = 0; k < D; ++k) {
        double best = HUGE_VAL;
        for (int image = -6; image <= 6; ++image)
          best = std::min(best, std::abs(points[j][k] - points[i][k] + image * edge[k]));
        nearest += best * best;
      }
      if (nearest < range * range) squares.push_back(nearest);
    }
  std::sort(squares.begin(), squares.end());
  return squares;
}

template <int D>
void compare(const Triple& edge, double range, int count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> anywhere(-2.5, 3.5);  // unwrapped: up to some periods outside
  std::vector<Triple> points;
  for (int i = 0; i < count; ++i) {
    Triple x{};
    for (int k = 0; k < D; ++k) x[k] = anywhere(random) * edge[k];
    points.push_back(x);
  }
  const auto cells = by_cells<D>(edge, range, points), images = by_images<D>(edge, range, points);
  ASSERT_EQ(cells.size(), images.size()) << D << " " << range;
  EXPECT_FALSE(cells.empty());
  for (std::size_t i = 0; i < cells.size(); ++i) EXPECT_NEAR(cells[i], images[i], 1e-12 * (1 + images[i]));
}

TEST(PairDistances, are_those_of_the_nearest_images) {
  for (const double range : {0.4, 0.9, 1.7, 2.5}) {  // many cells down to none
    compare<1>({5, 1, 1}, range, 200);
    compare<2>({5, 7, 1}, range, 300);
    compare<3>({5, 7, 6}, range, 400);
  }
}

TEST(PairDistances, of_no_points_are_none) {
  EXPECT_TRUE(by_cells<3>({1, 1, 1}, 0.1, {}).empty());
  EXPECT_TRUE(by_cells<2>({1, 1, 1}, 0.5, {{0.5, 0.5, 0}}).empty());
}

}  // namespace
}  // namespace carom
