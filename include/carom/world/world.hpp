#pragma once
// Everything that a run works on: balls, walls, space, laws, in the world's own units.

#include <cstdint>
#include <vector>

#include "carom/core/clock.hpp"
#include "carom/core/vec.hpp"
#include "carom/scene/scene.hpp"
#include "carom/world/ball.hpp"
#include "carom/world/restitution_table.hpp"
#include "carom/world/units.hpp"
#include "carom/world/walls.hpp"

namespace carom {

/// The space that the balls live in. A box also has faces among the walls.
template <class Real, int D>
struct Space {
  SpaceKind kind = SpaceKind::open;
  Vec<Real, D> lower = Vec<Real, D>::Zero();  ///< [length unit] box, periodic
  Vec<Real, D> edge = Vec<Real, D>::Zero();   ///< [length unit] upper - lower

  [[nodiscard]] bool periodic() const noexcept { return kind == SpaceKind::periodic; }
};

/// Balls that move as one without rotating (law "stick").
template <class Real, int D>
struct Body {
  Vec<Real, D> position;               ///< [length unit] of its reference point at the members' stored time
  std::vector<std::uint32_t> members;  ///< ball numbers
  std::vector<Vec<Real, D>> offsets;   ///< of the members from the reference point; constant
};

template <class RealType, int Dimension>
struct World {
  using Real = RealType;
  static constexpr int dimension = Dimension;
  using Vector = Vec<Real, Dimension>;

  Units units;
  Time<Real> start;                                 ///< when the walls are where the scene puts them
  std::vector<Ball<Real, Dimension>> balls;         ///< by ball number
  std::vector<BallDetail<Real, Dimension>> details; ///< by ball number
  std::vector<Body<Real, Dimension>> bodies;        ///< those of more than one ball
  Walls<Real, Dimension> walls;
  Space<Real, Dimension> space;
  Vector acceleration = Vector::Zero();             ///< [length unit / L^2] of every ball that is not fixed
  RestitutionTable<Real> restitution;
  LawKind law = LawKind::restitution;

  [[nodiscard]] bool accelerated() const { return !(acceleration == Vector::Zero()); }
};

}  // namespace carom
