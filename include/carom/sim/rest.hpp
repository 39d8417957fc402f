#pragma once
// Rest on a flat wall: when a bouncing ball comes to rest, what that does to its energy, and how rest ends.

#include <algorithm>
#include <cmath>
#include <optional>

#include "carom/sim/collapse_watch.hpp"
#include "carom/sim/wall_party.hpp"
#include "carom/world/flat_walls.hpp"
#include "carom/world/state.hpp"

namespace carom {

/// n.(v - w): the speed of v away from a wall that moves with w; and what rounding can make of it.
template <class Real>
struct NormalSpeed {
  Wide<Real> value;
  Real doubt;
};
template <class Real, int D>
[[nodiscard]] inline NormalSpeed<Real> normal_speed(const Vec<Real, D>& n, const Vec<Real, D>& v, const Vec<Real, D>& w) {
  using std::abs;
  NormalSpeed<Real> speed{Wide<Real>(Real(0)), Real(0)};
  for (int k = 0; k < D; ++k) {
    speed.value = speed.value + wide_difference<Real>(v[k], w[k]) * Wide<Real>(n[k]);
    speed.doubt += abs(n[k]) * (abs(v[k]) + abs(w[k]));
  }
  speed.doubt *= Real(lost_in_rounding) * unit_roundoff<Real>();
  return speed;
}

/// x set on a flat wall: less the gap along n; on a face of the box to the last bit.
template <class Real, int D>
[[nodiscard]] inline Vec<Real, D> set_on(const World<Real, D>&, const Face<Real, D>& face, const Vec<Real, D>&,
                                         Vec<Real, D> x, const Real& radius, const Time<Real>&) {
  x[face.axis] = face.coordinate + Real(face.sign) * radius;
  return x;
}
template <class Real, int D, class Shape>
[[nodiscard]] inline Vec<Real, D> set_on(const World<Real, D>& world, const Shape& shape, const Vec<Real, D>& n,
                                         const Vec<Real, D>& x, const Real& radius, const Time<Real>& now) {
  const Real gap = shape.gap(Vec<Real, D>(x - wall_drift(world, shape, now))) - radius;
  return x - gap * n;
}

/// A ball set on a wall.
template <class Real, int D>
struct Landing {
  Vec<Real, D> position, velocity;
  Wide<Real> dissipated, injected;  ///< by taking its normal speed and its height over the wall
};

/// Ball i, at x with velocity v, loses its speed w = n.(v - V) off the wall and its height over it. That takes m w^2 / 2 in
/// the frame of the wall, and the potential of the height [papers/collapse.md, eq. 9].
template <class Real, int D, class Shape>
[[nodiscard]] Landing<Real, D> set_at_rest(const World<Real, D>& world, const Shape& shape, std::uint32_t i,
                                           const Vec<Real, D>& x, const Vec<Real, D>& v, const Time<Real>& now) {
  using W = Wide<Real>;
  const Vec<Real, D> n = normal_against<Real, D>(shape, world.acceleration), moving = steady_velocity(shape);
  const W speed = normal_speed<Real, D>(n, v, moving).value;
  const W share = speed / wide_dot<Real, D>(n, n);
  Landing<Real, D> rest{set_on(world, shape, n, x, world.balls[i].radius, now), v, W(Real(0)), W(Real(0))};
  W fall(Real(0));  // of the potential per mass
  for (int k = 0; k < D; ++k) {
    rest.velocity[k] = narrow(W(W(v[k]) - share * W(n[k])));
    fall = fall + wide_difference<Real>(rest.position[k], x[k]) * W(world.acceleration[k]);
  }
  const W m(world.details[i].mass);
  rest.dissipated = m * (speed * share * W(Real(1) / 2) + fall);
  rest.injected = -(m * share * wide_dot<Real, D>(n, moving));
  return rest;
}

/// Whether a ball that leaves a flat wall from x with velocity v, in acceleration a, has come to rest on it; n is the
/// wall's normal on the ball's side. With w = n.(v - V) and g = -n.a the next flight takes f = 2 w / g and rises by
/// w^2 / (2 g) [papers/collapse.md, eq. 8]. The ball rests if f is no tick of the clock; if w is lost in the rounding of v
/// [eq. 6]; or if the rise is lost in the rounding of x and what the flights lose, (1 - e) f, is no tick, so that the clock
/// can tell no bounce from the next. That is how an elastic ball comes to rest whose bounces nobody could see.
template <class Real, int D, class Shape>
[[nodiscard]] bool comes_to_rest(const Shape& shape, const Vec<Real, D>& n, const Vec<Real, D>& x, const Vec<Real, D>& v,
                                 const Vec<Real, D>& a, const Real& radius, const Real& e, const Time<Real>& now) {
  using std::abs;
  const Real g = -dot<Real, D>(n, a);
  if (!(g > 0)) return false;
  const NormalSpeed<Real> speed = normal_speed<Real, D>(n, v, steady_velocity(shape));
  const Real w = narrow(speed.value);
  if (!(w > speed.doubt)) return true;
  const Real flight = 2 * w / g;
  if (after(now, flight) == now) return true;
  Real size = radius;
  for (int k = 0; k < D; ++k) size = std::max<Real>(size, abs(x[k]));
  return w * flight <= 4 * unit_roundoff<Real>() * size && after(now, Real((1 - e) * flight / 2)) == now;
}

/// Where ball i, at x with velocity v, goes on if v keeps it on the wall that it is held to: on it, to the last bit.
template <class Real, int D>
[[nodiscard]] std::optional<Landing<Real, D>> stay(const World<Real, D>& world, std::uint32_t i, const Vec<Real, D>& x,
                                                   const Vec<Real, D>& v, const Time<Real>& now) {
  using std::abs;
  std::optional<Landing<Real, D>> rest;
  if (world.balls[i].held != 0)
    with_flat(world.walls, world.balls[i].held, [&](const auto& shape) {
      const Vec<Real, D> n = normal_against<Real, D>(shape, world.acceleration);
      const NormalSpeed<Real> speed = normal_speed<Real, D>(n, v, steady_velocity(shape));
      if (!(abs(narrow(speed.value)) > speed.doubt)) rest = set_at_rest(world, shape, i, x, v, now);
    });
  return rest;
}

/// Ball i flies from the wall that it is held to, in contact with it: it hits the wall at once if it closes. `left`: it has
/// slid off its end.
template <class Real, int D>
void release(World<Real, D>& world, std::uint32_t i, bool left = false) {
  with_flat(world.walls, world.balls[i].held, [&](const auto& shape) {
    Contact<D> contact{Party::wall, index(shape.wall), shape.feature, {}, 0, false, 0, 0, left};
    if constexpr (requires { shape.along; }) contact.side = dot<Real, D>(shape.direction, world.acceleration) > 0 ? -1 : 1;
    hold_contact(world, i, contact);
  });
  world.balls[i].held = 0;
}

/// Ball i has slid off the end of a segment at this very moment and is hit: if v leads back over the segment, it has not
/// left.
template <class Real, int D>
void take_back(World<Real, D>& world, std::uint32_t i, const Vec<Real, D>& x, const Vec<Real, D>& v,
               const Time<Real>& now) {
  if constexpr (D == 2) {
    Ball<Real, D>& ball = world.balls[i];
    if (ball.held != 0 || !ball.in_contact || ball.time != now) return;
    for (Contact<D>& c : world.details[i].contacts)
      if (c.left)
        world.walls.with(c.partner, c.feature, [&](const auto& shape) {
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(shape)>, Segment<Real>>) {
            const Vec<Real, D> middle = (shape.from + shape.to) / 2 + wall_drift(world, shape, now);
            const Real offset = dot<Real, D>(shape.along, x - middle), rate = dot<Real, D>(shape.along, v - shape.velocity);
            if (!(offset < 0 ? rate > 0 : rate < 0)) return;
            c.left = false;
            ball.held = static_cast<std::uint8_t>(flat_number(world.walls, shape));
          }
        });
  }
}

/// Work that a moving wall has done on a ball which rests on it, from its stored time to t: -m (n.a) (n.V) / (n.n) a unit
/// of time [papers/collapse.md, eq. 10].
template <class Real, int D>
[[nodiscard]] Wide<Real> work_at_rest(const World<Real, D>& world, std::uint32_t i, const Time<Real>& t) {
  using W = Wide<Real>;
  W work(Real(0));
  if (world.balls[i].held == 0) return work;
  with_flat(world.walls, world.balls[i].held, [&](const auto& shape) {
    const Vec<Real, D> moving = steady_velocity(shape);
    if (moving == Vec<Real, D>::Zero()) return;
    const Vec<Real, D> n = normal_against<Real, D>(shape, world.acceleration);
    const W power = wide_dot<Real, D>(n, world.acceleration) * wide_dot<Real, D>(n, moving) / wide_dot<Real, D>(n, n);
    work = -(W(world.details[i].mass) * power * W(elapsed(world.balls[i].time, t)));
  });
  return work;
}

}  // namespace carom
