#pragma once
// The restitution that holds at one contact: as given, by the speed of approach, or elastic while a contact lasts.

#include <algorithm>
#include <cmath>

#include "carom/law/impact.hpp"
#include "carom/law/viscoelastic.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Speed at which the parties approach along the line of centres, >= 0.
template <class Real, int D>
[[nodiscard]] inline Real approach_speed(const Impact<Real, D>& impact) {
  using std::sqrt;
  Real gr(0), rr(0);
  for (int k = 0; k < D; ++k) {
    const Real r = narrow(impact.r[k]);
    gr += (impact.va[k] - impact.vb[k]) * r;
    rr += r * r;
  }
  return gr > 0 ? Real(gr / sqrt(rr)) : Real(0);
}

/// What rounding can make of the velocities along the line of centres, as a velocity [papers/collapse.md, eq. 6].
template <class Real, int D>
[[nodiscard]] inline Real rounding_of_velocity(const Impact<Real, D>& impact) {
  using std::abs;
  using std::sqrt;
  Real size(0), rr(0);
  for (int k = 0; k < D; ++k) {
    const Real r = narrow(impact.r[k]);
    size += (abs(impact.va[k]) + abs(impact.vb[k])) * abs(r);
    rr += r * r;
  }
  return unit_roundoff<Real>() * size / sqrt(rr);
}

/// A rounding of the coordinates of ball i.
template <class Real, int D>
[[nodiscard]] inline Real rounding_of_position(const World<Real, D>& world, std::uint32_t i) {
  return unit_roundoff<Real>() * std::max<Real>(world.details[i].reach, world.balls[i].radius);
}

/// TC model [LudingMcNamara1998]: the ball's last contact with anything is no longer ago than t_c. Obstacles (infinite
/// mass) have no such contact.
template <class Real, int D>
[[nodiscard]] inline bool still_in_contact(const World<Real, D>& world, std::uint32_t i, const Time<Real>& now) {
  const BallDetail<Real, D>& ball = world.details[i];
  return !detail::infinite(ball.mass) && !ball.last_hit.is_never() &&
         elapsed(ball.last_hit, now) <= world.contact_time;
}

/// viscoelastic: restitution at this speed, x = x_ref (v / v_ref)^(1/10) [papers/viscoelastic.md, eq. 5].
template <class Real, int D>
[[nodiscard]] inline Real restitution_at_speed(const World<Real, D>& world, const Impact<Real, D>& impact,
                                               const Real& argument) {
  if (argument == 0) return Real(1);
  return viscoelastic_restitution(Real(argument * tenth_root(Real(approach_speed(impact) / world.reference_speed))));
}

/// e of the impact of balls i and j.
template <class Real, int D>
[[nodiscard]] inline Real restitution_of_pair(const World<Real, D>& world, const Impact<Real, D>& impact, std::uint32_t i,
                                              std::uint32_t j, const Time<Real>& now) {
  if (world.contact_time > 0 && (still_in_contact(world, i, now) || still_in_contact(world, j, now))) return Real(1);
  const std::uint32_t a = world.details[i].material, b = world.details[j].material;
  if (world.regularise == Regularise::viscoelastic)
    return restitution_at_speed(world, impact, world.viscoelastic.between(a, b));
  return world.restitution.between(a, b);
}

/// e of the impact of ball i and a wall. Where balls come to rest on flat walls, those dissipate always: their remedy is
/// rest, and t_c would keep a ball bouncing for ever.
template <class Real, int D>
[[nodiscard]] inline Real restitution_at_wall(const World<Real, D>& world, const Impact<Real, D>& impact, std::uint32_t i,
                                              std::uint32_t wall, bool flat, const Time<Real>& now) {
  const bool lasting = world.contact_time > 0 && !(flat && world.regularise == Regularise::rest);
  if (lasting && still_in_contact(world, i, now)) return Real(1);
  const std::uint32_t material = world.details[i].material;
  if (world.regularise == Regularise::viscoelastic)
    return restitution_at_speed(world, impact, world.viscoelastic.at_wall(material, wall));
  return world.restitution.at_wall(material, wall);
}

}  // namespace carom
