#pragma once
// The only places where a ball is looked at between its events, and where its state is written.

#include <algorithm>
#include <cmath>

#include "carom/motion/motion.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// Position of ball i at `t` >= its stored time, not wrapped anew. Looking writes nothing. W: World, or a view with its
/// members.
template <Motion M, class W>
[[nodiscard]] inline typename M::Vector position_at(const M& motion, const W& world, std::uint32_t i,
                                                    const Time<typename M::Real>& t) {
  const auto& b = world.balls[i];
  return b.time == t ? typename M::Vector(b.position)
                     : motion.stored_position(b.position, b.velocity, motion.phase(b), elapsed(b.time, t));
}

/// Velocity of ball i at `t` >= its stored time.
template <Motion M, class W>
[[nodiscard]] inline typename M::Vector velocity_at(const M& motion, const W& world, std::uint32_t i,
                                                    const Time<typename M::Real>& t) {
  const auto& b = world.balls[i];
  return b.time == t ? typename M::Vector(b.velocity) : motion.stored_velocity(b.velocity, motion.phase(b), elapsed(b.time, t));
}

/// Wraps x into the cell of a periodic space, [lower, lower + edge), and gives the periods taken out.
template <class Real, int D>
inline Turns<D> wrap(const Space<Real, D>& space, Vec<Real, D>& x) {
  using std::floor;
  Turns<D> turns{};
  if (!space.periodic()) return turns;
  for (int k = 0; k < D; ++k) {
    const Real n = floor((x[k] - space.lower[k]) / space.edge[k]);
    if (n != 0) {
      x[k] -= n * space.edge[k];
      turns[k] = static_cast<std::int64_t>(n);
    }
    if (x[k] < space.lower[k]) {  // the quotient was rounded up
      x[k] += space.edge[k];
      --turns[k];
    }
    if (x[k] >= space.lower[k] + space.edge[k]) {  // x was a rounding below the lower edge
      x[k] -= space.edge[k];
      ++turns[k];
    }
  }
  return turns;
}

/// The motion of ball i changes: it is at x with velocity v at time t. Contacts made at an earlier time end; those made at
/// t stay, and are no longer spent. `image` counts the periods already taken out of x.
template <class Real, int D>
inline void write_state(World<Real, D>& world, std::uint32_t i, const Vec<Real, D>& x, const Turns<D>& image,
                        const Vec<Real, D>& v, const Time<Real>& t) {
  using std::abs;
  Ball<Real, D>& ball = world.balls[i];
  BallDetail<Real, D>& detail = world.details[i];
  if (ball.time != t) {
    detail.contacts.clear();
    ball.in_contact = false;
  }
  for (int k = 0; k < D; ++k)
    detail.reach = std::max<Real>(detail.reach, std::max<Real>(abs(ball.position[k]), abs(x[k])));
  if (world.curved()) {  // it may have been further out on the way
    const Real flight = elapsed(ball.time, t);
    for (int k = 0; k < D; ++k) detail.reach = std::max<Real>(detail.reach, abs(ball.velocity[k]) * flight);
  }
  ball.position = x;
  const Turns<D> turns = wrap(world.space, ball.position);
  for (int k = 0; k < D; ++k) detail.image[k] = image[k] + turns[k];
  ball.velocity = v;
  ball.time = t;
  ++ball.stamp;
}

/// The members of a body whose position is that at time t, and which moves on with velocity v, are written.
template <class Real, int D>
inline void write_body(World<Real, D>& world, Body<Real, D>& body, const Vec<Real, D>& v, const Time<Real>& t,
                       std::vector<std::uint32_t>& written) {
  using std::abs;
  Real flown_to(0);  // before it is wrapped: what its rounding is relative to
  for (int k = 0; k < D; ++k) flown_to = std::max<Real>(flown_to, abs(body.position[k]));
  const Turns<D> turns = wrap(world.space, body.position);
  for (int k = 0; k < D; ++k) body.image[k] += turns[k];
  for (std::size_t m = 0; m < body.members.size(); ++m) {
    Turns<D> image = body.image;
    for (int k = 0; k < D; ++k) image[k] += body.shifts[m][k];
    BallDetail<Real, D>& detail = world.details[body.members[m]];
    detail.reach = std::max<Real>(detail.reach, flown_to);
    write_state(world, body.members[m], Vec<Real, D>(body.position + body.offsets[m]), image, v, t);
    written.push_back(body.members[m]);
  }
}

/// The motion of the body of ball i changes: ball i is at x (not wrapped anew) with velocity v at time t, and so are its
/// fellows, each at its constant offset. Appends the numbers of all balls written to `written`.
template <Motion M>
inline void write_motion(World<typename M::Real, M::dimension>& world, const M& motion, std::uint32_t i,
                         const typename M::Vector& x, const typename M::Vector& v, const Time<typename M::Real>& t,
                         std::vector<std::uint32_t>& written) {
  const std::int32_t b = world.details[i].body;
  if (b < 0) {
    write_state(world, i, x, world.details[i].image, v, t);
    written.push_back(i);
    return;
  }
  auto& body = world.bodies[static_cast<std::size_t>(b)];
  const auto& before = world.balls[i];
  if (before.time != t)
    body.position = motion.stored_position(body.position, before.velocity, motion.phase(before), elapsed(before.time, t));
  write_body(world, body, v, t, written);
}

/// Ball i holds `contact` from now on, in place of an earlier one with the same feature.
template <class Real, int D>
inline void hold_contact(World<Real, D>& world, std::uint32_t i, const Contact<D>& contact) {
  auto& contacts = world.details[i].contacts;
  world.balls[i].in_contact = true;
  for (Contact<D>& c : contacts)
    if (c.with(contact.party, contact.partner, contact.feature, contact.image)) {
      c = contact;
      return;
    }
  contacts.push_back(contact);
}

}  // namespace carom
