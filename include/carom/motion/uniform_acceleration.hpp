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
  static constexpr const char* name = "uniform acceleration";
  using Vector = Vec<Real, Dimension>;

  Vector a = Vector::Zero();  ///< [length unit / L^2]

  [[nodiscard]] Vector position(const Vector& x, const Vector& v, bool fixed, const Real& s) const {
    if (fixed) return x;
    return x + (v + a * (s / 2)) * s;
  }
  [[nodiscard]] Vector velocity(const Vector& v, bool fixed, const Real& s) const {
    if (fixed) return v;
    return v + a * s;
  }
  [[nodiscard]] Vector acceleration(bool fixed) const { return fixed ? Vector(Vector::Zero()) : a; }
};

}  // namespace carom
