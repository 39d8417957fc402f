#include "tie.hpp"

#include <algorithm>

namespace carom::certify {

namespace {

using boost::multiprecision::cpp_int;

Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

std::optional<Rational> exact_root(const Rational& square) {
  if (square < 0) return std::nullopt;
  const cpp_int n = sqrt(cpp_int(numerator(square))), d = sqrt(cpp_int(denominator(square)));
  if (n * n != numerator(square) || d * d != denominator(square)) return std::nullopt;
  return Rational(n, d);
}

/// The first root of c0 + c1 t + c2 t^2 with c0 > 0 at which it falls, if that is a rational.
std::optional<Rational> rational_root(const std::vector<Rational>& p) {
  if (p.size() < 2 || p.size() > 3) return std::nullopt;
  const Rational c2 = p.size() == 3 ? p[2] : Rational(0);
  const auto root = exact_root(Rational(p[1] * p[1] - 4 * c2 * p[0]));
  if (!root) return std::nullopt;
  const Rational below = *root - p[1];
  if (below == 0) return std::nullopt;
  return Rational(2 * p[0] / below);
}

std::vector<Rational> round_gap(const Vector& y, const Vector& u, const Vector& a, const Rational& reach) {
  return {dot(y, y) - reach * reach, 2 * dot(y, u), dot(u, u) + dot(y, a), dot(u, a), dot(a, a) / 4};
}
std::vector<Rational> flat_gap(const Vector& n, const Vector& y, const Vector& u, const Vector& a, const Rational& reach) {
  return {dot(n, y) - reach, dot(n, u), dot(n, a) / 2};
}

void trim(std::vector<Rational>& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

}  // namespace

std::vector<Rational> exact_gap(const System& s, const FirstMeeting& m) {
  const SystemBall& a = s.balls[m.ball];
  const Vector fall = a.fixed ? Vector{} : s.acceleration;
  Vector y, u, pull;
  std::vector<Rational> gap;
  if (!m.piece) {
    const SystemBall& b = s.balls[m.partner];
    for (std::size_t k = 0; k < 3; ++k) {
      y[k] = b.position[k] - a.position[k];
      if (s.period) y[k] += m.period[k] * (*s.period)[k];
      u[k] = b.velocity[k] - a.velocity[k];
      pull[k] = (b.fixed ? Rational(0) : s.acceleration[k]) - fall[k];
    }
    const Rational reach = a.radius + b.radius;
    const Vector right{y[0] > 0 ? 1 : -1, 0, 0};
    gap = s.dimension == 1 ? flat_gap(right, y, u, pull, reach) : round_gap(y, u, pull, reach);
  } else {
    const Piece& p = s.pieces[*m.piece];
    for (std::size_t k = 0; k < 3; ++k) {
      y[k] = a.position[k] - p.point[k];
      u[k] = a.velocity[k] - p.velocity[k];
    }
    const bool is_flat = p.kind == PieceKind::plane || p.kind == PieceKind::edge;
    if (is_flat) {
      const auto length = exact_root(dot(p.direction, p.direction));
      if (!length) return {};
      Vector n = p.kind == PieceKind::plane ? p.direction : Vector{-p.direction[1], p.direction[0], 0};
      for (Rational& c : n) c /= *length;
      if (p.kind == PieceKind::edge && dot(n, y) < 0)
        for (Rational& c : n) c = -c;
      gap = flat_gap(n, y, u, fall, a.radius);
    } else {
      const Rational radius = p.kind == PieceKind::sphere ? p.radius : Rational(0);
      gap = round_gap(y, u, fall, p.inside ? Rational(radius - a.radius) : Rational(radius + a.radius));
      if (p.inside)
        for (Rational& c : gap) c = -c;
    }
  }
  trim(gap);
  return gap;
}

bool same_time(const std::vector<Rational>& p, const std::vector<Rational>& q) {
  if (p.empty() || q.empty() || p[0] <= 0 || q[0] <= 0) return false;
  bool multiple = p.size() == q.size();
  for (std::size_t k = 0; multiple && k < p.size(); ++k) multiple = p[k] * q[0] == q[k] * p[0];
  if (multiple) return true;
  const auto t = rational_root(p), s = rational_root(q);
  return t && s && *t == *s;
}

}  // namespace carom::certify
