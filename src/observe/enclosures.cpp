#include "carom/observe/enclosures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace carom {

namespace {

Triple triple(const Coordinates& c) {
  Triple t{};
  std::copy_n(c.begin(), std::min<std::size_t>(3, c.size()), t.begin());
  return t;
}

Triple moved(Triple x, const Triple& velocity, double by) {
  for (std::size_t k = 0; k < 3; ++k) x[k] += by * velocity[k];
  return x;
}

/// Whether a ray from x towards +x crosses the edge; over a closed line, an odd number of crossings means inside.
bool crosses(const Triple& x, const Triple& from, const Triple& to) {
  if ((from[1] > x[1]) == (to[1] > x[1])) return false;
  return x[0] < from[0] + (x[1] - from[1]) * (to[0] - from[0]) / (to[1] - from[1]);
}

/// The pieces into which segments fall that share ends and a velocity.
std::vector<std::vector<const WallSpec*>> connected(const std::vector<WallSpec>& walls) {
  using Point = std::pair<Triple, Triple>;  // with the velocity
  std::vector<std::vector<const WallSpec*>> pieces;
  std::vector<std::vector<Point>> ends;
  for (const WallSpec& w : walls) {
    if (w.kind != WallKind::segment) continue;
    std::vector<const WallSpec*> piece{&w};
    std::vector<Point> own{{triple(w.from), triple(w.velocity)}, {triple(w.to), triple(w.velocity)}};
    for (std::size_t p = pieces.size(); p-- > 0;) {
      const auto touches = [&](const Point& end) { return end == own[0] || end == own[1]; };
      if (std::none_of(ends[p].begin(), ends[p].end(), touches)) continue;
      piece.insert(piece.end(), pieces[p].begin(), pieces[p].end());
      own.insert(own.end(), ends[p].begin(), ends[p].end());
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(p));
      ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(p));
    }
    pieces.push_back(std::move(piece));
    ends.push_back(std::move(own));
  }
  return pieces;
}

}  // namespace

Enclosures::Enclosures(const Scene& scene, const Subject& subject, const std::vector<Triple>& balls)
    : dimension_(static_cast<std::size_t>(scene.dimension)),
      periodic_(subject.space == SpaceKind::periodic),
      edge_(subject.edge) {
  for (const WallSpec& wall : scene.walls) add_wall(wall);
  if (dimension_ == 2) add_closed_segments(scene);
  if (subject.space == SpaceKind::box)
    for (std::size_t k = 0; k < dimension_; ++k)
      for (const double sign : {+1.0, -1.0}) {
        HalfSpace face{};
        face.point[k] = sign > 0 ? scene.space.lower[k].value : scene.space.upper[k].value;
        face.normal[k] = sign;
        half_spaces_.push_back(face);
      }
  for (Ring& ring : rings_)
    for (const Triple& x : balls) ring.holds.push_back(inside(ring, x, 0.0));
}

void Enclosures::add_wall(const WallSpec& wall) {
  if (wall.kind == WallKind::plane && !periodic_)
    half_spaces_.push_back({triple(wall.point), triple(wall.normal), triple(wall.velocity)});
  if (wall.kind == WallKind::circle)
    rounds_.push_back({triple(wall.centre), triple(wall.velocity), wall.radius, wall.side == WallSide::inside});
  if (wall.kind == WallKind::ellipse || wall.kind == WallKind::curve)
    bents_.push_back({wall, triple(wall.centre), triple(wall.velocity)});
  if (wall.kind != WallKind::polygon) return;
  Ring ring;
  ring.velocity = triple(wall.velocity);
  const std::size_t n = wall.vertices.size();
  for (std::size_t i = 0; i < n; ++i) ring.edges.push_back({triple(wall.vertices[i]), triple(wall.vertices[(i + 1) % n])});
  rings_.push_back(std::move(ring));
}

void Enclosures::add_closed_segments(const Scene& scene) {
  for (const auto& piece : connected(scene.walls)) {
    std::map<Triple, int> degree;
    Ring ring;
    ring.velocity = triple(piece.front()->velocity);
    for (const WallSpec* w : piece) {
      ring.edges.push_back({triple(w->from), triple(w->to)});
      ++degree[ring.edges.back().from];
      ++degree[ring.edges.back().to];
    }
    const auto even = [](const auto& end) { return end.second % 2 == 0; };
    if (std::all_of(degree.begin(), degree.end(), even)) rings_.push_back(std::move(ring));
  }
}

template <class F>
bool Enclosures::any_image(const Triple& x, F&& f) const {
  if (!periodic_) return f(x);
  std::array<int, 3> reach{};
  for (std::size_t k = 0; k < dimension_; ++k) reach[k] = 1;
  for (int i = -reach[0]; i <= reach[0]; ++i)
    for (int j = -reach[1]; j <= reach[1]; ++j)
      for (int k = -reach[2]; k <= reach[2]; ++k)
        if (f(Triple{x[0] + i * edge_[0], x[1] + j * edge_[1], x[2] + k * edge_[2]})) return true;
  return false;
}

bool Enclosures::outside(const Round& round, const Triple& x) const {
  double square = 0;
  for (std::size_t k = 0; k < dimension_; ++k) square += (x[k] - round.centre[k]) * (x[k] - round.centre[k]);
  return square > round.radius * round.radius;
}

bool Enclosures::outside(const Bent& bent, const Triple& x) {
  const WallSpec& w = bent.wall;
  const double c = std::cos(w.angle.value), s = std::sin(w.angle.value), rx = x[0] - bent.centre[0], ry = x[1] - bent.centre[1];
  const double p = c * rx + s * ry, q = c * ry - s * rx;
  if (w.kind == WallKind::ellipse) {
    const double a = p / w.axes[0], b = q / w.axes[1];
    return a * a + b * b > 1;
  }
  const double theta = std::atan2(q, p);
  double r = 0;
  for (std::size_t k = 0; k < w.cosines.size(); ++k) r += w.cosines[k] * std::cos(static_cast<double>(k) * theta);
  for (std::size_t k = 0; k < w.sines.size(); ++k) r += w.sines[k] * std::sin(static_cast<double>(k) * theta);
  return std::hypot(p, q) > r;
}

bool Enclosures::inside(const Ring& ring, const Triple& x, double elapsed) const {
  return any_image(moved(x, ring.velocity, -elapsed), [&](const Triple& y) {
    bool odd = false;
    for (const Edge& e : ring.edges)
      if (crosses(y, e.from, e.to)) odd = !odd;
    return odd;
  });
}

bool Enclosures::escaped(std::uint32_t ball, const Triple& position, double elapsed) const {
  const auto beyond = [&](const HalfSpace& h) {
    const Triple x = moved(position, h.velocity, -elapsed);
    double depth = 0;
    for (std::size_t k = 0; k < dimension_; ++k) depth += h.normal[k] * (x[k] - h.point[k]);
    return depth < 0;
  };
  const auto past = [&](const Round& r) {
    const Triple x = moved(position, r.velocity, -elapsed);
    const bool within = any_image(x, [&](const Triple& y) { return !outside(r, y); });
    return within != r.inside;
  };
  const auto through = [&](const Bent& b) {
    const bool within =
        any_image(moved(position, b.velocity, -elapsed), [&](const Triple& y) { return !outside(b, y); });
    return within != (b.wall.side == WallSide::inside);
  };
  const auto across = [&](const Ring& r) { return inside(r, position, elapsed) != r.holds.at(ball); };
  return std::any_of(half_spaces_.begin(), half_spaces_.end(), beyond) ||
         std::any_of(rounds_.begin(), rounds_.end(), past) ||
         std::any_of(bents_.begin(), bents_.end(), through) || std::any_of(rings_.begin(), rings_.end(), across);
}

}  // namespace carom
