#pragma once
// Uniform acceleration with rest: a ball that is held to a flat wall keeps only the acceleration along it.

#include <cstdint>
#include <vector>

#include "carom/motion/uniform_acceleration.hpp"

namespace carom {

template <class RealType, int Dimension>
struct Resting {
  using Real = RealType;
  static constexpr int dimension = Dimension;
  static constexpr bool accelerated = true;
  static constexpr bool can_rest = true;
  static constexpr bool circular = false;
  static constexpr const char* name = "uniform acceleration with rest";
  using Vector = Vec<Real, Dimension>;

  struct Phase {
    bool fixed = false;     ///< never moves
    std::uint8_t held = 0;  ///< 0: flies; else the flat wall that it rests on, counted from 1
    friend bool operator==(const Phase&, const Phase&) = default;
  };
  template <class Ball>
  [[nodiscard]] static Phase phase(const Ball& ball) {
    return {ball.fixed, ball.held};
  }

  Vector a = Vector::Zero();    ///< [length unit / L^2] in flight
  std::vector<Vector> along{};  ///< [length unit / L^2] on each flat wall

  [[nodiscard]] Vector position(const Vector& x, const Vector& v, const Phase& p, const Real& s) const {
    return motion(p).position(x, v, p.fixed, s);
  }
  [[nodiscard]] Vector velocity(const Vector& v, const Phase& p, const Real& s) const {
    return motion(p).velocity(v, p.fixed, s);
  }
  [[nodiscard]] Vector stored_position(const Vector& x, const Vector& v, const Phase& p, const Real& s) const {
    return motion(p).stored_position(x, v, p.fixed, s);
  }
  [[nodiscard]] Vector stored_velocity(const Vector& v, const Phase& p, const Real& s) const {
    return motion(p).stored_velocity(v, p.fixed, s);
  }
  [[nodiscard]] Vector acceleration(const Phase& p) const { return motion(p).acceleration(p.fixed); }

 private:
  [[nodiscard]] UniformAcceleration<Real, Dimension> motion(const Phase& p) const {
    return {p.held == 0 ? a : along[p.held - 1u]};
  }
};

}  // namespace carom
