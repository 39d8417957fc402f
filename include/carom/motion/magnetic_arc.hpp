#pragma once
// Circles in a magnetic field across the plane: every ball that is not fixed turns at the same cyclotron frequency.

#include <cmath>

#include "carom/core/vec.hpp"
#include "carom/solve/harmonic.hpp"

namespace carom {

/// x(s) = x + (2 / omega) sin(h) R(h) v, v(s) = R(2 h) v, h = omega s / 2, R(h) the rotation by h [papers/magnetic.md,
/// eq. 1, 2]. The velocity is rotated by a unit vector that is exact to 2^-100, and each component rounded once: its size
/// does not drift, it walks by about 3e-17 of itself a flight. The angle is that of sine and cosine of the machine's own
/// library, within 2 u of the turn.
///
/// The distance of two balls, fixed ones too, is itself that of one circular motion: a ball at rest stays at rest.
template <class RealType>
struct MagneticArc {
  using Real = RealType;
  static constexpr int dimension = 2;
  static constexpr bool accelerated = false;
  static constexpr bool can_rest = false;
  static constexpr bool circular = true;
  static constexpr const char* name = "circles in a magnetic field";
  using Vector = Vec<Real, 2>;
  using Phase = bool;  ///< fixed: never moves

  template <class Ball>
  [[nodiscard]] static Phase phase(const Ball& ball) {
    return ball.fixed;
  }

  Real omega = Real(1);  ///< [rad / L] > 0: anticlockwise

  [[nodiscard]] Vector position(const Vector& x, const Vector& v, bool fixed, const Real& s) const {
    if (fixed) return x;
    const HalfTurn h = half_turn(s);
    const Real size = 2 * h.sine / omega;
    const Real along = size * h.cosine, across = size * h.sine;
    Vector there;
    there[0] = narrow(W(W(x[0]) + (wide_product<Real>(along, v[0]) - wide_product<Real>(across, v[1]))));
    there[1] = narrow(W(W(x[1]) + (wide_product<Real>(along, v[1]) + wide_product<Real>(across, v[0]))));
    return there;
  }
  [[nodiscard]] Vector velocity(const Vector& v, bool fixed, const Real& s) const {
    if (fixed) return v;
    const HalfTurn h = half_turn(s);
    const W ss = wide_product<Real>(h.sine, h.sine), cc = wide_product<Real>(h.cosine, h.cosine);
    const W excess = W(cc + ss) - W(Real(1));  // of the squared length of (cosine, sine)
    const W unit = W(Real(1)) - excess;        // 1 / (1 + excess): excess is a few u
    const W cosine = W(cc - ss) * unit, sine = W(wide_product<Real>(h.sine, h.cosine) * Real(2)) * unit;
    Vector then;
    then[0] = narrow(W(cosine * W(v[0]) - sine * W(v[1])));
    then[1] = narrow(W(cosine * W(v[1]) + sine * W(v[0])));
    return then;
  }
  [[nodiscard]] Vector stored_position(const Vector& x, const Vector& v, bool fixed, const Real& s) const {
    return position(x, v, fixed, s);
  }
  [[nodiscard]] Vector stored_velocity(const Vector& v, bool fixed, const Real& s) const { return velocity(v, fixed, s); }
  /// None but the field's, which is omega x v.
  [[nodiscard]] Vector acceleration(bool) const { return Vector::Zero(); }

  /// Angular speed [rad / L], > 0.
  [[nodiscard]] Real speed() const { return omega < 0 ? Real(-omega) : omega; }
  /// v turned by a right angle in the sense in which the balls turn.
  [[nodiscard]] Vector turned(const Vector& v) const {
    return omega < 0 ? Vector(v[1], Real(-v[0])) : Vector(Real(-v[1]), v[0]);
  }
  /// The field is turned round too when time is.
  void reverse() { omega = -omega; }

  /// Height n.(x + ...) over a line, less `gap_now - height`, on the arc that begins with velocity v; n a unit vector.
  [[nodiscard]] ArcGap<Real> line_gap(const Real& gap_now, const Real& rate, const Real& turned_rate) const {
    return {speed(), W(gap_now), W(rate), W(wide_product<Real>(turned_rate, speed()) * (Real(1) / 2))};
  }
  /// |r|^2 - sigma^2 on the arc of a relative position r that begins with relative velocity v.
  [[nodiscard]] ArcGap<Real> circle_gap(const Vector& r, const Vector& v, const Real& sigma) const {
    const W across = wide_dot<Real, 2>(r, turned(v));
    return {speed(), W(wide_dot<Real, 2>(r, r) - wide_product<Real>(sigma, sigma)), W(wide_dot<Real, 2>(r, v) * Real(2)),
            W(wide_dot<Real, 2>(v, v) + across * W(speed()))};
  }

 private:
  using W = Wide<Real>;

  struct HalfTurn {
    Real sine, cosine;
  };
  /// Of omega s / 2, the product taken without rounding.
  [[nodiscard]] HalfTurn half_turn(const Real& s) const {
    using std::cos;
    using std::sin;
    const W h = wide_product<Real>(Real(omega / 2), s);
    const Real angle = narrow(h), rest = narrow(W(h - W(angle)));
    const Real sine = sin(angle), cosine = cos(angle);
    return {Real(sine + rest * cosine), Real(cosine - rest * sine)};
  }
};

}  // namespace carom
