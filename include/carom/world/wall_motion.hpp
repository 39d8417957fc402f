#pragma once
// Where a wall that moves is, and how fast it moves.

#include "carom/world/world.hpp"

namespace carom {

/// The swing of a piece of a wall, or nullptr.
template <class Real, int D, class Shape>
[[nodiscard]] inline const Swing<Real, D>* swing_of(const Walls<Real, D>& walls, const Shape& shape) {
  if constexpr (requires { shape.swing; }) {
    if (shape.swing >= 0) return &walls.swings[static_cast<std::size_t>(shape.swing)];
  }
  return nullptr;
}

/// Its swing, or one that does not move it.
template <class Real, int D, class Shape>
[[nodiscard]] inline Swing<Real, D> swing_or_none(const Walls<Real, D>& walls, const Shape& shape) {
  const Swing<Real, D>* swing = swing_of(walls, shape);
  return swing != nullptr ? *swing : Swing<Real, D>{Vec<Real, D>::Zero(), Real(1), Real(0)};
}

template <class Real, int D, class Shape>
[[nodiscard]] inline bool moves(const Walls<Real, D>& walls, const Shape& shape) {
  if constexpr (requires { shape.velocity; })
    if (!(shape.velocity == Vec<Real, D>::Zero())) return true;
  return swing_of(walls, shape) != nullptr;
}

/// Where a shape is at time t, relative to where the scene puts it. WorldLike: World, or a view with its members.
template <class WorldLike, class Shape, class Real>
[[nodiscard]] inline auto drift(const WorldLike& world, const Shape& shape, const Time<Real>& t) {
  constexpr int D = WorldLike::dimension;
  if constexpr (requires { shape.velocity; }) {
    Vec<Real, D> d = shape.velocity * elapsed(world.start, t);
    if (const Swing<Real, D>* swing = swing_of(world.walls, shape)) d += swing->displacement(t);
    return d;
  } else {
    return Vec<Real, D>(Vec<Real, D>::Zero());
  }
}

/// Velocity of a wall at time t.
template <class WorldLike, class Shape, class Real>
[[nodiscard]] inline auto wall_velocity(const WorldLike& world, const Shape& shape, const Time<Real>& t) {
  constexpr int D = WorldLike::dimension;
  if constexpr (requires { shape.velocity; }) {
    Vec<Real, D> v = shape.velocity;
    if (const Swing<Real, D>* swing = swing_of(world.walls, shape)) v += swing->velocity(t);
    return v;
  } else {
    return Vec<Real, D>(Vec<Real, D>::Zero());
  }
}

}  // namespace carom
