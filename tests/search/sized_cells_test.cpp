// The neighbours that cells of many sizes find are those whose centres are closer than the sum of the two reaches: all of them,
// the same from both sides, whatever the sizes, and however the cells lie.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include "carom/search/sized_cells.hpp"

namespace carom {
namespace {

template <int D>
struct Crowd {
  Space<double, D> space;
  std::vector<Shell> shells;                // by kind
  std::vector<std::uint32_t> kind;          // by ball
  std::vector<std::array<double, D>> at;    // by ball
  SizedCells<D> cells;

  /// n balls whose reaches are spread evenly over powers from 1 / ratio to 1 in a space of edges 4.5, 7 and 9.
  Crowd(SpaceKind kind_of_space, int n, double ratio, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto share = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    space.kind = kind_of_space;
    for (int k = 0; k < D; ++k) {
      space.lower[k] = -1.25 + k;
      space.edge[k] = k == 0 ? 4.5 : k == 1 ? 7 : 9;
    }
    std::vector<std::uint32_t> counts;
    for (int s = 0; s < 40; ++s) {
      const float reach = static_cast<float>(std::pow(ratio, -s / 39.0));
      shells.push_back({std::max(0.1 * static_cast<double>(reach), 0x1p-11), reach});
      counts.push_back(0);
    }
    for (int i = 0; i < n; ++i) {
      kind.push_back(static_cast<std::uint32_t>(i % 40));
      ++counts[kind.back()];
      at.push_back({});
    }
    EXPECT_TRUE(cells.lay_out(space, shells, counts));
    for (std::uint32_t i = 0; i < kind.size(); ++i) put(i, share);
  }
  template <class Share>
  void put(std::uint32_t i, Share&& share) {
    double x[D];
    for (int k = 0; k < D; ++k) {  // a period may be left
      at[i][static_cast<std::size_t>(k)] = share();
      const double beyond = space.periodic() ? std::floor(3 * share()) - 1 : 0;
      x[k] = space.lower[k] + space.edge[k] * (at[i][static_cast<std::size_t>(k)] + beyond);
    }
    cells.place(i, x, shells[kind[i]].reach);
  }
  /// Distance of two centres over the sum of their reaches.
  [[nodiscard]] double apart(std::uint32_t i, std::uint32_t j) const {
    double square = 0;
    for (int k = 0; k < D; ++k) {
      double d = at[i][static_cast<std::size_t>(k)] - at[j][static_cast<std::size_t>(k)];
      if (space.periodic()) d -= std::round(d);
      square += d * d * space.edge[k] * space.edge[k];
    }
    return std::sqrt(square) / (static_cast<double>(shells[kind[i]].reach) + static_cast<double>(shells[kind[j]].reach));
  }
  void look() {
    const std::uint32_t n = static_cast<std::uint32_t>(kind.size());
    std::vector<std::set<std::uint32_t>> near(n);
    std::vector<std::uint32_t> found(n + 16);
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t count = cells.gather(i, found.data());
      near[i] = std::set<std::uint32_t>(found.begin(), found.begin() + count);
      ASSERT_EQ(near[i].size(), count) << "one is found twice";
      ASSERT_FALSE(near[i].contains(i));
    }
    std::int64_t pairs = 0;
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < i; ++j) {
        ASSERT_EQ(near[i].contains(j), near[j].contains(i));
        pairs += near[i].contains(j);
        const double a = apart(i, j);  // floats decide: one in 2^20 is not resolved
        if (std::abs(a - 1) > 0x1p-20) {
          ASSERT_EQ(near[i].contains(j), a < 1) << i << " and " << j << ": " << a;
        }
      }
    ASSERT_GT(pairs, n / 2);
  }
};

template <int D>
void try_all(double ratio, int n) {
  for (const SpaceKind kind : {SpaceKind::periodic, SpaceKind::box}) {
    Crowd<D> crowd(kind, n, ratio, 7 + static_cast<std::uint64_t>(n));
    crowd.look();
    std::mt19937_64 random(3);
    const auto share = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (std::uint32_t i = 0; i < crowd.kind.size(); i += 3) {  // to other places
      crowd.cells.displace(i);
      crowd.put(i, share);
    }
    crowd.look();
  }
}

TEST(SizedCells, find_all_neighbours_of_like_size) {
  try_all<2>(1.01, 300);
  try_all<3>(1.01, 300);
}
TEST(SizedCells, find_all_neighbours_one_to_twenty) {
  try_all<2>(20, 800);
  try_all<3>(20, 800);
}
TEST(SizedCells, find_all_neighbours_one_to_a_thousand) {  // more classes than there are grids for: the last takes the rest
  try_all<2>(1000, 800);
  try_all<3>(1000, 800);
}

// Centres of shells up to 2 apart, balls up to 0.1 from them: neighbours are at 2.2 at most, and 2 2.2 (1 + 1/64) = 4.469.
TEST(SizedCells, want_a_period_wider_than_two_neighbours) {
  Space<double, 2> space;
  space.kind = SpaceKind::periodic;
  space.edge = {4.46, 100};
  SizedCells<2> cells;
  EXPECT_FALSE(cells.lay_out(space, {{0.1, 1.0F}}, {10}));
  space.edge = {4.48, 100};
  EXPECT_TRUE(cells.lay_out(space, {{0.1, 1.0F}}, {10}));
}

}  // namespace
}  // namespace carom
