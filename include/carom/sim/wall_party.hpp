#pragma once
// A wall as the infinite mass of an impact.

#include "carom/predict/ball_wall.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Where the wall is at `now`, relative to where the scene puts it.
template <class Real, int D, class Shape>
[[nodiscard]] inline Vec<Real, D> wall_drift(const World<Real, D>& world, const Shape& shape, const Time<Real>& now) {
  return drift(world, shape, now);
}

/// Of a wall that does not swing.
template <class Real, int D>
[[nodiscard]] inline Vec<Real, D> steady_velocity(const Face<Real, D>&) {
  return Vec<Real, D>::Zero();
}
template <class Shape>
[[nodiscard]] inline auto steady_velocity(const Shape& shape) {
  return shape.velocity;
}

/// Direction of the impulse that the wall gives a ball at `at`, of any length.
template <class Real, int D, class Shape>
[[nodiscard]] inline Vec<Real, D> towards_ball(const Shape& shape, const Vec<Real, D>& at, std::int8_t side) {
  if constexpr (std::is_same_v<Shape, Segment<Real>>) {
    return side * shape.normal(at);
  } else {
    return shape.normal(at);
  }
}

/// A point meets a vertex: there is no normal.
template <class Real, int D, class Shape>
[[nodiscard]] inline bool singular_contact(const Shape& shape, const Real& radius) {
  if constexpr (std::is_same_v<Shape, Sphere<Real, D>>) return !(shape.radius > 0) && !(radius > 0);
  return false;
}

}  // namespace carom
