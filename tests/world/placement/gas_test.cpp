#include "carom/world/placement/gas.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <numbers>

#include "brute_force.hpp"
#include "carom/core/error.hpp"
#include "carom/core/random.hpp"
#include "carom/world/placement/radius.hpp"

namespace carom {
namespace {

using test::balls_of, test::cube, test::hash_of, test::smallest_gap;
using ::testing::HasSubstr;

GasSpec gas(std::int64_t count, double packing, std::uint64_t seed = 1) {
  GasSpec spec;
  spec.count = count;
  spec.packing_fraction = packing;
  spec.seed = seed;
  spec.where.line = 31;
  return spec;
}

GasSpec gas_of_radius(std::int64_t count, double radius, std::uint64_t seed = 1) {
  GasSpec spec = gas(count, 0.5, seed);
  spec.packing_fraction.reset();
  spec.radius = radius;
  return spec;
}

std::vector<PlacedBalls> place(const std::vector<GasSpec>& specs, const Region& region,
                               const std::vector<Obstacle>& obstacles = {}, const ClearOfWalls& clear = {}) {
  return place_gases(specs, region, obstacles, clear);
}

double gap_of(const std::vector<GasSpec>& specs, const Region& region) {
  const auto placed = place(specs, region);
  return smallest_gap(balls_of(placed), region);
}

std::string refusal(const std::vector<GasSpec>& specs, const Region& region, const std::vector<Obstacle>& obstacles = {},
                    const ClearOfWalls& clear = {}) {
  try {
    (void)place(specs, region, obstacles, clear);
  } catch (const InputError& e) {
    EXPECT_EQ(e.problems().front().line, 31);
    return e.what();
  }
  return "";
}

TEST(Gas, leaves_a_gap_everywhere_up_to_freezing) {
  for (const SpaceKind kind : {SpaceKind::periodic, SpaceKind::box}) {
    for (const double lower : {0.0, -1e6}) {
      for (const double packing : {0.01, 0.25, 0.49})
        EXPECT_GT(gap_of({gas(600, packing)}, cube(kind, 3, 7, lower)), 1e-12);
      for (const double packing : {0.01, 0.40, 0.69})
        EXPECT_GT(gap_of({gas(600, packing)}, cube(kind, 2, 7, lower)), 1e-12);
      for (const double packing : {0.01, 0.70, 0.999})
        EXPECT_GT(gap_of({gas(600, packing)}, cube(kind, 1, 7, lower)), 1e-12);
    }
  }
}

// Cells and boxes of a diameter or two, where a ball meets several images of another, at many seeds.
TEST(Gas, works_in_tiny_cells) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const std::int64_t n : {1, 2, 3, 4, 5, 6, 8, 9, 13, 20, 32}) {
      EXPECT_GT(gap_of({gas(n, 0.40, seed)}, cube(SpaceKind::periodic, 3, 1)), 0.0) << n;
      EXPECT_GT(gap_of({gas(n, 0.60, seed)}, cube(SpaceKind::periodic, 2, 1)), 0.0) << n;
      EXPECT_GT(gap_of({gas(n, 0.95, seed)}, cube(SpaceKind::periodic, 1, 1)), 0.0) << n;
      EXPECT_GT(gap_of({gas(n, 0.95, seed)}, cube(SpaceKind::box, 1, 1)), 0.0) << n;
      EXPECT_GT(gap_of({gas(n, 0.20, seed)}, cube(SpaceKind::box, 3, 1)), 0.0) << n;
    }
    EXPECT_GT(gap_of({gas(200, 0.49, seed)}, {SpaceKind::periodic, 3, {0, 0, 0}, {1, 4, 20}}), 0.0);
    EXPECT_GT(gap_of({gas(60, 0.50, seed)}, {SpaceKind::box, 2, {0, 0}, {1, 20}}), 0.0);
  }
}

TEST(Gas, mixes_sizes) {
  const Region cell = cube(SpaceKind::periodic, 3, 6), box = cube(SpaceKind::box, 2, 10);
  EXPECT_GT(gap_of({gas_of_radius(1500, 0.05), gas_of_radius(18, 1.0)}, cell), 0.0);  // ratio 20, packing 0.35
  EXPECT_GT(gap_of({gas(300, 0.25), gas(60, 0.24)}, cell), 0.0);                      // packing 0.49
  EXPECT_GT(gap_of({gas(400, 0.23), gas(40, 0.23), gas(4, 0.23)}, cube(SpaceKind::periodic, 2, 10)), 0.0);  // packing 0.69
  EXPECT_GT(gap_of({gas(400, 0.20), gas(4, 0.40)}, box), 0.0);
  EXPECT_GT(gap_of({gas(50, 0.5), gas(5, 0.4)}, cube(SpaceKind::box, 1, 3)), 0.0);
  // Each entry keeps its own radius and share, in the order in which they were written.
  const auto placed = place({gas(300, 0.25), gas(60, 0.24)}, cell);
  EXPECT_EQ(placed[0].position.size(), 900u);
  EXPECT_EQ(placed[1].radius, radius_for_packing(0.24, 60, 216.0, 3));
  EXPECT_NEAR(placed[1].packing, 0.24, 1e-14);
}

TEST(Gas, keeps_clear_of_balls_that_are_there) {
  const Region cell = cube(SpaceKind::periodic, 3, 6, -3);
  const std::vector<Obstacle> there{{{-2.9, 0, 0}, 1.0}, {{1, 1, 2.5}, 0.1}, {{0, 0, 0}, 0.4}};
  auto placed = balls_of(place({gas(300, 0.45)}, cell, there));
  for (const Obstacle& o : there) placed.push_back({o.position, o.radius});
  EXPECT_GT(smallest_gap(placed, cell), 0.0);

  for (const SpaceKind kind : {SpaceKind::periodic, SpaceKind::box}) {
    const Region line = cube(kind, 1, 10);
    auto rods = balls_of(place({gas(40, 0.6), gas(3, 0.1)}, line, {{{1.0}, 0.5}, {{9.7}, 0.2}, {{4.0}, 0.1}}));
    for (const Obstacle& o : {Obstacle{{1.0}, 0.5}, {{9.7}, 0.2}, {{4.0}, 0.1}}) rods.push_back({o.position, o.radius});
    EXPECT_GT(smallest_gap(rods, line), 0.0);
  }
}

// A disk of radius 5 inside a box of edge 30: the gas has 0.5 of the disk, though only 0.04 of the box.
TEST(Gas, keeps_clear_of_walls) {
  const Region box = cube(SpaceKind::box, 2, 30);
  const auto inside = [](const double* x, double r) {
    const double dx = x[0] - 20, dy = x[1] - 12;
    return std::sqrt(dx * dx + dy * dy) + r < 5;
  };
  const auto placed = balls_of(place({gas_of_radius(200, 0.25)}, box, {}, inside));
  EXPECT_GT(smallest_gap(placed, box), 0.0);
  for (const auto& b : placed) EXPECT_TRUE(inside(b.x.data(), b.radius));
  // A wall across a periodic line, where balls must be pushed to either side.
  const Region line = cube(SpaceKind::periodic, 1, 10);
  const auto off_the_middle = [](const double* x, double r) { return std::abs(x[0] - 5) > r; };
  const auto rods = balls_of(place({gas_of_radius(10, 0.3)}, line, {}, off_the_middle));
  EXPECT_GT(smallest_gap(rods, line), 0.0);
  for (const auto& b : rods) EXPECT_TRUE(off_the_middle(b.x.data(), b.radius));
}

TEST(Gas, makes_its_own_cell_in_an_open_space) {
  GasSpec both = gas(1000, 0.3);
  both.radius = 0.5;
  const auto placed = place({both}, {SpaceKind::open, 3, {}, {}});
  const Region& cell = placed[0].region;
  EXPECT_EQ(cell.kind, SpaceKind::periodic);
  EXPECT_EQ(cell.lower[2], 0.0);
  EXPECT_NEAR(std::pow(cell.upper[0], 3) * 0.3, 1000 * std::numbers::pi / 6, 1e-9);
  EXPECT_EQ(placed[0].radius, 0.5);
  EXPECT_GT(smallest_gap(balls_of(placed), cell), 0.0);
  // Given back with that cell, radius and packing agree.
  EXPECT_EQ(refusal({both}, cell), "");
  both.packing_fraction = 0.3 * (1 + 1e-11);
  EXPECT_THAT(refusal({both}, cell), HasSubstr("do not agree"));
}

TEST(Gas, has_the_exact_temperature_and_no_momentum_in_each_entry) {
  GasSpec hot = gas(50, 0.1), cold = gas(30, 0.1);
  hot.temperature = 3.0;
  cold.temperature = 0.25;
  cold.mass = 7.0;
  for (const SpaceKind kind : {SpaceKind::periodic, SpaceKind::box}) {
    const auto placed = place({hot, cold}, cube(kind, 3, 4));
    const int less = kind == SpaceKind::periodic ? 1 : 0;
    for (const auto& [p, mass, freedoms, t] :
         {std::tuple{placed[0], 1.0, 3 * (50 - less), 3.0}, {placed[1], 7.0, 3 * (30 - less), 0.25}}) {
      double square = 0.0;
      std::array<double, 3> sum{};
      for (std::size_t i = 0; i < p.velocity.size(); ++i)
        square += p.velocity[i] * p.velocity[i], sum[i % 3] += p.velocity[i];
      EXPECT_NEAR(mass * square / freedoms, t, 1e-14 * t);
      EXPECT_EQ(sum, (std::array<double, 3>{}));
    }
  }
}

// The bits of placements and velocities, the same for every compiler, level of optimisation and machine.
TEST(Gas, keeps_its_bits) {
  const auto bits = [](const std::vector<PlacedBalls>& all) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const auto& p : all) hash = hash_of(p.velocity, hash_of(p.position, hash));
    return hash;
  };
  EXPECT_EQ(bits(place({gas(1000, 0.49)}, cube(SpaceKind::periodic, 3, 10))), 4033230086484112230u);
  EXPECT_EQ(bits(place({gas(1000, 0.69)}, cube(SpaceKind::box, 2, 10))), 3183230895018935380u);
  EXPECT_EQ(bits(place({gas(100, 0.90)}, cube(SpaceKind::periodic, 1, 10))), 3624225891395129986u);
  EXPECT_EQ(bits(place({gas(300, 0.25), gas(60, 0.24, 5)}, cube(SpaceKind::periodic, 3, 6), {{{1, 1, 1}, 0.5}})),
            14739248189361922599u);
}

TEST(Gas, depends_on_the_seed_alone) {
  const Region cell = cube(SpaceKind::periodic, 3, 10);
  const auto a = place({gas(100, 0.4, 1)}, cell), again = place({gas(100, 0.4, 1)}, cell),
             other = place({gas(100, 0.4, 2)}, cell);
  EXPECT_EQ(a[0].position, again[0].position);
  EXPECT_NE(a[0].position, other[0].position);
  EXPECT_NE(a[0].velocity, other[0].velocity);
}

/// |sum exp(i k x)|^2 / N for k = 2 pi (n_1, n_2, n_3) / edge.
double structure(const std::vector<test::TestBall>& balls, double edge, std::array<int, 3> n) {
  std::complex<double> sum = 0;
  for (const auto& b : balls) {
    double phase = 0;
    for (int k = 0; k < 3; ++k) phase += 2 * std::numbers::pi * n[k] * b.x[k] / edge;
    sum += std::polar(1.0, phase);
  }
  return std::norm(sum) / static_cast<double>(balls.size());
}

// A lattice has S(k) = N = 1000 at some k; in a fluid S is distributed exponentially about a mean below 3, so that of 1500
// waves the largest is about 3 ln 1500 = 22. And contacts point everywhere: <n n> = 1/D within four standard deviations of
// 3000 bonds.
TEST(Gas, is_no_lattice) {
  for (const int d : {2, 3}) {
    const double edge = 10, packing = d == 3 ? 0.49 : 0.69;
    const auto placed = place({gas(1000, packing)}, cube(SpaceKind::periodic, d, edge));
    const auto balls = balls_of(placed);
    double largest = 0;
    const int reach = d == 3 ? 13 : 40, deep = d == 3 ? 4 : 0;
    for (int a = -reach; a <= reach; ++a) {
      for (int b = 0; b <= reach; b += d == 3 ? 3 : 1) {
        for (int c = 0; c <= deep; c += 2) {
          if (a != 0 || b != 0 || c != 0) largest = std::max(largest, structure(balls, edge, {a, b, c}));
        }
      }
    }
    EXPECT_LT(largest, 60) << d;

    std::array<double, 3> along{};
    int bonds = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        std::array<double, 3> n{};
        double square = 0;
        for (int k = 0; k < d; ++k) {
          n[k] = balls[i].x[k] - balls[j].x[k];
          n[k] -= edge * std::round(n[k] / edge);
          square += n[k] * n[k];
        }
        if (square > std::pow(2.2 * balls[i].radius, 2)) continue;
        ++bonds;
        for (int k = 0; k < d; ++k) along[k] += n[k] * n[k] / square;
      }
    }
    EXPECT_GT(bonds, 1500);
    for (int k = 0; k < d; ++k) EXPECT_NEAR(along[k] / bonds, 1.0 / d, 4 * 0.36 / std::sqrt(bonds)) << d << k;
  }
}

// Tonks: the n gaps on a ring share the free length F as n uniform cuts do, <g^2> = 2 F^2 / (n (n + 1)); an entry's balls
// stand in order.
TEST(Gas, is_in_equilibrium_on_a_line) {
  const Region ring = cube(SpaceKind::periodic, 1, 1);
  const auto placed = place({gas(5000, 0.8)}, ring);
  auto x = placed[0].position;
  EXPECT_TRUE(std::is_sorted(x.begin(), x.end()));
  x.push_back(x.front() + 1);
  double squares = 0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) squares += std::pow(x[i + 1] - x[i] - 2 * placed[0].radius, 2);
  EXPECT_NEAR(squares / 5000 / (2 * 0.04 / 5000.0 / 5001.0), 1.0, 4 * std::sqrt(5.0 / 5000));
}

TEST(Gas, says_what_was_asked_and_what_was_reached) {
  const Region cell = cube(SpaceKind::periodic, 3, 10), plane = cube(SpaceKind::box, 2, 10);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(refusal({gas(500, 0.75)}, cell), HasSubstr("no packing of these balls exceeds 0.74"));
  EXPECT_THAT(refusal({gas_of_radius(1500, 0.5)}, cell), HasSubstr("fewer than 1414 balls fit"));
  EXPECT_THAT(refusal({gas(60, 0.73)}, cell), HasSubstr("(a packing fraction of 0."));
  EXPECT_THAT(refusal({gas_of_radius(100, 0.5)}, plane, {}, [](const double* x, double) { return x[0] < 2; }),
              HasSubstr("balls of this radius fit"));
  EXPECT_THAT(refusal({gas(10, 0.1)}, plane, {}, [](const double*, double) { return false; }),
              HasSubstr("only 0 found a place"));
  EXPECT_THAT(refusal({gas(10, 0.1)}, plane, {{{5, 5}, 8}}), HasSubstr("could not be placed"));
  EXPECT_THAT(refusal({gas(10, 0.5)}, cube(SpaceKind::box, 1, 1), {{{0.5}, 0.3}}), HasSubstr("found a place"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60)) << "a refusal must not take for ever";
}

TEST(Gas, refuses_what_makes_no_sense) {
  const Region cell = cube(SpaceKind::periodic, 3, 10);
  GasSpec bare = gas(10, 0.1);
  bare.packing_fraction.reset();
  EXPECT_THAT(refusal({bare}, cell), HasSubstr("neither radius nor packing_fraction"));
  EXPECT_THAT(refusal({gas(10, 0.1)}, {SpaceKind::open, 3, {}, {}}), HasSubstr("open space"));
  EXPECT_THAT(refusal({gas_of_radius(1, 6)}, cell), HasSubstr("its own image"));
  EXPECT_THAT(refusal({gas_of_radius(1, 5)}, cube(SpaceKind::box, 2, 10)), HasSubstr("between the faces"));
  try {
    (void)place({gas(0, 0.1), gas(5, 1.5), gas(5, -1)}, cell);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(e.problems().size(), 3u);
  }
  EXPECT_TRUE(place({}, cell).empty());
}

TEST(Gas, places_points) {
  const auto placed = place({gas_of_radius(500, 0.0)}, cube(SpaceKind::box, 2, 1));
  const auto& x = placed[0].position;
  EXPECT_TRUE(std::all_of(x.begin(), x.end(), [](double y) { return y > 0.0 && y < 1.0; }));
}

}  // namespace
}  // namespace carom
