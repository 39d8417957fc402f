#include "outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace carom {

namespace {

constexpr int steps = 720;  // of a curve that is neither straight nor a circle

std::array<double, 2> point(const Coordinates& c) { return {c[0].value, c[1].value}; }

}  // namespace

bool is_closed(TableKind kind) {
  return kind != TableKind::sinai && kind != TableKind::lorentz && kind != TableKind::wedge && kind != TableKind::cradle;
}

std::vector<Outline> outlines(const Scene& scene) {
  std::vector<Outline> all;
  for (std::size_t t = 0; t < scene.tables.size(); ++t)
    if (is_closed(scene.tables[t].kind)) all.emplace_back(scene, t);
  return all;
}

Outline::Outline(const Scene& scene, std::size_t table) {
  lower_.fill(std::numeric_limits<double>::max());
  upper_.fill(std::numeric_limits<double>::lowest());
  for (const WallSpec& w : scene.walls)
    if (w.table == static_cast<int>(table)) add_wall(w);
}

void Outline::hold(const Point& p) {
  for (std::size_t k = 0; k < 2; ++k) {
    lower_[k] = std::min(lower_[k], p[k]);
    upper_[k] = std::max(upper_[k], p[k]);
  }
}

void Outline::add(const Piece& piece) {
  hold(piece.from);
  hold(piece.to);
  pieces_.push_back(piece);
}

void Outline::add_wall(const WallSpec& w) {
  std::vector<Point> corners;
  const auto turned = [&](double x, double y) {
    const double c = std::cos(w.angle.value), s = std::sin(w.angle.value);
    return Point{w.centre[0].value + c * x - s * y, w.centre[1].value + s * x + c * y};
  };
  switch (w.kind) {
    case WallKind::segment:
      return add({point(w.from), point(w.to)});
    case WallKind::arc:
      return add_arc(w);
    case WallKind::circle: {
      const Point c = point(w.centre);
      const Point top{c[0], c[1] + w.radius}, bottom{c[0], c[1] - w.radius};
      if (w.side == WallSide::outside) return;  // an obstacle
      hold({c[0] - w.radius, c[1]});
      hold({c[0] + w.radius, c[1]});
      add({bottom, top, 1, c, w.radius});
      return add({top, bottom, -1, c, w.radius});
    }
    case WallKind::polygon:
      for (const Coordinates& v : w.vertices) corners.push_back(point(v));
      break;
    case WallKind::ellipse:
      for (int k = 0; k < steps; ++k) {
        const double a = 2 * std::numbers::pi * k / steps;
        corners.push_back(turned(w.axes[0].value * std::cos(a), w.axes[1].value * std::sin(a)));
      }
      break;
    case WallKind::curve:
      for (int k = 0; k < steps; ++k) {
        const double a = 2 * std::numbers::pi * k / steps;
        double r = 0;
        for (std::size_t n = 0; n < w.cosines.size(); ++n) r += w.cosines[n].value * std::cos(static_cast<double>(n) * a);
        for (std::size_t n = 0; n < w.sines.size(); ++n) r += w.sines[n].value * std::sin(static_cast<double>(n) * a);
        corners.push_back(turned(r * std::cos(a), r * std::sin(a)));
      }
      break;
    case WallKind::plane:
    case WallKind::parabola:
      return;
  }
  for (std::size_t k = 0; k < corners.size(); ++k) add({corners[k], corners[(k + 1) % corners.size()]});
}

/// Cut at its highest and lowest points. A point of the circle is on an arc if it lies to the right of the chord from its
/// beginning to its end.
void Outline::add_arc(const WallSpec& w) {
  const Point a = point(w.from), b = point(w.to), c = point(w.centre);
  const double r = w.radius.value;
  const auto on_arc = [&](const Point& q) { return (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]) < 0; };
  const Point top{c[0], c[1] + r}, bottom{c[0], c[1] - r};
  for (const Point& side : {Point{c[0] - r, c[1]}, Point{c[0] + r, c[1]}})
    if (on_arc(side)) hold(side);
  Point at = a;
  int half = a[0] > c[0] || (a[0] == c[0] && a[1] < c[1]) ? 1 : -1;  // anticlockwise: up on the right, down on the left
  for (int cuts = 0; cuts < 2; ++cuts) {
    const Point& next = half > 0 ? top : bottom;
    if (!on_arc(next)) break;
    add({at, next, half, c, r});
    at = next;
    half = -half;
  }
  add({at, b, half, c, r});
}

bool Outline::inside_or_on(const double* x) const {
  // Chords of a smooth curve lie within (pi / steps)^2 of its size from it; which side of the curve itself a place near it is
  // on is judged elsewhere.
  constexpr double chord = std::numbers::pi / steps;
  const bool smooth = pieces_.size() == steps;
  const double h = std::max(upper_[0] - lower_[0], upper_[1] - lower_[1]) * (smooth ? chord * chord : 0x1p-30);
  for (const double dx : {0.0, -h, h})
    for (const double dy : {0.0, -h, h}) {
      const double at[2] = {x[0] + dx, x[1] + dy};
      if (inside(at)) return true;
    }
  return false;
}

bool Outline::inside(const double* x) const {
  bool odd = false;
  for (const Piece& p : pieces_) {
    if ((p.from[1] > x[1]) == (p.to[1] > x[1])) continue;
    const double dy = x[1] - p.centre[1];
    const double at = p.half == 0 ? p.from[0] + (x[1] - p.from[1]) / (p.to[1] - p.from[1]) * (p.to[0] - p.from[0])
                                  : p.centre[0] + p.half * std::sqrt(std::max(0.0, p.radius * p.radius - dy * dy));
    if (at > x[0]) odd = !odd;
  }
  return odd;
}

}  // namespace carom
