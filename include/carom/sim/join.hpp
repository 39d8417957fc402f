#pragma once
// Bodies that go on together: law "stick" joins them, law "merge" makes one ball of two.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "carom/law/merge.hpp"
#include "carom/law/stick.hpp"
#include "carom/world/state.hpp"

namespace carom {

/// Makes one body of those of balls i and j, which are at xi and xj (its image `image`; neither wrapped anew) at time t and
/// move on with velocity v. Appends the numbers of all balls written to `written`.
template <Motion M>
void join_bodies(World<typename M::Real, M::dimension>& world, const M& motion, std::uint32_t i,
                 const typename M::Vector& xi, std::uint32_t j, const typename M::Vector& xj,
                 const Image<M::dimension>& image, const typename M::Vector& v, const Time<typename M::Real>& t,
                 std::vector<std::uint32_t>& written) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  using Vector = typename M::Vector;
  using std::abs;
  const auto body_at = [&](std::uint32_t k, const Vector& x) {
    const std::int32_t b = world.details[k].body;
    if (b < 0) return Body<Real, D>{world.details[k].mass, x, world.details[k].image, {k}, {Vector::Zero()}, {Turns<D>{}}};
    Body<Real, D> body = world.bodies[static_cast<std::size_t>(b)];
    const Ball<Real, D>& ball = world.balls[k];
    if (ball.time != t)
      body.position = motion.stored_position(body.position, ball.velocity, motion.phase(ball), elapsed(ball.time, t));
    return body;
  };
  const auto place_of = [](const Body<Real, D>& body, std::uint32_t k) {
    return static_cast<std::size_t>(std::find(body.members.begin(), body.members.end(), k) - body.members.begin());
  };
  Body<Real, D> a = body_at(i, xi);
  const Body<Real, D> b = body_at(j, xj);
  const std::size_t mi = place_of(a, i), mj = place_of(b, j);
  const bool fixed = world.balls[i].fixed || world.balls[j].fixed;
  // A member of b keeps its own count of periods: what joining it at an image adds to its place is taken out of its shift.
  const Vector apart = a.offsets[mi] + (xj - xi) - b.offsets[mj];
  Turns<D> turned;
  for (int k = 0; k < D; ++k)
    turned[k] = a.shifts[mi][k] - b.shifts[mj][k] + world.details[j].image[k] - world.details[i].image[k] - image[k];
  for (std::size_t m = 0; m < b.members.size(); ++m) {
    a.members.push_back(b.members[m]);
    a.offsets.push_back(apart + b.offsets[m]);
    a.shifts.push_back(b.shifts[m]);
    for (int k = 0; k < D; ++k) a.shifts.back()[k] += turned[k];
  }
  a.mass = a.mass + b.mass;

  const std::int32_t kept = world.details[i].body, left = world.details[j].body;
  if (kept >= 0 && left >= 0) world.bodies[static_cast<std::size_t>(left)] = Body<Real, D>{};
  std::int32_t row = kept >= 0 ? kept : left;
  if (row < 0) {
    row = static_cast<std::int32_t>(world.bodies.size());
    world.bodies.emplace_back();
  }
  Real far(0);  // the offset of one from the other is rounded relative to where both have flown
  for (int k = 0; k < D; ++k) far = std::max<Real>(far, std::max<Real>(abs(xi[k]), abs(xj[k])));
  for (const std::uint32_t m : a.members) {
    world.details[m].body = row;
    world.details[m].reach = std::max<Real>(world.details[m].reach, far);
    world.balls[m].fixed = fixed;
  }
  world.bodies[static_cast<std::size_t>(row)] = std::move(a);
  write_body(world, world.bodies[static_cast<std::size_t>(row)], v, t, written);
}

/// Makes one ball of i and j, i < j, which are at xi and xj (its image) at time t: the ball i. Ball j leaves.
template <Motion M>
void merge_balls(World<typename M::Real, M::dimension>& world, const M&, std::uint32_t i, const typename M::Vector& xi,
                 std::uint32_t j, const typename M::Vector& xj, const typename M::Vector& v,
                 const Time<typename M::Real>& t, std::vector<std::uint32_t>& written) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  Ball<Real, D>&a = world.balls[i], &b = world.balls[j];
  BallDetail<Real, D>&da = world.details[i], &db = world.details[j];
  const Wide<Real> sa = detail::share(da.mass, db.mass);  // x = x_a + s_a (x_b - x_a)
  typename M::Vector x;
  for (int k = 0; k < D; ++k)
    x[k] = detail::infinite(da.mass)   ? xi[k]
           : detail::infinite(db.mass) ? xj[k]
                                       : narrow(Wide<Real>(Wide<Real>(xi[k]) + sa * wide_difference<Real>(xj[k], xi[k])));
  if (db.mass > da.mass) da.material = db.material;
  a.radius = merged_radius<D>(a.radius, b.radius);
  a.fixed = a.fixed || b.fixed;
  da.mass = da.mass + db.mass;
  write_state(world, i, x, da.image, v, t);
  write_state(world, j, typename M::Vector(b.position), db.image, v, t);
  world.details[i].contacts.clear();
  world.details[j].contacts.clear();
  a.in_contact = b.in_contact = false;
  b.alive = false;
  written.push_back(i);
  written.push_back(j);
}

}  // namespace carom
