#pragma once
// Scenes made in code, logs of what they do, and comparisons bit for bit: what the tests of the simulator share.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "carom/sim/simulation.hpp"

namespace carom::testing {

/// n where the program is optimised; a tenth of it where contracts are checked, a fiftieth under a sanitizer.
[[nodiscard]] constexpr std::int64_t scaled_count(std::int64_t n) {
#if defined(__SANITIZE_ADDRESS__)
  return n / 50;
#elif defined(CAROM_CHECKS) || !defined(NDEBUG)
  return n / 10;
#else
  return n;
#endif
}

[[nodiscard]] inline BallSpec ball(Coordinates x, Coordinates v, double radius = 0.5, double mass = 1.0) {
  BallSpec b;
  b.position = std::move(x);
  b.velocity = std::move(v);
  b.radius = radius;
  b.mass = mass;
  return b;
}

[[nodiscard]] inline Scene open_space(int dimension) {
  Scene scene;
  scene.dimension = dimension;
  scene.run.events = std::numeric_limits<std::int64_t>::max();
  return scene;
}

[[nodiscard]] inline Scene box(Coordinates lower, Coordinates upper) {
  Scene scene = open_space(static_cast<int>(lower.size()));
  scene.space.kind = SpaceKind::box;
  scene.space.lower = std::move(lower);
  scene.space.upper = std::move(upper);
  return scene;
}

[[nodiscard]] inline WallSpec plane(Coordinates point, Coordinates normal) {
  WallSpec w;
  w.kind = WallKind::plane;
  w.point = std::move(point);
  w.normal = std::move(normal);
  return w;
}

[[nodiscard]] inline WallSpec segment(Coordinates from, Coordinates to) {
  WallSpec w;
  w.kind = WallKind::segment;
  w.from = std::move(from);
  w.to = std::move(to);
  return w;
}

[[nodiscard]] inline WallSpec circle(Coordinates centre, double radius, WallSide side) {
  WallSpec w;
  w.kind = WallKind::circle;
  w.centre = std::move(centre);
  w.radius = radius;
  w.side = side;
  return w;
}

/// Numbers that are the same on every machine: the standard fixes mt19937_64, and the rest is one exact scaling.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed) {}
  /// Uniform in [0, 1), a multiple of 2^-53.
  [[nodiscard]] double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::mt19937_64 bits_;
};

/// A box [0, side]^D with balls of unequal radii and masses on a grid, each jittered in its place; velocities in [-1, 1]^D.
[[nodiscard]] inline Scene mixed_box(int dimension, int balls, double side, std::uint64_t seed, double smallest = 0.5,
                                     double heaviest = 8.0) {
  Dice dice(seed);
  Scene scene =
      box(Coordinates(static_cast<std::size_t>(dimension), 0.0), Coordinates(static_cast<std::size_t>(dimension), side));
  const int row = static_cast<int>(std::ceil(std::pow(balls, 1.0 / dimension) - 1e-9));
  const double cell = side / row;
  for (int i = 0; i < balls; ++i) {
    const double radius = cell * 0.45 * dice.between(smallest, 1.0);
    Coordinates x, v;
    for (int k = 0, place = i; k < dimension; ++k, place /= row) {
      const double slack = 0.5 * cell - radius;
      x.push_back(cell * (place % row + 0.5) + slack * dice.between(-0.99, 0.99));
      v.push_back(dice.between(-1.0, 1.0));
    }
    scene.balls.push_back(ball(x, v, radius, dice.between(1.0, heaviest)));
  }
  return scene;
}

/// n rods of unequal lengths and masses in a row between two walls.
[[nodiscard]] inline Scene rods(int n, std::uint64_t seed) {
  Dice dice(seed);
  Scene scene = open_space(1);
  double x = 0.0;
  for (int i = 0; i < n; ++i) {
    const double radius = dice.between(0.1, 0.6);
    x += radius + dice.between(0.05, 1.0);
    const double mass = dice.between(0.5, 4.0);  // in statements of their own: the order of arguments is the compiler's
    const double speed = dice.between(-1.0, 1.0);
    scene.balls.push_back(ball({x}, {speed}, radius, mass));
    x += radius;
  }
  scene.space.kind = SpaceKind::box;
  scene.space.lower = {0.0};
  scene.space.upper = {x + 0.25};
  return scene;
}

/// A touching triangle of 15 balls, and a cue ball on its way to the apex.
[[nodiscard]] inline Scene rack_and_cue(double aside = 0.0) {
  Scene scene = box({-10.0, -5.0}, {10.0, 5.0});
  scene.balls.push_back(ball({-6.0, aside}, {3.0, 0.0}));
  LatticeSpec rack;
  rack.kind = LatticeKind::rack;
  rack.radius = 0.5;
  rack.apex = {0.0, 0.0};
  scene.lattices.push_back(rack);
  return scene;
}

// Logs.

[[nodiscard]] inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// The physics of a collision; NaN and the sign of 0 count.
[[nodiscard]] inline bool same_party(const Collision::Party& a, const Collision::Party& b) {
  bool same = a.number == b.number && a.image == b.image;
  for (std::size_t k = 0; k < 3; ++k)
    same = same && same_bits(a.position[k], b.position[k]) && same_bits(a.velocity_before[k], b.velocity_before[k]) &&
           same_bits(a.velocity_after[k], b.velocity_after[k]);
  return same;
}

/// `epochs` is what b's clock is ahead of a's.
[[nodiscard]] inline bool same_collision(const Collision& a, const Collision& b, std::int64_t epochs = 0) {
  return a.epoch + epochs == b.epoch && same_bits(a.offset, b.offset) && a.kind == b.kind && a.feature == b.feature &&
         same_party(a.ball, b.ball) && same_party(a.partner, b.partner) && same_bits(a.impulse, b.impulse) &&
         same_bits(a.gap, b.gap) && same_bits(a.dissipated, b.dissipated) && same_bits(a.injected, b.injected) &&
         a.tie == b.tie;
}

inline std::ostream& show(std::ostream& out, const Collision& c) {
  out << "epoch " << c.epoch << " offset " << c.offset << " kind " << int(c.kind) << " ball " << c.ball.number
      << " partner " << c.partner.number << std::hexfloat;
  for (const auto* p : {&c.ball, &c.partner})
    out << " x " << p->position[0] << ' ' << p->position[1] << " v " << p->velocity_after[0] << ' ' << p->velocity_after[1];
  return out << std::defaultfloat << " tie " << c.tie;
}

/// The first difference between two logs, or "" if there is none.
[[nodiscard]] inline std::string difference(const std::vector<Collision>& a, const std::vector<Collision>& b,
                                            std::int64_t epochs = 0) {
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    if (!same_collision(a[i], b[i], epochs)) {
      std::ostringstream text;
      text << "collision " << i << ":\n  ";
      show(text, a[i]) << "\n  ";
      show(text, b[i]);
      return text.str();
    }
  return a.size() == b.size() ? "" : std::to_string(a.size()) + " collisions against " + std::to_string(b.size());
}

struct Result {
  std::vector<Collision> log;
  Summary summary;
  std::vector<BallState> balls;
  Stop stop = Stop::until;
};

[[nodiscard]] inline Result run(const Scene& scene, std::int64_t events) {
  Result result;
  Simulation simulation(scene);
  result.stop = simulation.advance(std::nullopt, events, [&](const Collision& c) { result.log.push_back(c); });
  result.summary = simulation.summary();
  result.balls = simulation.balls();
  return result;
}

[[nodiscard]] inline Result run_until(const Scene& scene, double until) {
  Result result;
  Simulation simulation(scene);
  result.stop = simulation.advance(Number(until), std::nullopt, [&](const Collision& c) { result.log.push_back(c); });
  result.summary = simulation.summary();
  result.balls = simulation.balls();
  return result;
}

}  // namespace carom::testing
