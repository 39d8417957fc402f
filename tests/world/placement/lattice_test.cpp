#include "carom/world/placement/lattice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "brute_force.hpp"
#include "carom/core/error.hpp"
#include "carom/world/placement/maxwell.hpp"

namespace carom {
namespace {

using test::cube, test::smallest_gap, test::balls_of;
using ::testing::HasSubstr;

LatticeSpec lattice(LatticeKind kind, std::int64_t count, double packing) {
  LatticeSpec spec;
  spec.kind = kind;
  spec.count = count;
  spec.packing_fraction = packing;
  spec.where.line = 12;
  return spec;
}

std::string refusal(const LatticeSpec& spec, const Region& region) {
  try {
    (void)place_lattice(spec, region);
  } catch (const InputError& e) {
    EXPECT_EQ(e.problems().front().line, 12);
    return e.what();
  }
  return "";
}

double gap_of(const LatticeSpec& spec, const Region& region) {
  return smallest_gap(balls_of({place_lattice(spec, region)}), region);
}

struct Case {
  LatticeKind kind;
  std::int64_t count;
  Region region;
  double packing;  ///< [-] of the densest, touching
};

// Close packings in a space of the lattice's own shape: touching, and filling what the lattice fills.
std::vector<Case> perfect_cases() {
  const double pi = std::numbers::pi, root3 = std::sqrt(3.0);
  const auto periodic = SpaceKind::periodic, box = SpaceKind::box;
  return {{LatticeKind::chain, 7, cube(periodic, 1, 7, -3), 1.0},
          {LatticeKind::chain, 7, cube(box, 1, 7), 1.0},
          {LatticeKind::square, 50, {periodic, 2, {0, 0}, {10, 5}}, pi / 4},
          {LatticeKind::square, 50, {box, 2, {1, 1}, {11, 6}}, pi / 4},
          {LatticeKind::hexagonal, 72, {periodic, 2, {0, 0}, {9, 4 * root3}}, pi / 2 / root3},
          {LatticeKind::hexagonal, 72, {periodic, 2, {0, 0}, {4 * root3, 9}}, pi / 2 / root3},
          {LatticeKind::hexagonal, 12, {box, 2, {0, 0}, {4.5, 1 + root3}}, 12 * pi / 4 / (4.5 * (1 + root3))},
          {LatticeKind::cubic, 24, {periodic, 3, {0, 0, 0}, {2, 3, 4}}, pi / 6},
          {LatticeKind::cubic, 24, {box, 3, {0, 0, 0}, {4, 3, 2}}, pi / 6},
          {LatticeKind::fcc, 4, cube(periodic, 3, std::sqrt(2.0)), pi / 3 / std::sqrt(2.0)},
          {LatticeKind::fcc, 108, cube(periodic, 3, 3), pi / 3 / std::sqrt(2.0)},
          {LatticeKind::fcc, 32, cube(box, 3, 1 + 3 * std::sqrt(0.5)), 32 * pi / 6 / std::pow(1 + 3 * std::sqrt(0.5), 3)}};
}

TEST(Lattice, touches_at_its_close_packing_and_not_below) {
  for (const Case& c : perfect_cases()) {
    SCOPED_TRACE(std::string("count ") + std::to_string(c.count) + " kind " + std::to_string(static_cast<int>(c.kind)));
    EXPECT_NEAR(gap_of(lattice(c.kind, c.count, c.packing), c.region), 0.0, 4e-15);
    // Radius 1 % smaller: the gap is 1 % of it.
    const double sparser = c.packing * std::pow(0.99, c.region.dimension);
    EXPECT_NEAR(gap_of(lattice(c.kind, c.count, sparser), c.region), 1 / 0.99 - 1, 1e-13);
    EXPECT_THAT(refusal(lattice(c.kind, c.count, c.packing * 1.001), c.region), HasSubstr("overlap"));
  }
}

TEST(Lattice, keeps_the_count_and_the_packing) {
  for (const Case& c : perfect_cases()) {
    const auto placed = place_lattice(lattice(c.kind, c.count, 0.5 * c.packing), c.region);
    EXPECT_EQ(placed.position.size(), static_cast<std::size_t>(c.count * c.region.dimension));
    EXPECT_NEAR(placed.packing, 0.5 * c.packing, 1e-14);
    for (std::size_t i = 0; i < placed.position.size(); ++i) {
      const auto k = i % static_cast<std::size_t>(c.region.dimension);
      EXPECT_GE(placed.position[i], c.region.lower[k]);
      EXPECT_LT(placed.position[i], c.region.upper[k]);
    }
  }
}

// 29 x 30 disks in a square cell, as in Li et al., J. Chem. Phys. 157, 234111 (N = 870, box 1:1), up to packing 0.716.
TEST(Lattice, stretches_to_fill_the_space) {
  const Region square = cube(SpaceKind::periodic, 2, 1);
  EXPECT_GT(gap_of(lattice(LatticeKind::hexagonal, 870, 0.716), square), 0.0);
  EXPECT_GT(gap_of(lattice(LatticeKind::hexagonal, 72, 0.60), square), 0.0);
  EXPECT_GT(gap_of(lattice(LatticeKind::fcc, 4 * 2 * 3 * 3, 0.49), cube(SpaceKind::periodic, 3, 5)), 0.0);
}

TEST(Lattice, says_which_counts_fit) {
  const Region nine_rows{SpaceKind::periodic, 2, {0, 0}, {9, 4 * std::sqrt(3.0)}};
  EXPECT_THAT(refusal(lattice(LatticeKind::hexagonal, 71, 0.70), nine_rows), HasSubstr("72"));
  EXPECT_THAT(refusal(lattice(LatticeKind::fcc, 500 + 1, 0.49), cube(SpaceKind::periodic, 3, 8)), HasSubstr("500"));
  EXPECT_THAT(refusal(lattice(LatticeKind::square, 101, 0.3), cube(SpaceKind::box, 2, 8)), HasSubstr("100"));
  // With the radius given, only counts that have room: 10 x 5 disks of radius 1/2 fill the box, 55 do not fit.
  LatticeSpec full = lattice(LatticeKind::square, 55, 0.5);
  full.packing_fraction.reset();
  full.radius = 0.5;
  EXPECT_THAT(refusal(full, {SpaceKind::box, 2, {0, 0}, {10, 5}}), HasSubstr("that fit: 45, 50"));
}

TEST(Lattice, refuses_what_does_not_suit_the_space) {
  EXPECT_THAT(refusal(lattice(LatticeKind::fcc, 4, 0.5), cube(SpaceKind::box, 2, 1)), HasSubstr("it needs 3"));
  EXPECT_THAT(refusal(lattice(LatticeKind::square, 4, 0.5), {SpaceKind::open, 2, {}, {}}), HasSubstr("fills [space]"));
  LatticeSpec both = lattice(LatticeKind::square, 4, 0.5);
  both.radius = 0.1;
  EXPECT_THAT(refusal(both, cube(SpaceKind::box, 2, 1)), HasSubstr("do not agree"));
  both.radius = std::sqrt(0.5 / 4 / std::numbers::pi);
  EXPECT_EQ(refusal(both, cube(SpaceKind::box, 2, 1)), "");
  EXPECT_THAT(refusal(lattice(LatticeKind::square, 0, 0.5), cube(SpaceKind::box, 2, 1)), HasSubstr("at least one"));
}

TEST(Lattice, moves_only_with_a_temperature) {
  LatticeSpec spec = lattice(LatticeKind::cubic, 27, 0.3);
  const Region region = cube(SpaceKind::periodic, 3, 3);
  EXPECT_EQ(place_lattice(spec, region).velocity, PageVector<double>(81, 0.0));
  spec.temperature = 2.0;
  double square = 0.0;
  for (const double v : place_lattice(spec, region).velocity) square += v * v;
  EXPECT_NEAR(square / 78, 2.0, 1e-14);
}

}  // namespace
}  // namespace carom
