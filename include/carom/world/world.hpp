#pragma once
// Everything that a run works on: balls, walls, space, laws, in the world's own units.

#include <cstdint>
#include <vector>

#include "carom/core/clock.hpp"
#include "carom/core/vec.hpp"
#include "carom/scene/scene.hpp"
#include "carom/world/ball.hpp"
#include "carom/world/growth.hpp"
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

/// Counts of periods, one an axis.
template <int D>
using Turns = std::array<std::int64_t, static_cast<std::size_t>(D)>;

/// Balls that move as one without rotating (law "stick").
template <class Real, int D>
struct Body {
  Real mass = Real(0);                           ///< [mass unit]; infinity if a member's is
  Vec<Real, D> position = Vec<Real, D>::Zero();  ///< [length unit] of its reference point at the stored time, wrapped
  Turns<D> image{};                              ///< periods counted out of `position`
  std::vector<std::uint32_t> members;            ///< ball numbers
  std::vector<Vec<Real, D>> offsets;             ///< of the members from the reference point; constant
  std::vector<Turns<D>> shifts;                  ///< periods by which a member's own count differs from the body's
};

template <class RealType, int Dimension>
struct World {
  using Real = RealType;
  static constexpr int dimension = Dimension;
  using Vector = Vec<Real, Dimension>;

  Units units;
  Time<Real> start;                                  ///< when the walls are where the scene puts them
  std::vector<Ball<Real, Dimension>> balls;          ///< by ball number
  std::vector<BallDetail<Real, Dimension>> details;  ///< by ball number
  std::vector<Body<Real, Dimension>> bodies;         ///< those of more than one ball
  Walls<Real, Dimension> walls;
  Space<Real, Dimension> space;
  Vector acceleration = Vector::Zero();  ///< [length unit / L^2] of every ball that is not fixed
  Real magnetic = Real(0);               ///< [rad/L] cyclotron frequency, > 0 anticlockwise (2-D)
  Growth<Real> growth{};                 ///< of the balls; their `radius` is that at the start
  RestitutionTable<Real> restitution;
  LawKind law = LawKind::restitution;
  Simultaneous simultaneous = Simultaneous::sequential;
  Regularise regularise = Regularise::stop;
  Real contact_time = Real(0);              ///< [L] t_c of the TC model; 0: off
  Real reference_speed = Real(1);           ///< [length unit / L] viscoelastic
  RestitutionTable<Real> viscoelastic{};    ///< the arguments x of `viscoelastic_restitution` at the reference speed

  /// Mass of the body that ball i belongs to.
  [[nodiscard]] const Real& body_mass(std::uint32_t i) const {
    const std::int32_t b = details[i].body;
    return b < 0 ? details[i].mass : bodies[static_cast<std::size_t>(b)].mass;
  }
  [[nodiscard]] bool accelerated() const { return !(acceleration == Vector::Zero()); }
  /// Paths are not straight lines.
  [[nodiscard]] bool curved() const { return accelerated() || magnetic != 0; }
};

}  // namespace carom
