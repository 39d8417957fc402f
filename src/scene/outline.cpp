#include "outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace carom::scene_text {

namespace {

bool is_sided(const WallSpec& w) {
  return w.kind == WallKind::circle || w.kind == WallKind::ellipse || w.kind == WallKind::curve || w.kind == WallKind::plane;
}

/// Whether the wall alone keeps balls in a bounded place.
bool encloses(const WallSpec& w) { return is_sided(w) && w.kind != WallKind::plane && w.side == WallSide::inside && !w.opening; }

/// [length] no point of the wall is further from its centre; none: it has no centre, or no end.
std::optional<double> reach(const WallSpec& w) {
  switch (w.kind) {
    case WallKind::circle:
    case WallKind::arc:
      return w.radius.value;
    case WallKind::ellipse: {
      double most = 0;
      for (const Number& a : w.axes) most = std::max(most, a.value);
      return most;
    }
    case WallKind::curve: {
      double sum = 0;
      for (const Number& c : w.cosines) sum += std::abs(c.value);
      for (const Number& c : w.sines) sum += std::abs(c.value);
      return sum;
    }
    case WallKind::parabola:  // its ends are at y = half_width, x = y^2 / 4 f
      return std::hypot(w.half_width.value, w.half_width.value * w.half_width.value / (4 * w.focal_length.value));
    case WallKind::segment:
    case WallKind::plane:
    case WallKind::polygon:
      break;
  }
  return std::nullopt;
}

struct Box {
  std::vector<double> lower, upper;

  explicit Box(int dimension)
      : lower(static_cast<std::size_t>(dimension), std::numeric_limits<double>::infinity()),
        upper(static_cast<std::size_t>(dimension), -std::numeric_limits<double>::infinity()) {}

  void take(const Coordinates& x, double margin = 0) {
    for (std::size_t c = 0; c < lower.size() && c < x.size(); ++c) {
      lower[c] = std::min(lower[c], x[c].value - margin);
      upper[c] = std::max(upper[c], x[c].value + margin);
    }
  }
};

Box around(const Scene& scene) {
  Box box(scene.dimension);
  for (const WallSpec& w : scene.walls) {
    if (w.opening && is_sided(w)) continue;
    for (const Coordinates& v : w.vertices) box.take(v);
    if (w.kind == WallKind::segment) {
      box.take(w.from);
      box.take(w.to);
    }
    if (const std::optional<double> r = reach(w); r && (!is_sided(w) || encloses(w))) box.take(w.centre, *r);
  }
  return box;
}

/// Crossings of the ray from (x, y) to the right.
int crossings(const Coordinates& a, const Coordinates& b, double x, double y) {
  const double ya = a[1].value, yb = b[1].value;
  if ((ya <= y) == (yb <= y)) return 0;
  const double at = a[0].value + (y - ya) / (yb - ya) * (b[0].value - a[0].value);
  return at > x ? 1 : 0;
}

int crossings(const WallSpec& w, double x, double y) {
  switch (w.kind) {
    case WallKind::segment:
      return crossings(w.from, w.to, x, y);
    case WallKind::polygon: {
      int n = 0;
      for (std::size_t i = 0; i < w.vertices.size(); ++i)
        n += crossings(w.vertices[i], w.vertices[(i + 1) % w.vertices.size()], x, y);
      return n;
    }
    case WallKind::arc: {
      const double dy = y - w.centre[1].value, square = w.radius.value * w.radius.value - dy * dy;
      if (!(square > 0)) return 0;
      int n = 0;
      for (const double dx : {std::sqrt(square), -std::sqrt(square)}) {
        constexpr double turn = 2 * std::numbers::pi;
        double beyond = std::fmod(std::atan2(dy, dx) - w.from_angle.value, turn);
        if (beyond < 0) beyond += turn;
        if (w.centre[0].value + dx > x && beyond < w.to_angle.value - w.from_angle.value) ++n;
      }
      return n;
    }
    default:
      return 0;
  }
}

/// Sided walls are left to the start of the run, which refuses what overlaps them; a point beyond a circle does not.
bool on_its_side(const WallSpec& w, const std::vector<double>& x) {
  if (w.kind != WallKind::circle) return true;
  double square = 0;
  for (std::size_t c = 0; c < x.size(); ++c) square += (x[c] - w.centre[c].value) * (x[c] - w.centre[c].value);
  const double r = w.radius.value;
  return w.side == WallSide::inside ? square <= r * r : square >= r * r;
}

}  // namespace

std::optional<Outline> Outline::of(const Scene& scene) {
  Outline outline(scene);
  if (scene.space.kind != SpaceKind::open) {
    for (const Number& x : scene.space.lower) outline.lower.push_back(x.value);
    for (const Number& x : scene.space.upper) outline.upper.push_back(x.value);
    return outline;
  }
  const Box box = around(scene);
  for (std::size_t c = 0; c < box.lower.size(); ++c)
    if (!(box.lower[c] < box.upper[c])) return std::nullopt;
  outline.lower = box.lower;
  outline.upper = box.upper;
  return outline;
}

bool Outline::holds(const std::vector<double>& x) const {
  const std::vector<WallSpec>& walls = scene->walls;
  if (!std::all_of(walls.begin(), walls.end(), [&](const WallSpec& w) { return on_its_side(w, x); })) return false;
  const bool bounded = scene->space.kind != SpaceKind::open || std::any_of(walls.begin(), walls.end(), encloses);
  if (scene->dimension != 2 || bounded) return true;
  int around = 0;
  for (const WallSpec& w : walls) around += crossings(w, x[0], x[1]);
  return around % 2 == 1;
}

}  // namespace carom::scene_text
