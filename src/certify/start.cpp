#include "start.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "carom/certify/outward.hpp"

namespace carom::certify {

namespace {

Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// The share of the squares in play below which a gap of doubles counts as contact.
const Rational rounding_of_doubles(1, boost::multiprecision::cpp_int(1) << 46);

/// f = |r|^2 - sigma^2 (or n.r - r |n|) <= doubt.
bool touches(const Rational& square, const Rational& reach, bool doubles) {
  return square - reach * reach <= (doubles ? Rational((square + reach * reach) * rounding_of_doubles) : Rational(0));
}

/// n.x <= r |n| without a root: the squares are compared.
bool touches_plane(const Rational& along, const Rational& radius, const Rational& n2, bool doubles) {
  if (along <= 0) return true;
  return touches(Rational(along * along / n2), radius, doubles);
}

bool touches_piece(const Piece& p, const SystemBall& b, bool doubles) {
  const Vector r = b.position - p.point;
  switch (p.kind) {
    case PieceKind::plane:
      return touches_plane(dot(p.direction, r), b.radius, dot(p.direction, p.direction), doubles);
    case PieceKind::sphere:
      if (!p.inside) return touches(dot(r, r), Rational(p.radius + b.radius), doubles);
      return p.radius <= b.radius ||
             (p.radius - b.radius) * (p.radius - b.radius) - dot(r, r) <=
                 (doubles ? Rational(p.radius * p.radius * rounding_of_doubles) : Rational(0));
    case PieceKind::vertex:
      return touches(dot(r, r), b.radius, doubles);
    case PieceKind::edge: {
      const Rational along = dot(p.direction, r), length = dot(p.direction, p.direction);
      if (along < 0 || along > length) return false;
      const Vector left{-p.direction[1], p.direction[0], 0};
      const Rational height = dot(left, r);
      return touches(Rational(height * height / length), b.radius, doubles);
    }
  }
  return false;
}

/// Of all images of b, the one nearest along an axis, and its neighbours: the gap of the nearest of them.
bool pair_touches(const System& s, const SystemBall& a, const SystemBall& b, bool doubles) {
  const Rational reach = a.radius + b.radius;
  const auto d = static_cast<std::size_t>(s.dimension);
  if (d > 1 && reach == 0) return false;
  Vector r = b.position - a.position;
  if (s.period)
    for (std::size_t k = 0; k < d; ++k) {
      const Rational turns = r[k] / (*s.period)[k] + Rational(1, 2);
      boost::multiprecision::cpp_int whole = numerator(turns) / denominator(turns);
      if (Rational(whole) > turns) --whole;
      r[k] -= Rational(whole) * (*s.period)[k];
    }
  return touches(dot(r, r), reach, doubles);
}

/// Surely farther apart than contact or its doubt, seen in doubles: most pairs are. Open space only.
bool surely_apart(const SystemBall& a, const SystemBall& b, std::size_t dimension) {
  const auto near = [](const Rational& r) {
    const double x = nearest_double(r);
    return Outward(below(x), above(x));
  };
  const Outward reach = near(a.radius) + near(b.radius);
  Outward gap = -(square(reach) * Outward(1.0 + 0x1p-20));
  for (std::size_t k = 0; k < dimension; ++k) gap = gap + square(near(b.position[k]) - near(a.position[k]));
  return is_positive(gap);
}

}  // namespace

std::string contact_at_the_start(const System& s, std::size_t written) {
  for (std::size_t i = 0; i < s.balls.size(); ++i) {
    const SystemBall& a = s.balls[i];
    if (s.period && std::any_of(s.period->begin(), s.period->begin() + s.dimension, [&](const Rational& l) { return l <= 2 * a.radius; }))
      return fmt::format("ball {} starts in contact with its own periodic image", i);
    for (std::size_t j = i + 1; j < s.balls.size(); ++j) {
      const SystemBall& b = s.balls[j];
      if (!s.period && surely_apart(a, b, static_cast<std::size_t>(s.dimension))) continue;
      if (!(a.fixed && b.fixed) && pair_touches(s, a, b, i >= written || j >= written))
        return fmt::format("ball {} and ball {} start in contact", i, j);
    }
    if (a.fixed) continue;
    for (const Piece& p : s.pieces)
      if (touches_piece(p, a, i >= written)) return fmt::format("ball {} starts in contact with wall {}", i, s.walls[p.wall]);
  }
  return "";
}

}  // namespace carom::certify
