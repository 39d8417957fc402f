#include "impact.hpp"

#include <utility>

namespace carom::certify {

namespace {

Share share_of(const Rational& takes) { return {Enclosure::of(takes), Enclosure::of(Rational(1 - takes))}; }

/// m_other / (m_own + m_other); none is infinite.
Rational weight(const std::optional<Rational>& own, const std::optional<Rational>& other) {
  if (!own) return 0;
  if (!other) return 1;
  return *other / (*own + *other);
}

}  // namespace

Impacts::Impacts(const System& system, const Gaps<Enclosure>& gaps)
    : system_(system), gaps_(gaps), d_(static_cast<std::size_t>(system.dimension)) {
  std::map<std::pair<std::optional<Rational>, std::uint32_t>, std::uint32_t> kinds;
  std::vector<std::pair<std::optional<Rational>, std::uint32_t>> list;
  for (const SystemBall& b : system.balls) {
    const auto [at, fresh] = kinds.try_emplace({b.mass, b.material}, static_cast<std::uint32_t>(list.size()));
    if (fresh) list.push_back(at->first);
    kind_.push_back(at->second);
  }
  for (const auto& [mass, material] : list) {
    std::vector<Share>& row = shares_.emplace_back();
    for (const auto& [other, its_material] : list)
      row.push_back(share_of(Rational((1 + system.restitution[material][its_material]) * weight(mass, other))));
  }
  for (const std::vector<Rational>& restitution : system.at_wall) {
    std::vector<Share>& row = wall_shares_.emplace_back();
    for (const Rational& e : restitution) row.push_back(share_of(Rational(1 + e)));
  }
}

const Share& Impacts::share(std::uint32_t own, std::uint32_t other) const { return shares_[kind_[own]][kind_[other]]; }

bool Impacts::plastic_pair(std::uint32_t i, std::uint32_t j) const {
  return system_.restitution[system_.balls[i].material][system_.balls[j].material] == 0;
}
bool Impacts::plastic_wall(std::uint32_t i, std::size_t piece) const {
  return system_.at_wall[system_.balls[i].material][system_.pieces[piece].wall] == 0;
}

/// n n^T / length_squared.
Impacts::Matrix Impacts::along(const Triple<Enclosure>& n, const Enclosure& length_squared) const {
  Matrix m;
  for (std::size_t k = 0; k < d_; ++k)
    for (std::size_t l = k; l < d_; ++l) m[l][k] = m[k][l] = (k == l ? square(n[k]) : n[k] * n[l]) / length_squared;
  return m;
}

void Impacts::pair(std::uint32_t i, State<Enclosure>& a, std::uint32_t j, State<Enclosure>& b,
                   const std::array<std::int64_t, 3>& period, const Contact& contact) const {
  const Relative<Enclosure> r = gaps_.between(i, a, j, b, period);
  const Enclosure& s = contact.offset;
  if (d_ == 1) return pair_on_a_line(i, a, j, b, r, period[0], s);
  const State<Enclosure> ma = middle_of(a, d_), mb = middle_of(b, d_);
  const State<Enclosure> da = difference(a, ma, d_), db = difference(b, mb, d_);
  const Jump jump(gaps_, d_, r, gaps_.between(i, ma, j, mb, period), gaps_.reach_of_pair(i, j), s);
  const Share &of_a = share(i, j), &of_b = share(j, i);
  apply(jump, of_a.takes, ma, da, db, false, a);
  apply(jump, of_b.takes, mb, db, da, true, b);
}

/// v + c h and x - c g at the middle, and the derivative over the box: own differences from the middle enter with 1 - c,
/// those of the other with c. For either ball: exchanging the two turns y, u, h and g round, and leaves their derivatives.
void Impacts::apply(const Jump& jump, const Enclosure& takes, const State<Enclosure>& middle, const State<Enclosure>& own,
                    const State<Enclosure>& other, bool turned, State<Enclosure>& to) const {
  for (std::size_t k = 0; k < d_; ++k) {
    const Enclosure kick = takes * jump.h[k], shift = takes * jump.g[k];
    to.v[k] = turned ? middle.v[k] - kick : middle.v[k] + kick;
    to.x[k] = turned ? middle.x[k] + shift : middle.x[k] - shift;
    for (std::size_t l = 0; l < d_; ++l) {
      const Enclosure one(k == l ? 1.0 : 0.0);
      const Enclosure vy = takes * jump.h_y[k][l], vu = takes * jump.h_u[k][l];
      const Enclosure xy = takes * jump.g_y[k][l], xu = takes * jump.g_u[k][l];
      to.v[k] = to.v[k] + (one - vu) * own.v[l] + vu * other.v[l] + vy * (other.x[l] - own.x[l]);
      to.x[k] = to.x[k] + (one + xy) * own.x[l] - xy * other.x[l] - xu * (other.v[l] - own.v[l]);
    }
  }
}

/// On a line the impact is linear in the states at any one moment, so no time enters: x' = (1 - c) x + c (y - sigma).
void Impacts::pair_on_a_line(std::uint32_t i, State<Enclosure>& a, std::uint32_t j, State<Enclosure>& b,
                             const Relative<Enclosure>& r, std::int64_t period, const Enclosure& s) const {
  const Share &of_a = share(i, j), &of_b = share(j, i);
  const Enclosure offset = Enclosure(static_cast<double>(period)) * gaps_.numbers().period[0] - gaps_.reach_of_pair(i, j);
  const Enclosure xa = a.x[0], va = a.v[0];
  a.x[0] = of_a.keeps * xa + of_a.takes * (b.x[0] + offset);
  a.v[0] = of_a.keeps * va + of_a.takes * b.v[0];
  b.x[0] = of_b.keeps * b.x[0] + of_b.takes * (xa - offset);
  b.v[0] = of_b.keeps * b.v[0] + of_b.takes * va;
  if (!r.curved) return;
  const Enclosure gain = r.a[0] * s, shift = half(r.a[0]) * square(s);
  a.x[0] = a.x[0] - of_a.takes * shift;
  a.v[0] = a.v[0] + of_a.takes * gain;
  b.x[0] = b.x[0] + of_b.takes * shift;
  b.v[0] = b.v[0] - of_b.takes * gain;
}

void Impacts::wall(std::uint32_t i, State<Enclosure>& a, std::size_t piece, int side, const Contact& contact) const {
  const Piece& kind = system_.pieces[piece];
  if (kind.kind == PieceKind::plane || kind.kind == PieceKind::edge) return flat_wall(i, a, piece, side, contact);
  const PieceNumbers<Enclosure>& p = gaps_.numbers().pieces[piece];
  const Relative<Enclosure> r = gaps_.beside(i, a, piece, contact.base);
  const Enclosure radius = gaps_.numbers().radius[i];
  const Enclosure reach = kind.kind == PieceKind::vertex ? radius : kind.inside ? p.radius - radius : p.radius + radius;
  const State<Enclosure> middle = middle_of(a, d_);
  const Jump jump(gaps_, d_, r, gaps_.beside(i, middle, piece, contact.base), reach, contact.offset);
  apply(jump, wall_shares_[system_.balls[i].material][kind.wall].takes, middle, difference(a, middle, d_), State<Enclosure>{}, true, a);
}

/// A flat wall reflects the states at any one moment: x' = x - c n (n.(x - p) - r), but for the acceleration's share.
void Impacts::flat_wall(std::uint32_t i, State<Enclosure>& a, std::size_t piece, int side, const Contact& contact) const {
  const PieceNumbers<Enclosure>& p = gaps_.numbers().pieces[piece];
  const bool edge = system_.pieces[piece].kind == PieceKind::edge;
  Triple<Enclosure> n = edge ? p.left : p.direction;
  if (side < 0)
    for (Enclosure& c : n) c = -c;
  const Matrix m = along(n, p.square);
  const Enclosure& takes = wall_shares_[system_.balls[i].material][system_.pieces[piece].wall].takes;
  const bool moves = !is_zero(system_.pieces[piece].velocity);
  const Enclosure& s = contact.offset;
  Enclosure reach = gaps_.numbers().radius[i] * p.length;
  if (gaps_.falls(i))
    for (std::size_t k = 0; k < d_; ++k) reach = reach + n[k] * gaps_.numbers().acceleration[k] * half(square(s));
  const State<Enclosure> a0 = a;
  for (std::size_t k = 0; k < d_; ++k) {
    a.x[k] = takes * n[k] * reach / p.square;
    a.v[k] = Enclosure();
    for (std::size_t l = 0; l < d_; ++l) {
      const Enclosure c = takes * m[k][l], keeps = Enclosure(k == l ? 1.0 : 0.0) - c;
      Enclosure point = p.point[l];
      if (moves) {
        point = point + p.velocity[l] * (contact.base - gaps_.numbers().start);
        a.v[k] = a.v[k] + c * p.velocity[l];
      }
      a.x[k] = a.x[k] + keeps * a0.x[l] + c * point;
      a.v[k] = a.v[k] + keeps * a0.v[l];
      if (gaps_.falls(i)) a.v[k] = a.v[k] - c * (gaps_.numbers().acceleration[l] * s);
    }
  }
}

}  // namespace carom::certify
