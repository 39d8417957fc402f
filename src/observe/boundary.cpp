#include "carom/observe/boundary.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace carom {

namespace {

constexpr double turn = 2 * std::numbers::pi;

bool is_fixed(const Scene& scene, std::uint32_t ball) { return ball < scene.balls.size() && scene.balls[ball].fixed; }

std::int32_t pieces_of(const WallSpec& w) {
  return w.kind == WallKind::polygon ? static_cast<std::int32_t>(w.vertices.size()) : 1;
}

double dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1]; }

}  // namespace

std::string Boundary::refusal(const Scene& scene, const Subject& subject) {
  if (subject.dimension != 2) return "arclengths are those of two dimensions";
  for (const WallSpec& w : scene.walls) {
    if (w.kind == WallKind::plane) return "a plane has no end";
    if (w.kind == WallKind::parabola && !(w.half_width > 0)) return "a parabola without ends has no length";
  }
  if (subject.walls == 0 && subject.space != SpaceKind::box && !subject.has_obstacles())
    return "there are neither walls nor fixed balls";
  return "";
}

void Boundary::add(std::uint32_t wall, std::int32_t feature, double length) {
  pieces_.push_back({wall, feature, length, length_});
  length_ += length;
}

Boundary::Boundary(const Scene& scene, const Simulation& simulation) {
  walls_ = simulation.wall_count();
  const auto own = static_cast<std::uint32_t>(scene.walls.size());
  for (std::uint32_t w = 0; w < own; ++w) {
    first_piece_.push_back(pieces_.size());
    features_.push_back(pieces_of(scene.walls[w]));
    for (std::int32_t f = 0; f < features_.back(); ++f) add(w, f, scene.walls[w].opening ? 0.0 : wall_length(scene.walls[w], f));
  }
  face_piece_ = pieces_.size();
  if (walls_ > own) {  // numbered x-, x+, y-, y+
    const double width = scene.space.upper[0] - scene.space.lower[0], height = scene.space.upper[1] - scene.space.lower[1];
    add(own + 2, 0, width);
    add(own + 1, 0, height);
    add(own + 3, 0, width);
    add(own, 0, height);
  }
  for (std::uint32_t i = 0; i < simulation.ball_count(); ++i) {
    if (!is_fixed(scene, i)) continue;
    rim_.resize(simulation.ball_count(), 0);
    radius_.resize(simulation.ball_count(), 0.0);
    rim_[i] = pieces_.size();
    radius_[i] = simulation.glimpse(i).radius;
    add(walls_ + i, 0, turn * radius_[i]);
  }
}

std::size_t Boundary::piece_of(const Collision& c, std::uint32_t wall, double& along) const {
  along = c.arclength;
  if (wall >= first_piece_.size()) {
    const std::uint32_t face = wall - static_cast<std::uint32_t>(first_piece_.size());
    constexpr std::array<std::size_t, 4> place{3, 1, 0, 2};
    return face_piece_ + place[face];
  }
  const std::size_t first = first_piece_[wall];
  const std::int32_t count = features_[wall];
  if (c.feature < count) return first + static_cast<std::size_t>(c.feature);
  const std::int32_t corner = c.feature - count;  // of a polygon: where that edge begins; of a segment: its ends
  along = count == 1 && corner > 0 ? pieces_[first].length : 0.0;
  return first + (count == 1 ? 0 : static_cast<std::size_t>(corner % count));
}

std::optional<Bounce> Boundary::bounce(const Collision& c, const Subject& subject) const {
  Bounce b;
  Triple n = c.normal;  // from the boundary to the ball
  Triple u;
  for (std::size_t k = 0; k < 3; ++k) u[k] = c.ball.velocity_before[k] - c.partner.velocity_before[k];
  b.ball = c.ball.number;
  if (c.kind == EventKind::ball_ball) {
    const bool first = !subject.moves_freely(c.ball.number);
    if (subject.moves_freely(c.ball.number) && subject.moves_freely(c.partner.number)) return std::nullopt;
    const std::uint32_t fixed = first ? c.ball.number : c.partner.number;
    if (fixed >= rim_.size() || radius_[fixed] == 0) return std::nullopt;
    if (first) {
      b.ball = c.partner.number;
      for (std::size_t k = 0; k < 3; ++k) {
        n[k] = -n[k];
        u[k] = -u[k];
      }
    }
    double angle = std::atan2(n[1], n[0]);
    if (angle < 0) angle += turn;
    b.piece = rim_[fixed];
    b.arclength = pieces_[b.piece].begin + radius_[fixed] * angle;
  } else {
    double along = 0;
    b.piece = piece_of(c, c.partner.number, along);
    b.arclength = pieces_[b.piece].begin + along;
  }
  const double speed = std::sqrt(dot(u, u));
  b.sine = speed > 0 ? (u[0] * n[1] - u[1] * n[0]) / speed : 0.0;
  return b;
}

namespace {

double distance(const Coordinates& a, const Coordinates& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

/// 4 a E(e) = 2 pi (a^2 - sum 2^(n - 1) c_n^2) / M(a, b), c_0^2 = a^2 - b^2. The means converge quadratically: the iteration stops
/// where a and b are the same to a rounding.
double ellipse_length(double a, double b) {
  double c2 = (a - b) * (a + b), sum = a * a - c2 / 2, power = 1;
  for (int n = 0; n < 40 && std::abs(a - b) > 1e-16 * a; ++n) {
    const double mean = (a + b) / 2, half = (a - b) / 2;
    b = std::sqrt(a * b);
    a = mean;
    c2 = half * half;
    sum -= power * c2;
    power *= 2;
  }
  return turn * sum / a;
}

double curve_length(const WallSpec& w) {
  const auto sum_at = [&](int points, double shift) {
    double sum = 0;
    for (int i = 0; i < points; ++i) {
      const double theta = turn * (i + shift) / points;
      double r = 0, slope = 0;
      for (std::size_t k = 0; k < w.cosines.size(); ++k) {
        const double n = static_cast<double>(k);
        r += w.cosines[k] * std::cos(n * theta);
        slope -= n * w.cosines[k] * std::sin(n * theta);
      }
      for (std::size_t k = 0; k < w.sines.size(); ++k) {
        const double n = static_cast<double>(k);
        r += w.sines[k] * std::sin(n * theta);
        slope += n * w.sines[k] * std::cos(n * theta);
      }
      sum += std::hypot(r, slope);
    }
    return sum;
  };
  // Equal steps over a whole turn of a smooth curve: the error falls geometrically, and twice the points stop at rounding.
  int points = 256;
  double sum = sum_at(points, 0), length = turn * sum / points;
  while (points < 1 << 20) {
    sum += sum_at(points, 0.5);
    points *= 2;
    const double next = turn * sum / points;
    if (std::abs(next - length) <= 1e-15 * next) return next;
    length = next;
  }
  return length;
}

}  // namespace

double wall_length(const WallSpec& w, std::int32_t feature) {
  switch (w.kind) {
    case WallKind::segment:
      return distance(w.from, w.to);
    case WallKind::polygon: {
      const auto k = static_cast<std::size_t>(feature);
      return distance(w.vertices[k], w.vertices[(k + 1) % w.vertices.size()]);
    }
    case WallKind::circle:
      return turn * w.radius;
    case WallKind::arc: {
      const double angle = w.to_angle - w.from_angle;
      return w.radius * (angle > 0 ? angle : angle + turn);
    }
    case WallKind::ellipse:
      return ellipse_length(w.axes[0], w.axes[1]);
    case WallKind::parabola: {  // s = 2 f (z sqrt(1 + z^2) + asinh z), y = 2 f z
      const double z = w.half_width / (2 * w.focal_length);
      return 2 * w.focal_length * (z * std::sqrt(1 + z * z) + std::asinh(z));
    }
    case WallKind::curve:
      return curve_length(w);
    case WallKind::plane:
      break;
  }
  return HUGE_VAL;
}

}  // namespace carom
