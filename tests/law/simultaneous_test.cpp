// Many contacts at one instant: what mechanics demands of the outcome, the cases with a known answer, and a hundred digits.

#include "carom/law/simultaneous.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numeric>

#include "carom/core/random.hpp"
#include "sim/properties.hpp"

namespace carom {
namespace {

using testing::expect_property;
using Exact = boost::multiprecision::cpp_bin_float_100;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <int D>
std::array<Wide<double>, D> towards(const Vec<double, D>& from, const Vec<double, D>& to) {
  std::array<Wide<double>, D> r;
  for (int i = 0; i < D; ++i) r[i] = wide_difference<double>(to[i], from[i]);
  return r;
}

template <int D>
Cluster<Exact, D> exactly(const Cluster<double, D>& in) {
  Cluster<Exact, D> out;
  for (const auto& b : in.bodies) {
    const Exact mass = b.mass == infinity ? std::numeric_limits<Exact>::infinity() : Exact(b.mass);
    out.bodies.push_back({mass, b.velocity.template cast<Exact>()});
  }
  for (const auto& c : in.contacts) {
    std::array<Exact, D> r;
    for (int i = 0; i < D; ++i) r[i] = Exact(c.r[i].hi) + Exact(c.r[i].lo);
    out.contacts.push_back({c.a, c.b, r, Exact(c.e)});
  }
  return out;
}

struct Books {
  double energy_before = 0, energy_error = 0, momentum_error = 0,
         size = 0;      // energies over sum m v^2 / 2, momenta over sum m|v|
  double approach = 0;  // largest over the contacts of (v_a - v_b).r / sum |r_k v_k|, v before and after, a and b
};

/// Judged with a hundred digits.
template <int D>
Books books(const Cluster<double, D>& in, const ClusterOutcome<double, D>& out) {
  Exact before = 0, after = 0, momentum[3] = {0, 0, 0}, size = 0;
  for (std::size_t i = 0; i < in.bodies.size(); ++i) {
    if (in.bodies[i].mass == infinity) continue;
    for (int k = 0; k < D; ++k) {
      const Exact m = in.bodies[i].mass, u = in.bodies[i].velocity[k], v = out.velocities[i][k];
      before += m * u * u / 2;
      after += m * v * v / 2;
      momentum[k] += m * (v - u);
      size += m * (abs(u) + abs(v));
    }
  }
  Books b;
  const Exact dissipated = Exact(out.dissipated.hi) + out.dissipated.lo,
              injected = Exact(out.injected.hi) + out.injected.lo;
  b.energy_before = double(before);
  const Exact scale = before + after + abs(injected);
  if (scale > 0) b.energy_error = double(Exact((after + dissipated - before - injected) / scale));
  for (const Exact& p : momentum)
    if (size > 0) b.momentum_error = std::max(b.momentum_error, double(Exact(abs(p) / size)));
  for (const auto& c : in.contacts) {
    Exact rate = 0, scale_of_rate = 0;
    for (int k = 0; k < D; ++k) {
      const Exact r = Exact(c.r[k].hi) + c.r[k].lo;
      rate += (Exact(out.velocities[c.a][k]) - out.velocities[c.b][k]) * r;
      for (const std::size_t body : {c.a, c.b})
        scale_of_rate += abs(r) * (std::abs(in.bodies[body].velocity[k]) + std::abs(out.velocities[body][k]));
    }
    if (scale_of_rate > 0) b.approach = std::max(b.approach, double(Exact(rate / scale_of_rate)));
  }
  return b;
}

template <int D>
void expect_no_pull(const ClusterOutcome<double, D>& out) {
  for (const double j : out.impulses) EXPECT_GE(j, 0.0);
}

// Hand cases.

Cluster<double, 1> cradle(int balls, int moving, double e) {
  Cluster<double, 1> c;
  for (int i = 0; i < balls; ++i) c.bodies.push_back({1.0, Vec<double, 1>(i < moving ? 1.0 : 0.0)});
  for (std::size_t i = 1; i < c.bodies.size(); ++i) c.contacts.push_back({i - 1, i, {Wide<double>(1.0)}, e});
  return c;
}

TEST(Simultaneous, cradle_gives_out_as_many_balls_as_come_in) {
  for (int balls = 2; balls <= 7; ++balls)
    for (int moving = 1; moving < balls; ++moving) {
      const auto out = resolve_cluster(cradle(balls, moving, 1.0));
      for (int i = 0; i < balls; ++i) EXPECT_EQ(out.velocities[std::size_t(i)][0], i >= balls - moving ? 1.0 : 0.0);
      EXPECT_EQ(narrow(out.dissipated), 0.0);
    }
}

// e = 0: all move on together with k/n of the speed, and k (n - k) / (2 n) of m v^2 is lost.
TEST(Simultaneous, plastic_cradle_moves_on_as_one) {
  for (int moving = 1; moving < 5; ++moving) {
    const auto out = resolve_cluster(cradle(5, moving, 0.0));
    for (const auto& v : out.velocities) EXPECT_EQ(v[0], moving / 5.0);
    EXPECT_NEAR(narrow(out.dissipated), moving * (5 - moving) / 10.0, 1e-16);
  }
}

TEST(Simultaneous, one_contact_is_the_impact_of_two_bodies) {
  RandomStream dice(1, 0);
  for (int n = 0; n < 500; ++n) {
    Cluster<double, 3> c;
    for (int i = 0; i < 2; ++i) {
      const Vec<double, 3> v(dice.normal(), dice.normal(), dice.normal());
      c.bodies.push_back({i == n % 5 ? infinity : dice.uniform() + 0.1, v});
    }
    const std::array<Wide<double>, 3> r{dice.normal(), dice.normal(), dice.normal()};
    c.contacts.push_back({0, 1, r, n % 3 == 0 ? 1.0 : dice.uniform()});
    const auto one = resolve_impact<double, 3>(
        {r, c.bodies[0].velocity, c.bodies[1].velocity, c.bodies[0].mass, c.bodies[1].mass, c.contacts[0].e});
    const auto out = resolve_cluster(c);
    EXPECT_EQ(out.velocities[0], one.va);
    EXPECT_EQ(out.velocities[1], one.vb);
    EXPECT_EQ(out.impulses[0], one.impulse);
    // The general path, reached through a third body that nothing happens to, rounds to the same.
    c.bodies.push_back({1.0, c.bodies[1].velocity + Vec<double, 3>(narrow(r[0]), narrow(r[1]), narrow(r[2])) * 100.0});
    c.contacts.push_back({1, 2, r, 1.0});
    const auto again = resolve_cluster(c);
    EXPECT_EQ(again.velocities[0], one.va);
    EXPECT_EQ(again.velocities[1], one.vb);
    EXPECT_EQ(again.velocities[2], c.bodies[2].velocity);
  }
}

Cluster<double, 2> corner(double e) {
  Cluster<double, 2> c;
  c.bodies = {
      {2.0, Vec<double, 2>(-3.0, -0.7)}, {infinity, Vec<double, 2>(0.0, 0.0)}, {infinity, Vec<double, 2>(0.0, 0.0)}};
  c.contacts = {{0, 1, {Wide<double>(-1.0), Wide<double>(0.0)}, e}, {0, 2, {Wide<double>(0.0), Wide<double>(-5.0)}, e}};
  return c;
}

// In a right corner both components turn round, each with its restitution, and the walls take m (1 + e) |v_k|.
TEST(Simultaneous, corner_turns_both_components_round) {
  const auto out = resolve_cluster(corner(1.0));
  EXPECT_EQ(out.velocities[0], (Vec<double, 2>(3.0, 0.7)));
  EXPECT_DOUBLE_EQ(out.impulses[0], 12.0);
  EXPECT_DOUBLE_EQ(out.impulses[1], 2.8);
  EXPECT_EQ(out.reflections, 1);
  EXPECT_EQ(resolve_cluster(corner(0.0)).velocities[0], (Vec<double, 2>(0.0, 0.0)));
  EXPECT_EQ(resolve_cluster(corner(0.5)).velocities[0], (Vec<double, 2>(1.5, 0.35)));
}

// A wedge of opening 2 alpha with its edge along -y, the ball coming straight down: both walls at once, so by symmetry the
// ball goes straight up again, and each wall gives m v / sin alpha.
TEST(Simultaneous, wedge_returns_a_ball_that_comes_down_its_axis) {
  for (const double alpha : {0.02, 0.3, 0.7, 1.2}) {
    Cluster<double, 2> c;
    c.bodies = {
        {1.5, Vec<double, 2>(0.0, -2.0)}, {infinity, Vec<double, 2>(0.0, 0.0)}, {infinity, Vec<double, 2>(0.0, 0.0)}};
    for (const std::size_t side : {1, 2}) {
      const double sign = side == 1 ? -1.0 : 1.0;  // from the ball into the wall
      c.contacts.push_back({0, side, {Wide<double>(sign * std::cos(alpha)), Wide<double>(-std::sin(alpha))}, 1.0});
    }
    const auto out = resolve_cluster(c);
    EXPECT_EQ(out.velocities[0], (Vec<double, 2>(0.0, 2.0)));
    for (const double j : out.impulses) EXPECT_NEAR(j, 1.5 * 2.0 / std::sin(alpha), 1e-12 * j);
  }
}

// Coming in at a slant it rattles: at most ceil(pi / (2 alpha)) reflections, energy kept.
TEST(Simultaneous, wedge_lets_a_ball_rattle_out) {
  for (const double alpha : {0.01, 0.1, 0.5}) {
    Cluster<double, 2> c;
    c.bodies = {
        {1.0, Vec<double, 2>(1.0, -0.4)}, {infinity, Vec<double, 2>(0.0, 0.0)}, {infinity, Vec<double, 2>(0.0, 0.0)}};
    for (const std::size_t side : {1, 2}) {
      const double sign = side == 1 ? -1.0 : 1.0;
      c.contacts.push_back({0, side, {Wide<double>(sign * std::cos(alpha)), Wide<double>(-std::sin(alpha))}, 1.0});
    }
    const auto out = resolve_cluster(c);
    EXPECT_LE(out.reflections, std::ceil(std::acos(-1.0) / (2 * alpha)));
    EXPECT_LE(std::abs(books(c, out).energy_error), 4e-16);
    EXPECT_LE(books(c, out).approach, 4e-16);
    EXPECT_TRUE(out.cut_short.empty());
  }
}

Cluster<double, 2> between_walls(double speed_left, double speed_right, double e) {
  Cluster<double, 2> c;
  c.bodies = {{1.0, Vec<double, 2>(0.75, 0.3)},
              {infinity, Vec<double, 2>(speed_left, 0.0)},
              {infinity, Vec<double, 2>(speed_right, 0.0)}};
  c.contacts = {{0, 1, {Wide<double>(-1.0), Wide<double>(0.0)}, e}, {0, 2, {Wide<double>(3.0), Wide<double>(0.0)}, e}};
  return c;
}

// No motion across opens either contact of a ball pinned between two walls: what it has across is lost, what it has along
// stays.
TEST(Simultaneous, ball_pinned_between_walls_keeps_what_runs_along_them) {
  for (const double e : {1.0, 0.5, 0.0})
    for (const double speed : {0.0, -0.25}) {
      const auto out = resolve_cluster(between_walls(speed, speed, e));
      EXPECT_EQ(out.velocities[0], (Vec<double, 2>(speed, 0.3)));
      if (e > 0) {
        EXPECT_EQ(out.pinned.size(), 2u);
      }
      EXPECT_NEAR(narrow(out.dissipated), 0.5 * (0.75 - speed) * (0.75 - speed), 1e-16);
      EXPECT_LE(std::abs(books(between_walls(speed, speed, e), out).energy_error), 1e-16);
    }
}

TEST(Simultaneous, walls_that_close_in_crush_and_walls_that_recede_let_go) {
  for (const double e : {1.0, 0.5, 0.0}) {
    const auto crushed = resolve_cluster(between_walls(0.5, -0.5, e));
    EXPECT_EQ(crushed.crushed.size(), 2u);
    EXPECT_EQ(crushed.velocities[0], (Vec<double, 2>(0.75, 0.3)));
    const auto released = resolve_cluster(between_walls(-0.5, 0.5, e));
    EXPECT_TRUE(released.crushed.empty());
    EXPECT_TRUE(released.pinned.empty());
    EXPECT_LE(released.velocities[0][0], 0.5);
    EXPECT_GE(released.velocities[0][0], -0.5);
    EXPECT_LE(std::abs(books(between_walls(-0.5, 0.5, e), released).energy_error), 4e-16);
  }
}

// Three walls around a ball in the plane leave it nowhere to go.
TEST(Simultaneous, ball_among_three_walls_stops) {
  Cluster<double, 2> c;
  c.bodies.push_back({1.0, Vec<double, 2>(0.3, -0.2)});
  for (const double angle : {0.1, 2.3, 4.4}) {
    c.bodies.push_back({infinity, Vec<double, 2>(0.0, 0.0)});
    c.contacts.push_back({0, c.bodies.size() - 1, {Wide<double>(std::cos(angle)), Wide<double>(std::sin(angle))}, 1.0});
  }
  const auto out = resolve_cluster(c);
  EXPECT_EQ(out.velocities[0], (Vec<double, 2>(0.0, 0.0)));
  EXPECT_EQ(out.pinned.size(), 3u);
}

// Heavy, light, heavy: of 10^8 : 1 : 10^8 the light one goes to and fro some thousand times (Galperin), exactly.
TEST(Simultaneous, light_ball_between_heavy_ones_goes_to_and_fro) {
  Cluster<double, 1> c;
  c.bodies = {{1e8, Vec<double, 1>(1.0)}, {1.0, Vec<double, 1>(0.0)}, {infinity, Vec<double, 1>(0.0)}};
  c.contacts = {{0, 1, {Wide<double>(1.0)}, 1.0}, {1, 2, {Wide<double>(1.0)}, 1.0}};
  const auto out = resolve_cluster(c);
  EXPECT_EQ(out.reflections,
            31415);  // digits of pi: the masses are 100^4 : 1 and the light ball starts at rest at the wall
  EXPECT_LE(std::abs(books(c, out).energy_error), 4e-16);
  EXPECT_TRUE(out.cut_short.empty());
}

// A rack of 15 and the cue ball on its axis: 31 contacts of 16 balls, of which three are redundant.
struct Rack {
  Cluster<double, 2> cluster;
  std::vector<std::size_t> mirror;  // ball -> its image at the axis
};

Rack rack(double e, double touching_cue_speed) {
  Rack out;
  std::vector<Vec<double, 2>> x{{-1.0, 0.0}};
  std::vector<std::array<int, 2>> place{{-1, 0}};
  const double h = std::sqrt(3.0) / 2;
  for (int row = 0; row < 5; ++row)
    for (int i = 0; i <= row; ++i) {
      x.push_back({row * h, i - row / 2.0});
      place.push_back({row, 2 * i - row});
    }
  for (std::size_t i = 0; i < x.size(); ++i) {
    out.cluster.bodies.push_back({1.0, Vec<double, 2>(i == 0 ? touching_cue_speed : 0.0, 0.0)});
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (place[i][0] == place[j][0] && place[i][1] == -place[j][1]) out.mirror.push_back(j);
      if (i < j && (x[i] - x[j]).norm() < 1.001) out.cluster.contacts.push_back({i, j, towards<2>(x[i], x[j]), e});
    }
  }
  return out;
}

TEST(Simultaneous, rack_hit_head_on_bursts_symmetrically_to_the_bit) {
  for (const double e : {1.0, 0.9, 0.5, 0.0}) {
    const Rack r = rack(e, 1.0);
    ASSERT_EQ(r.cluster.contacts.size(), 31u);
    const auto out = resolve_cluster(r.cluster);
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_EQ(out.velocities[i][0], out.velocities[r.mirror[i]][0]) << i;
      EXPECT_EQ(out.velocities[i][1], -out.velocities[r.mirror[i]][1]) << i;
    }
    const Books b = books(r.cluster, out);
    EXPECT_LE(std::abs(b.energy_error), 1.2e-16);
    EXPECT_LE(b.momentum_error, 1e-16);
    EXPECT_LE(b.approach, 4e-16);
    expect_no_pull(out);
    EXPECT_TRUE(out.pinned.empty() && out.cut_short.empty() && out.crushed.empty());
    // Impulses of mirrored contacts too, though thirty contacts have more impulses to choose from than there are motions.
    for (std::size_t j = 0; j < r.cluster.contacts.size(); ++j) {
      const auto& c = r.cluster.contacts[j];
      for (std::size_t k = 0; k < j; ++k) {
        const auto& d = r.cluster.contacts[k];
        if ((r.mirror[c.a] == d.a && r.mirror[c.b] == d.b) || (r.mirror[c.a] == d.b && r.mirror[c.b] == d.a)) {
          EXPECT_NEAR(out.impulses[j], out.impulses[k], 1e-11);
        }
      }
    }
  }
}

// Momentum balance of every ball from the impulses alone: they are the ones that made the velocities.
TEST(Simultaneous, impulses_account_for_the_velocities) {
  const Rack r = rack(0.7, 1.0);
  const auto out = resolve_cluster(r.cluster);
  std::vector<Vec<double, 2>> change(16, Vec<double, 2>(0.0, 0.0));
  for (std::size_t j = 0; j < r.cluster.contacts.size(); ++j) {
    const auto& c = r.cluster.contacts[j];
    const Vec<double, 2> n = Vec<double, 2>(narrow(c.r[0]), narrow(c.r[1])).normalized();
    change[c.a] -= out.impulses[j] * n;
    change[c.b] += out.impulses[j] * n;
  }
  for (std::size_t i = 0; i < 16; ++i)
    EXPECT_NEAR((r.cluster.bodies[i].velocity + change[i] - out.velocities[i]).norm(), 0.0, 1e-11) << i;
}

/// n x n balls of diameter 1 in rows and columns, velocities of size 1, between walls at both ends of the first `walled`
/// axes.
Cluster<double, 2> crate(int n, int walled, double e, std::uint64_t seed) {
  RandomStream dice(seed, 9);
  Cluster<double, 2> c;
  for (int i = 0; i < n * n; ++i) c.bodies.push_back({1.0, Vec<double, 2>(dice.normal(), dice.normal())});
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(x * n + y); };
  for (int axis = 0; axis < 2; ++axis)
    for (int line = 0; line < n; ++line) {
      const auto place = [&](int i) { return axis == 0 ? at(i, line) : at(line, i); };
      std::array<Wide<double>, 2> ahead{Wide<double>(axis == 0 ? 1.0 : 0.0), Wide<double>(axis == 0 ? 0.0 : 1.0)},
          back = ahead;
      for (auto& x : back) x = -x;
      for (int i = 0; i + 1 < n; ++i) c.contacts.push_back({place(i), place(i + 1), ahead, e});
      if (axis >= walled) continue;
      c.bodies.push_back({infinity, Vec<double, 2>(0.0, 0.0)});
      c.contacts.push_back({place(n - 1), c.bodies.size() - 1, ahead, e});
      c.contacts.push_back({place(0), c.bodies.size() - 1, back, e});
    }
  return c;
}

// Rows that fill the crate from wall to wall cannot move; along the open axis they do.
TEST(Simultaneous, full_crate_stands_still) {
  for (const double e : {1.0, 0.5, 0.0})
    for (const int n : {2, 3, 4}) {
      const auto stopped = resolve_cluster(crate(n, 2, e, 1));
      const Cluster<double, 2> slot = crate(n, 1, e, 2);
      const auto along = resolve_cluster(slot);
      for (int i = 0; i < n * n; ++i) {
        EXPECT_EQ(stopped.velocities[std::size_t(i)], (Vec<double, 2>(0.0, 0.0)));
        EXPECT_EQ(along.velocities[std::size_t(i)][0], 0.0);
      }
      const Books b = books(slot, along);
      EXPECT_LE(std::abs(b.energy_error), 2.3e-16);
      EXPECT_LE(b.approach, 2.3e-16);
      EXPECT_TRUE(along.crushed.empty() && along.cut_short.empty());
    }
}

// Random clusters: any graph, any normals, masses over six decades, walls at rest.

struct Choice {
  std::uint64_t seed;
  int bodies, contacts, walls;
  double decades, e;
};

Choice any_choice() {
  Choice c;
  c.seed = *rc::gen::inRange<std::uint64_t>(0, 1'000'000);
  c.bodies = *rc::gen::inRange(2, 8);
  c.contacts = *rc::gen::inRange(1, 12);
  c.walls = *rc::gen::element(0, 0, 1, 2);
  c.decades = *rc::gen::element(0.0, 0.0, 1.0, 3.0);
  c.e = *rc::gen::element(1.0, 1.0, 0.9, 0.3, 0.0);
  return c;
}

/// Balls in the order of their numbers along the first axis, so that all normals have a part along it and none is pinned
/// (the field v_x = number opens every contact), with walls to the left of all.
template <int D>
Cluster<double, D> cluster_of(const Choice& choice) {
  RandomStream dice(choice.seed, 7);
  Cluster<double, D> c;
  const auto below = [&](std::size_t n) { return std::min(n - 1, static_cast<std::size_t>(dice.uniform() * double(n))); };
  const auto walls = static_cast<std::size_t>(choice.walls), bodies = static_cast<std::size_t>(choice.bodies);
  for (std::size_t i = 0; i < walls + bodies; ++i) {
    Vec<double, D> v;
    for (int k = 0; k < D; ++k) v[k] = i < walls ? 0.0 : dice.normal();
    const double mass = std::pow(10.0, choice.decades * (2 * dice.uniform() - 1));
    c.bodies.push_back({i < walls ? infinity : mass, v});
  }
  for (int n = 0; n < choice.contacts; ++n) {
    std::size_t a = below(walls + bodies), b = below(walls + bodies);
    if (a == b || (a < walls && b < walls)) continue;
    if (a > b) std::swap(a, b);
    std::array<Wide<double>, D> r;
    for (int k = 0; k < D; ++k) r[k] = Wide<double>(dice.normal());
    r[0] = Wide<double>(0.2 + dice.uniform());
    c.contacts.push_back({a, b, r, choice.e});
  }
  return c;
}

template <int D>
void expect_mechanics(std::uint64_t seed) {
  expect_property(
      [] {
        const Choice choice = any_choice();
        const Cluster<double, D> c = cluster_of<D>(choice);
        const auto out = resolve_cluster(c);
        const Books b = books(c, out);
        RC_ASSERT(out.cut_short.empty() && out.pinned.empty() && out.crushed.empty());
        RC_ASSERT(std::abs(b.energy_error) <= 2.3e-16);  // 2 u: the sum of |rounding of v| m |v|, against the energy
        if (choice.walls == 0) RC_ASSERT(b.momentum_error <= 1.2e-16);
        RC_ASSERT(b.approach <= 2.3e-16);
        RC_ASSERT(narrow(out.dissipated) >= 0.0);
        for (const double j : out.impulses) RC_ASSERT(j >= 0.0);
        if (choice.e == 1) RC_ASSERT(narrow(out.dissipated) == 0.0);
      },
      1000, seed);
}

TEST(Simultaneous, keeps_energy_and_momentum_and_ends_all_approach) {
  expect_mechanics<1>(1);
  expect_mechanics<2>(2);
  expect_mechanics<3>(3);
}

// Numbers are names: shuffled bodies and contacts, ends exchanged, give the same bits.
TEST(Simultaneous, numbering_does_not_matter) {
  expect_property(
      [] {
        const Choice choice = any_choice();
        const Cluster<double, 2> c = cluster_of<2>(choice);
        RandomStream dice(choice.seed, 8);
        const auto shuffled = [&](std::size_t n) {
          std::vector<std::size_t> order(n);
          std::iota(order.begin(), order.end(), std::size_t{0});
          for (std::size_t i = n; i-- > 1;) std::swap(order[i], order[std::size_t(dice.uniform() * double(i + 1))]);
          return order;
        };
        const std::vector<std::size_t> body = shuffled(c.bodies.size()), contact = shuffled(c.contacts.size());
        Cluster<double, 2> other = c;
        for (std::size_t i = 0; i < body.size(); ++i) other.bodies[body[i]] = c.bodies[i];
        for (std::size_t j = 0; j < contact.size(); ++j) {
          auto& d = other.contacts[contact[j]];
          d = c.contacts[j];
          d.a = body[d.a];
          d.b = body[d.b];
          if (j % 2 == 0) {
            std::swap(d.a, d.b);
            for (auto& x : d.r) x = -x;
          }
        }
        const auto p = resolve_cluster(c), q = resolve_cluster(other);
        for (std::size_t i = 0; i < body.size(); ++i) RC_ASSERT(p.velocities[i] == q.velocities[body[i]]);
        for (std::size_t j = 0; j < contact.size(); ++j)
          RC_ASSERT(std::abs(p.impulses[j] - q.impulses[contact[j]]) <= 1e-10 * (p.impulses[j] + 1));
      },
      1000, 4);
}

// The law in a hundred digits, rounded once: half an ulp, or 2^-90 of what cancels.
TEST(Simultaneous, velocities_are_rounded_once) {
  expect_property(
      [] {
        const Choice choice = any_choice();
        const Cluster<double, 3> c = cluster_of<3>(choice);
        const auto got = resolve_cluster(c);
        const auto want = resolve_cluster(exactly(c));
        double fastest = 0;
        for (const auto& v : got.velocities) fastest = std::max(fastest, v.template lpNorm<Eigen::Infinity>());
        for (std::size_t i = 0; i < c.bodies.size(); ++i)
          for (int k = 0; k < 3; ++k) {
            const double v = got.velocities[i][k];
            const double half_ulp = 0.5 * (std::nextafter(std::abs(v), infinity) - std::abs(v));
            RC_ASSERT(double(Exact(abs(Exact(want.velocities[i][k] - v)))) <= half_ulp * (1 + 1e-9) + fastest * 1e-24);
          }
        RC_ASSERT(got.reflections == want.reflections);
      },
      400, 5);
}

// e = 0 [Moreau]: the change is a sum of pushes, and a contact that parts has none: J >= 0, c' <= 0, J c' = 0.
TEST(Simultaneous, plastic_impact_is_complementary) {
  expect_property(
      [] {
        Choice choice = any_choice();
        choice.e = 0.0;
        choice.decades = 0.0;
        const Cluster<double, 2> c = cluster_of<2>(choice);
        const auto out = resolve_cluster(c);
        for (std::size_t j = 0; j < c.contacts.size(); ++j) {
          const auto& contact = c.contacts[j];
          const Vec<double, 2> g = out.velocities[contact.a] - out.velocities[contact.b];
          const double closing = g[0] * narrow(contact.r[0]) + g[1] * narrow(contact.r[1]);
          RC_ASSERT(closing <= 1e-14);
          RC_ASSERT(std::abs(closing * out.impulses[j]) <= 1e-10 * (1 + out.impulses[j]));
        }
      },
      500, 6);
}

// Contacts of different e: the smallest of those that approached. A dead contact that is never pushed changes nothing.
TEST(Simultaneous, smallest_restitution_of_those_that_meet) {
  Cluster<double, 1> c = cradle(3, 1, 1.0);
  c.contacts[1].e = 0.5;
  Cluster<double, 1> same = cradle(3, 1, 0.5);
  EXPECT_EQ(resolve_cluster(c).velocities, resolve_cluster(same).velocities);
  Cluster<double, 1> apart = cradle(3, 1, 1.0);
  apart.bodies[2].velocity[0] = 5.0;  // leaves before the push arrives
  apart.contacts[1].e = 0.0;
  EXPECT_EQ(resolve_cluster(apart).velocities[1][0], 1.0);
}

// Two clusters that share only a wall do not see each other.
TEST(Simultaneous, walls_do_not_connect) {
  Cluster<double, 2> c = corner(1.0);
  c.bodies.push_back({1.0, Vec<double, 2>(-1.0, 2.0)});
  c.contacts.push_back({3, 1, {Wide<double>(-1.0), Wide<double>(0.0)}, 0.0});
  const auto out = resolve_cluster(c);
  EXPECT_EQ(out.velocities[0], (Vec<double, 2>(3.0, 0.7)));
  EXPECT_EQ(out.velocities[3], (Vec<double, 2>(0.0, 2.0)));
}

}  // namespace
}  // namespace carom
