#pragma once
// Bodies that go on together: law "stick" joins them, law "merge" makes one ball of two.

#include <utility>
#include <vector>

#include "carom/law/merge.hpp"
#include "carom/law/stick.hpp"
#include "carom/world/state.hpp"

namespace carom {

/// Makes one body of those of balls i and j, which are at xi and xj (its image; neither wrapped anew) at time t and move on
/// with velocity v. Appends the numbers of all balls written to `written`.
template <Motion M>
void join_bodies(World<typename M::Real, M::dimension>& world, const M& motion, std::uint32_t i,
                 const typename M::Vector& xi, std::uint32_t j, const typename M::Vector& xj, const typename M::Vector& v,
                 const Time<typename M::Real>& t, std::vector<std::uint32_t>& written) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  using Vector = typename M::Vector;
  const auto alone = [&](std::uint32_t k, const Vector& x) {
    Body<Real, D> body;
    body.mass = world.details[k].mass;
    body.position = x;
    body.image = world.details[k].image;
    body.members = {k};
    body.offsets = {Vector::Zero()};
    return body;
  };
  const auto body_of = [&](std::uint32_t k, const Vector& x) {
    const std::int32_t b = world.details[k].body;
    if (b < 0) return alone(k, x);
    Body<Real, D> body = world.bodies[static_cast<std::size_t>(b)];
    const Ball<Real, D>& ball = world.balls[k];
    if (ball.time != t) body.position = motion.position(body.position, ball.velocity, ball.fixed, elapsed(ball.time, t));
    return body;
  };
  const auto offset_of = [](const Body<Real, D>& body, std::uint32_t k) {
    std::size_t m = 0;
    while (body.members[m] != k) ++m;
    return body.offsets[m];
  };
  Body<Real, D> a = body_of(i, xi);
  const Body<Real, D> b = body_of(j, xj);
  const bool fixed = world.balls[i].fixed || world.balls[j].fixed;
  const Vector shift = offset_of(a, i) + (xj - xi) - offset_of(b, j);
  for (std::size_t m = 0; m < b.members.size(); ++m) {
    a.members.push_back(b.members[m]);
    a.offsets.push_back(shift + b.offsets[m]);
  }
  a.mass = a.mass + b.mass;
  const std::int32_t kept = world.details[i].body, left = world.details[j].body;
  std::int32_t row = kept >= 0 ? kept : left;
  if (row < 0) {
    row = static_cast<std::int32_t>(world.bodies.size());
    world.bodies.emplace_back();
  }
  if (kept >= 0 && left >= 0 && kept != left) world.bodies[static_cast<std::size_t>(left)] = Body<Real, D>{};
  for (const std::uint32_t m : a.members) {
    world.details[m].body = row;
    world.balls[m].fixed = fixed;
  }
  const Turns<D> turns = wrap(world.space, a.position);
  for (int k = 0; k < D; ++k) a.image[k] += turns[k];
  Body<Real, D>& body = world.bodies[static_cast<std::size_t>(row)];
  body = std::move(a);
  for (std::size_t m = 0; m < body.members.size(); ++m) {
    write_state(world, body.members[m], Vector(body.position + body.offsets[m]), body.image, v, t);
    written.push_back(body.members[m]);
  }
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
