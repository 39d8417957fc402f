#pragma once
// The overlap functions of a system as polynomials of time [papers/certify/README.md, section 2].

#include <array>

#include "carom/certify/positivity.hpp"
#include "numbers.hpp"

namespace carom::certify {

/// A motion relative to something: y + u s + a s^2 / 2.
template <class I>
struct Relative {
  Triple<I> y, u, a;
  bool curved = false;  ///< a is not 0
};

template <class I>
class Gaps {
 public:
  using Period = std::array<std::int64_t, 3>;

  Gaps(const System& system, Numbers<I> numbers) : system_(system), n_(std::move(numbers)), d_(static_cast<std::size_t>(system.dimension)) {}

  [[nodiscard]] const Numbers<I>& numbers() const { return n_; }
  [[nodiscard]] bool falls(std::uint32_t i) const { return system_.accelerated() && !system_.balls[i].fixed; }

  /// The state of ball i at the point `at`.
  [[nodiscard]] State<I> state(std::uint32_t i, const Flight& f, const Enclosure& at) const {
    const I s = time_between<I>(f.reference, at);
    State<I> now = state_of<I>(f);
    for (std::size_t k = 0; k < d_; ++k) {
      if (falls(i)) {
        const I gain = n_.acceleration[k] * s;
        now.x[k] = now.x[k] + (now.v[k] + half(gain)) * s;
        now.v[k] = now.v[k] + gain;
      } else {
        now.x[k] = now.x[k] + now.v[k] * s;
      }
    }
    return now;
  }

  /// Ball j, so many periods on, relative to ball i.
  [[nodiscard]] Relative<I> between(std::uint32_t i, const State<I>& a, std::uint32_t j, const State<I>& b, const Period& period) const {
    Relative<I> r;
    r.curved = falls(i) != falls(j);
    for (std::size_t k = 0; k < d_; ++k) {
      r.y[k] = b.x[k] - a.x[k];
      if (period[k] != 0) r.y[k] = r.y[k] + I(static_cast<double>(period[k])) * n_.period[k];
      r.u[k] = b.v[k] - a.v[k];
      if (r.curved) r.a[k] = falls(j) ? n_.acceleration[k] : -n_.acceleration[k];
    }
    return r;
  }

  /// Ball i relative to the point of a piece at the moment `at`.
  [[nodiscard]] Relative<I> beside(std::uint32_t i, const State<I>& a, std::size_t piece, const Enclosure& at) const {
    const PieceNumbers<I>& p = n_.pieces[piece];
    Relative<I> r;
    r.curved = falls(i);
    r.y = a.x;
    r.u = a.v;
    const bool moves = !is_zero(system_.pieces[piece].velocity);
    for (std::size_t k = 0; k < d_; ++k) {
      r.y[k] = r.y[k] - p.point[k];
      if (moves) {
        r.y[k] = r.y[k] - p.velocity[k] * time_since_start(at);
        r.u[k] = r.u[k] - p.velocity[k];
      }
      if (r.curved) r.a[k] = n_.acceleration[k];
    }
    return r;
  }

  /// |y + u s + a s^2/2|^2 - reach^2.
  [[nodiscard]] Polynomial<I> round_gap(const Relative<I>& r, const I& reach) const {
    Polynomial<I> p(r.curved ? 5 : 3, I(0.0));
    p[0] = -square(reach);
    for (std::size_t k = 0; k < d_; ++k) {
      p[0] = p[0] + square(r.y[k]);
      p[1] = p[1] + I(2.0) * (r.y[k] * r.u[k]);
      p[2] = p[2] + square(r.u[k]);
      if (!r.curved) continue;
      p[2] = p[2] + r.y[k] * r.a[k];
      p[3] = p[3] + r.u[k] * r.a[k];
      p[4] = p[4] + half(half(square(r.a[k])));
    }
    return p;
  }

  /// n.(y + u s + a s^2/2) - reach.
  [[nodiscard]] Polynomial<I> flat_gap(const Relative<I>& r, const Triple<I>& n, const I& reach) const {
    Polynomial<I> p(r.curved ? 3 : 2, I(0.0));
    p[0] = -reach;
    for (std::size_t k = 0; k < d_; ++k) {
      p[0] = p[0] + n[k] * r.y[k];
      p[1] = p[1] + n[k] * r.u[k];
      if (r.curved) p[2] = p[2] + half(n[k] * r.a[k]);
    }
    return p;
  }

  [[nodiscard]] I reach_of_pair(std::uint32_t i, std::uint32_t j) const { return n_.radius[i] + n_.radius[j]; }

  /// In one dimension the balls keep their order: the gap of ball j on the right of ball i.
  [[nodiscard]] Polynomial<I> pair_gap(std::uint32_t i, std::uint32_t j, const Relative<I>& r) const {
    if (d_ > 1) return round_gap(r, reach_of_pair(i, j));
    return flat_gap(r, {I(1.0), I(0.0), I(0.0)}, reach_of_pair(i, j));
  }

  /// Of a ball and a plane, sphere or vertex.
  [[nodiscard]] Polynomial<I> piece_gap(std::uint32_t i, std::size_t piece, const Relative<I>& r) const {
    const PieceNumbers<I>& p = n_.pieces[piece];
    const Piece& q = system_.pieces[piece];
    if (q.kind == PieceKind::plane) return flat_gap(r, p.direction, n_.radius[i] * p.length);
    if (q.kind == PieceKind::sphere && q.inside) return negated(round_gap(r, p.radius - n_.radius[i]));
    return round_gap(r, q.kind == PieceKind::sphere ? I(p.radius + n_.radius[i]) : n_.radius[i]);
  }

  /// Height over an edge on one side of it (+1: left), less the ball's radius.
  [[nodiscard]] Polynomial<I> height(std::uint32_t i, std::size_t piece, const Relative<I>& r, int side) const {
    const PieceNumbers<I>& p = n_.pieces[piece];
    Triple<I> n = p.left;
    if (side < 0)
      for (I& c : n) c = -c;
    return flat_gap(r, n, n_.radius[i] * p.length);
  }
  /// How far before the beginning of an edge, and how far beyond its end (times its length).
  [[nodiscard]] Polynomial<I> before(std::size_t piece, const Relative<I>& r) const {
    return negated(flat_gap(r, n_.pieces[piece].direction, I(0.0)));
  }
  [[nodiscard]] Polynomial<I> beyond(std::size_t piece, const Relative<I>& r) const {
    return flat_gap(r, n_.pieces[piece].direction, n_.pieces[piece].square);
  }

 private:
  [[nodiscard]] I time_since_start(const Enclosure& at) const {
    I s;
    convert(at, s);
    return s - n_.start;
  }

  const System& system_;
  Numbers<I> n_;
  std::size_t d_;
};

}  // namespace carom::certify
