#pragma once
// Uniform acceleration: parabolas, the same acceleration for every ball that is not fixed.

#include "carom/core/vec.hpp"

namespace carom {

/// x(s) = x + s (v + a s / 2), v(s) = v + a s.
template <class RealType, int Dimension>
struct UniformAcceleration {
  using Real = RealType;
  static constexpr int dimension = Dimension;
  static constexpr bool accelerated = true;
  static constexpr bool can_rest = false;
  static constexpr bool circular = false;
  static constexpr const char* name = "uniform acceleration";
  using Vector = Vec<Real, Dimension>;
  using Phase = bool;  ///< fixed: never moves

  template <class Ball>
  [[nodiscard]] static Phase phase(const Ball& ball) {
    return ball.fixed;
  }

  Vector a = Vector::Zero();  ///< [length unit / L^2]

  [[nodiscard]] Vector position(const Vector& x, const Vector& v, bool fixed, const Real& s) const {
    if (fixed) return x;
    return x + (v + a * (s / 2)) * s;
  }
  [[nodiscard]] Vector velocity(const Vector& v, bool fixed, const Real& s) const {
    if (fixed) return v;
    return v + a * s;
  }
  /// What is stored when the motion changes: each component rounded once, so that the sum of kinetic and potential energy has
  /// no bias from flight to flight.
  [[nodiscard]] Vector stored_position(const Vector& x, const Vector& v, bool fixed, const Real& s) const {
    if (fixed) return x;
    using W = Wide<Real>;
    const W half_square = wide_product<Real>(s, s) * W(Real(1) / 2);
    Vector there;
    for (int k = 0; k < Dimension; ++k)
      there[k] = narrow(W(W(x[k]) + (wide_product<Real>(v[k], s) + W(a[k]) * half_square)));
    return there;
  }
  [[nodiscard]] Vector stored_velocity(const Vector& v, bool fixed, const Real& s) const {
    if (fixed) return v;
    Vector then;
    for (int k = 0; k < Dimension; ++k) then[k] = narrow(Wide<Real>(Wide<Real>(v[k]) + wide_product<Real>(a[k], s)));
    return then;
  }
  [[nodiscard]] Vector acceleration(bool fixed) const { return fixed ? Vector(Vector::Zero()) : a; }
};

}  // namespace carom
