#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "brute_force.hpp"
#include "carom/core/error.hpp"
#include "carom/world/placement/lattice.hpp"

namespace carom {
namespace {

const Region open_plane{SpaceKind::open, 2, {}, {}};

LatticeSpec rack(int rows) {
  LatticeSpec spec;
  spec.kind = LatticeKind::rack;
  spec.rows = rows;
  spec.apex = {1.9, 0.56};
  spec.where.line = 7;
  return spec;
}

// Each coordinate is within half an ulp of the exact rack, so each neighbour distance lies within the enclosure that these
// half-ulps make: sum over the axes of |dx| / s times the half-ulps of both coordinates.
TEST(Rack, touches_to_rounding) {
  using Wide = boost::multiprecision::cpp_bin_float_50;
  for (const Coordinates& direction : {Coordinates{}, Coordinates{1, 0}, Coordinates{0.3, -0.7}, Coordinates{-2, 1e-3}}) {
    LatticeSpec spec = rack(5);
    spec.radius = 0.028575;
    spec.direction = direction;
    const auto placed = place_lattice(spec, open_plane);
    const auto& x = placed.position;
    ASSERT_EQ(x.size(), 30u);
    const double s = 2 * 0.028575;
    int touching = 0;
    for (std::size_t i = 0; i < 15; ++i) {
      for (std::size_t j = i + 1; j < 15; ++j) {
        const Wide dx = Wide(x[2 * j]) - x[2 * i], dy = Wide(x[2 * j + 1]) - x[2 * i + 1];
        const double gap = (sqrt(dx * dx + dy * dy) - s).convert_to<double>();
        const auto half_ulp = [&](std::size_t k) {
          return 0.5 * (std::nextafter(std::abs(x[k]), INFINITY) - std::abs(x[k]));
        };
        const double width = (std::abs(dx.convert_to<double>()) * (half_ulp(2 * i) + half_ulp(2 * j)) +
                              std::abs(dy.convert_to<double>()) * (half_ulp(2 * i + 1) + half_ulp(2 * j + 1))) /
                             s;
        if (gap < 0.5 * s) {
          ++touching;
          EXPECT_LE(std::abs(gap), width * 1.0001);
        }
      }
    }
    EXPECT_EQ(touching, 30);  // a triangle of 5 rows has 3 (1 + 2 + 3 + 4) neighbour pairs
  }
}

TEST(Rack, stands_behind_its_apex) {
  LatticeSpec spec = rack(3);
  spec.apex = {2, 1};
  spec.direction = {0, 3};
  spec.gap = 0.5;
  const auto placed = place_lattice(spec, open_plane);
  EXPECT_EQ(placed.radius, 0.5);
  EXPECT_EQ(placed.velocity, PageVector<double>(12, 0.0));
  const double row = 1.5 * std::sqrt(0.75);
  const PageVector<double> expected{2,   1,           2.75, 1 + row,     1.25, 1 + row,
                                     3.5, 1 + 2 * row, 2,    1 + 2 * row, 0.5,  1 + 2 * row};
  for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(placed.position[i], expected[i], 1e-15);
}

TEST(Rack, refuses_what_is_no_rack) {
  const auto fails = [](LatticeSpec spec, const Region& region) {
    try {
      (void)place_lattice(spec, region);
      return std::size_t{0};
    } catch (const InputError& e) {
      for (const Problem& p : e.problems()) EXPECT_EQ(p.line, 7);
      return e.problems().size();
    }
  };
  EXPECT_EQ(fails(rack(5), open_plane), 0u);
  EXPECT_EQ(fails(rack(0), open_plane), 1u);
  EXPECT_EQ(fails(rack(5), test::cube(SpaceKind::box, 3, 10)), 1u);
  LatticeSpec wrong = rack(5);
  wrong.count = 14;
  wrong.apex.clear();
  wrong.direction = {0, 0};
  wrong.gap = -1;
  wrong.packing_fraction = 0.5;
  EXPECT_EQ(fails(wrong, open_plane), 5u);
}

}  // namespace
}  // namespace carom
