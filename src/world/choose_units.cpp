#include "choose_units.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "carom/world/build.hpp"

namespace carom {
namespace {

// long double (15-bit exponent): squares of anything that a scene may hold neither overflow nor underflow.
using Wider = long double;

Wider length_of(const Coordinates& v) {
  Wider s = 0;
  for (const Number& c : v) s += Wider(c.value) * Wider(c.value);
  return std::sqrt(s);
}

// How many times faster than the fastest of the start the clock expects a ball to become.
constexpr Wider most_gain = 0x1p20L;

struct Scales {
  Wider smallest_length = HUGE_VALL;
  Wider largest_length = 0;
  Wider energy = 0;  ///< twice the kinetic energy of the finite masses
  Wider lightest = HUGE_VALL;
  Wider largest_speed = 0;  ///< of infinite masses and walls
  Wider fastest = 0;        ///< speed of a finite mass at the start

  void length(Wider l) {
    if (l > 0) smallest_length = std::min(smallest_length, l);
    largest_length = std::max(largest_length, l);
  }
};

void read_walls(const Scene& scene, Scales& s) {
  for (const WallSpec& w : scene.walls) {
    if (w.kind == WallKind::circle || w.kind == WallKind::arc) s.length(w.radius.value);
    for (const Number& axis : w.axes) s.length(axis.value);
    if (w.kind == WallKind::parabola) {
      s.length(w.focal_length.value);
      s.length(w.half_width.value);
    }
    if (w.kind == WallKind::curve) {
      Wider size = 0;
      for (const auto* terms : {&w.cosines, &w.sines})
        for (const Number& c : *terms) size += std::fabs(Wider(c.value));
      s.length(size);
    }
    const auto side = [&](const Coordinates& a, const Coordinates& b) {
      Wider d = 0;
      for (std::size_t k = 0; k < a.size(); ++k) d += (Wider(b[k].value) - a[k].value) * (Wider(b[k].value) - a[k].value);
      s.length(std::sqrt(d));
    };
    if (w.kind == WallKind::segment) side(w.from, w.to);
    if (w.kind == WallKind::polygon)
      for (std::size_t i = 0; i < w.vertices.size(); ++i) side(w.vertices[i], w.vertices[(i + 1) % w.vertices.size()]);
    s.largest_speed = std::max(s.largest_speed, length_of(w.velocity));
    if (!w.oscillation) continue;
    const Wider swing = length_of(w.oscillation->amplitude);
    s.length(swing);
    s.largest_speed = std::max(s.largest_speed, length_of(w.velocity) + swing * Wider(w.oscillation->omega.value));
  }
}

void read_balls(const Scene& scene, const Roster& roster, Scales& s) {
  Wider low = HUGE_VALL, high = -HUGE_VALL;
  for (const BallSpec& b : scene.balls) {
    s.length(b.radius.value);
    for (const Number& x : b.position) {
      low = std::min(low, Wider(x.value));
      high = std::max(high, Wider(x.value));
    }
    if (b.fixed) continue;
    const Wider v = length_of(b.velocity);
    if (std::isinf(b.mass.value)) {
      s.largest_speed = std::max(s.largest_speed, v);
    } else {
      s.energy += b.mass.value * v * v;
      s.fastest = std::max(s.fastest, v);
      s.lightest = std::min(s.lightest, Wider(b.mass.value));
    }
  }
  for (const PlacedGroup& g : roster.groups) {
    s.length(g.balls.radius);
    Wider sum = 0;
    Wider fastest = 0;
    for (const double v : g.balls.velocity) {
      sum += Wider(v) * v;
      fastest = std::max(fastest, std::fabs(Wider(v)));
    }
    if (std::isinf(g.mass.value)) {
      s.largest_speed = std::max(s.largest_speed, std::sqrt(sum));
    } else {
      s.energy += g.mass.value * sum;
      s.fastest = std::max(s.fastest, fastest);
      s.lightest = std::min(s.lightest, Wider(g.mass.value));
    }
  }
  // Points in open space have no length but the distances between them.
  if (s.smallest_length == HUGE_VALL && high > low) s.length(high - low);
}

/// Exponents of two that values of one kind may have.
struct Range {
  int low, high;
};

[[nodiscard]] Range around(int unit) { return {unit - exponent_range, unit + exponent_range}; }

/// Speeds below the fastest. Where a pull sets the clock, or light balls may gain speed, that is in proportion to theirs.
[[nodiscard]] Range speeds(const Scales& s, const Units& units) {
  const Wider fastest = std::max(s.fastest, s.largest_speed);
  const int slow_clock = units.velocity() - (std::ilogb(most_gain) + 13);
  return {std::max(fastest > 0 ? std::ilogb(fastest) : slow_clock, slow_clock) - speed_range,
          units.velocity() + exponent_range};
}

/// Complains about a value that is not 0 and lies beyond the range.
void judge(const Scene& scene, int line, const char* what, double value, Range range, std::vector<Problem>& problems) {
  if (value == 0 || !std::isfinite(value)) return;
  const int exponent = std::ilogb(value);
  if (range.low <= exponent && exponent <= range.high) return;
  problems.push_back({scene.file, line, fmt::format("{} {} is out of range", what, value),
                      fmt::format("within this scene such a value lies between 2^{} and 2^{}", range.low, range.high),
                      "Leave out what is too small or too large to matter"});
}

void judge_all(const Scene& scene, const Scales& scales, const Units& units, std::vector<Problem>& problems) {
  const Range length = around(units.length), mass = around(units.mass), acceleration = around(units.acceleration()),
              velocity = speeds(scales, units);
  for (const BallSpec& b : scene.balls) {
    for (const Number& x : b.position) judge(scene, b.where.line, "coordinate", x, length, problems);
    for (const Number& v : b.velocity) judge(scene, b.where.line, "velocity", v, velocity, problems);
    judge(scene, b.where.line, "radius", b.radius, length, problems);
    judge(scene, b.where.line, "mass", b.mass, mass, problems);
    judge(scene, b.where.line, "radius_growth", b.radius_growth, velocity, problems);
  }
  for (const Coordinates* c : {&scene.space.lower, &scene.space.upper})
    for (const Number& x : *c) judge(scene, scene.space.where.line, "coordinate", x, length, problems);
  for (const WallSpec& w : scene.walls) {
    for (const Coordinates* c : {&w.from, &w.to, &w.point, &w.centre})
      for (const Number& x : *c) judge(scene, w.where.line, "coordinate", x, length, problems);
    for (const Coordinates& vertex : w.vertices)
      for (const Number& x : vertex) judge(scene, w.where.line, "coordinate", x, length, problems);
    for (const Number& v : w.velocity) judge(scene, w.where.line, "velocity", v, velocity, problems);
    if (w.kind == WallKind::circle || w.kind == WallKind::arc)
      judge(scene, w.where.line, "radius", w.radius, length, problems);
    for (const Number& axis : w.axes) judge(scene, w.where.line, "semi-axis", axis, length, problems);
    if (w.kind == WallKind::parabola) {
      judge(scene, w.where.line, "focal_length", w.focal_length, length, problems);
      judge(scene, w.where.line, "half_width", w.half_width, length, problems);
    }
    for (const auto* terms : {&w.cosines, &w.sines})
      for (const Number& c : *terms) judge(scene, w.where.line, "coefficient", c, length, problems);
  }
  for (const Number& a : scene.motion.acceleration)
    judge(scene, scene.motion.where.line, "acceleration", a, acceleration, problems);
}

}  // namespace

Units choose_units(const Scene& scene, const Roster& roster, std::vector<Problem>& problems) {
  Scales s;
  for (const BallSpec& b : scene.balls) s.largest_speed = std::max(s.largest_speed, Wider(b.radius_growth.value));
  for (const PlacedGroup& g : roster.groups) s.largest_speed = std::max(s.largest_speed, Wider(g.radius_growth.value));
  if (roster.region.kind != SpaceKind::open)
    for (int k = 0; k < scene.dimension; ++k) s.length(Wider(roster.region.upper[k]) - roster.region.lower[k]);
  read_walls(scene, s);
  read_balls(scene, roster, s);
  if (s.smallest_length == HUGE_VALL) s.length(1);
  if (s.lightest == HUGE_VALL) s.lightest = 1;

  // A ball gains at most twice the speed of what it meets, so many times the first speed is far away, whatever the masses.
  Wider speed = std::max(s.largest_speed, std::min(std::sqrt(s.energy / s.lightest), most_gain * s.fastest));
  const Wider g = length_of(scene.motion.acceleration);
  speed = std::max(speed, std::sqrt(g * s.largest_length));
  if (scene.motion.magnetic) speed = std::max(speed, std::fabs(Wider(scene.motion.magnetic->value)) * s.smallest_length);
  Units units;
  units.length = std::ilogb(s.smallest_length);
  units.mass = std::ilogb(s.lightest);
  units.time = speed > 0 ? units.length - (std::ilogb(speed) + 1) - 12 : -12;
  judge_all(scene, s, units, problems);
  return units;
}

}  // namespace carom
