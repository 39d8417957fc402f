#pragma once
// The plain truth about overlaps: every pair and every wall, at one moment, whatever the engine believed.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "carom/world/growth.hpp"
#include "carom/world/near_pairs.hpp"
#include "carom/world/state.hpp"
#include "carom/world/wall_images.hpp"
#include "carom/world/wall_motion.hpp"

namespace carom {

/// What an audit found. Depths are in the world's length unit.
struct Audit {
  std::int64_t overlaps = 0;      ///< pairs and ball-wall contacts deeper than rounding explains
  double deepest = 0.0;           ///< the deepest overlap found, rounding included
  double deepest_relative = 0.0;  ///< of it, over the sum of the radii (points: over the distance)
  std::uint32_t ball = 0;
  std::uint32_t partner = 0;  ///< ball or wall number
  bool with_wall = false;
};

/// How deep rounding alone can make two parties overlap: each position carries up to 2 ulp of its largest coordinate from
/// the advance to contact and up to 2 more from the advance to the audit; the contact time a rounding of the flight, and
/// one to a tick of the clock, in which a ball moves by its speed times a unit roundoff.
inline constexpr double audit_ulp = 32.0;

enum class AuditBy : std::uint8_t { every_pair, grid };

/// WorldLike: World, or a view with its members.
template <Motion M, class WorldLike>
[[nodiscard]] Audit audit(const M& motion, const WorldLike& world, const Time<typename M::Real>& t,
                          AuditBy by = AuditBy::grid) {
  using Real = typename M::Real;
  using std::abs;
  using std::sqrt;
  constexpr int D = M::dimension;
  Audit result;
  std::vector<Vec<Real, D>> at;  // wrapped
  std::vector<Real> reach;       // size of the coordinates that entered the position, and of the way in an epoch
  std::vector<Real> radius;
  double grown = 0;  // most that a diameter has grown
  for (std::uint32_t i = 0; i < world.balls.size(); ++i) {
    Vec<Real, D> x = world.balls[i].alive ? position_at(motion, world, i, t) : world.balls[i].position;
    radius.push_back(radius_at(world, i, t));
    grown = std::max(grown, 2 * static_cast<double>(Real(radius[i] - world.balls[i].radius)));
    Real size = std::max<Real>(radius[i], world.details[i].reach);
    const Vec<Real, D> v = world.balls[i].alive ? velocity_at(motion, world, i, t) : world.balls[i].velocity;
    for (int k = 0; k < D; ++k) {
      size = std::max<Real>(size, abs(v[k]));
      if (world.balls[i].alive && world.curved())
        size = std::max<Real>(size, abs(world.balls[i].velocity[k]) * elapsed(world.balls[i].time, t));
      const Real there = abs(x[k]), stored = abs(world.balls[i].position[k]);
      size = std::max<Real>(size, std::max<Real>(there, stored));
      if (world.space.periodic()) size = std::max<Real>(size, Real(abs(world.space.lower[k]) + world.space.edge[k]));
    }
    wrap(world.space, x);
    at.push_back(x);
    reach.push_back(size);
  }
  const auto note = [&](const Real& depth, const Real& bound, const Real& radii, std::uint32_t i, std::uint32_t partner,
                        bool wall) {
    if (!(depth > 0)) return;
    if (depth > bound) ++result.overlaps;
    if (static_cast<double>(depth) <= result.deepest) return;
    result.deepest = static_cast<double>(depth);
    result.deepest_relative = radii > 0 ? static_cast<double>(Real(depth / radii)) : 0.0;
    result.ball = i;
    result.partner = partner;
    result.with_wall = wall;
  };
  const Real ulps = Real(audit_ulp) * unit_roundoff<Real>();
  const auto pair = [&](std::uint32_t i, std::uint32_t j, const Image<D>& image) {
    if (!world.balls[i].alive || !world.balls[j].alive || (world.balls[i].fixed && world.balls[j].fixed)) return;
    const Real sigma = radius[i] + radius[j];
    if (!(sigma > 0)) return;
    Vec<Real, D> r = at[j] - at[i];
    if (world.space.periodic())
      for (int k = 0; k < D; ++k) r[k] += Real(image[k]) * world.space.edge[k];
    const Real depth = sigma - sqrt(dot<Real, D>(r, r));
    note(depth, ulps * (reach[i] + reach[j] + sigma), sigma, i, j, false);
  };
  if (by == AuditBy::every_pair && !world.space.periodic()) {
    for (std::uint32_t i = 0; i < at.size(); ++i)
      for (std::uint32_t j = i + 1; j < at.size(); ++j) pair(i, j, Image<D>{});
  } else {
    for_each_near_pair(world, at, grown * (1 + 0x1p-20), pair);
  }
  for (std::uint32_t i = 0; i < at.size(); ++i) {
    if (!world.balls[i].alive || world.balls[i].fixed) continue;
    world.walls.for_each([&](const auto& shape) {
      if (world.walls.opens(index(shape.wall))) return;
      Vec<Real, D> x = at[i];
      if (world.space.periodic()) {
        for_each_image(world.space, shape, x, radius[i], [&](const Image<D>& n) {
          const Real gap = moved_by(world.space, shape, n).gap(x);
          note(Real(radius[i] - gap), ulps * (2 * reach[i] + abs(gap)), radius[i], i, index(shape.wall), true);
        });
        return;
      }
      x -= drift(world, shape, t);
      const Real depth = radius[i] - shape.gap(x);
      note(depth, ulps * (2 * reach[i] + abs(shape.gap(x))), radius[i], i, index(shape.wall), true);
    });
  }
  return result;
}

}  // namespace carom
