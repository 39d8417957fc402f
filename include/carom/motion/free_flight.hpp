#pragma once
// Free flight: straight lines at constant velocity.

#include "carom/core/vec.hpp"

namespace carom {

/// x(s) = x + v s, v(s) = v.
template <class RealType, int Dimension>
struct FreeFlight {
  using Real = RealType;
  static constexpr int dimension = Dimension;
  static constexpr bool accelerated = false;
  static constexpr bool can_rest = false;
  static constexpr bool circular = false;
  static constexpr const char* name = "free flight";
  using Vector = Vec<Real, Dimension>;
  using Phase = bool;  ///< fixed: never moves

  template <class Ball>
  [[nodiscard]] static Phase phase(const Ball& ball) {
    return ball.fixed;
  }

  [[nodiscard]] Vector position(const Vector& x, const Vector& v, bool, const Real& s) const { return x + v * s; }
  [[nodiscard]] Vector velocity(const Vector& v, bool, const Real&) const { return v; }
  /// What is stored when the motion changes: for free flight nothing more than `position`.
  [[nodiscard]] Vector stored_position(const Vector& x, const Vector& v, bool fixed, const Real& s) const {
    return position(x, v, fixed, s);
  }
  [[nodiscard]] Vector stored_velocity(const Vector& v, bool, const Real&) const { return v; }
  [[nodiscard]] Vector acceleration(bool) const { return Vector::Zero(); }
};

}  // namespace carom
