#pragma once
// Paths of a ball's centre past a traced curve: parabolas, and circles in a magnetic field.

#include <cmath>

#include "carom/core/real.hpp"
#include "carom/core/vec.hpp"
#include "carom/solve/gap.hpp"
#include "carom/solve/harmonic.hpp"

namespace carom {

/// x + v t + a t^2 / 2, relative to the centre of a curve.
template <class Real>
struct ParabolicPath {
  Vec<Real, 2> x, v, a;

  [[nodiscard]] Vec<Real, 2> at(const Real& t) const { return x + (v + a * (t / 2)) * t; }
  [[nodiscard]] Vec<Real, 2> velocity(const Real& t) const { return v + a * t; }
  [[nodiscard]] Vec<Real, 2> acceleration() const { return a; }
  /// Size of the acceleration.
  [[nodiscard]] Real bend() const {
    using std::sqrt;
    return sqrt(dot<Real, 2>(a, a));
  }
  /// It comes to no place a second time.
  [[nodiscard]] Real period() const { return never<Real>(); }
  /// First time >= t at which n.x has come down by `gap`.
  [[nodiscard]] Real down_by(const Real& t, const Vec<Real, 2>& n, const Real& gap) const {
    const Real fall = first_fall(gap, dot<Real, 2>(n, velocity(t)), Real(dot<Real, 2>(n, a) / 2));
    return fall == never<Real>() ? fall : Real(t + fall);
  }
};

/// The circle that a ball flies which is at x with velocity v at first; x relative to the centre of a curve
/// [papers/magnetic.md, eq. 1, 2].
template <class M>
struct CircularPath {
  using Real = typename M::Real;

  const M& motion;
  Vec<Real, 2> x, v;

  [[nodiscard]] Vec<Real, 2> at(const Real& t) const {
    using std::cos;
    using std::sin;
    const Real h = motion.omega * t / 2, s = sin(h), size = 2 * s / motion.omega, along = size * cos(h), across = size * s;
    return Vec<Real, 2>(x[0] + (along * v[0] - across * v[1]), x[1] + (along * v[1] + across * v[0]));
  }
  [[nodiscard]] Vec<Real, 2> velocity(const Real& t) const {
    using std::cos;
    using std::sin;
    const Real turned = motion.omega * t, c = cos(turned), s = sin(turned);
    return Vec<Real, 2>(c * v[0] - s * v[1], c * v[1] + s * v[0]);
  }
  [[nodiscard]] Vec<Real, 2> acceleration() const { return motion.turned(v) * motion.speed(); }
  [[nodiscard]] Real bend() const {
    using std::sqrt;
    return motion.speed() * sqrt(dot<Real, 2>(v, v));
  }
  /// After it everything is as it was.
  [[nodiscard]] Real period() const {
    using std::atan;
    return 8 * atan(Real(1)) / motion.speed();
  }
  [[nodiscard]] Real down_by(const Real& t, const Vec<Real, 2>& n, const Real& gap) const {
    const Vec<Real, 2> then = velocity(t);
    const Real fall = first_fall(motion.line_gap(gap, dot<Real, 2>(n, then), dot<Real, 2>(n, motion.turned(then))));
    return fall == never<Real>() ? fall : Real(t + fall);
  }
};

}  // namespace carom
