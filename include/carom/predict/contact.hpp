#pragma once
// Who touches whom is state: what the contacts that two parties made at their stored times say of their next meeting.

#include "carom/world/world.hpp"

namespace carom {

/// none: they meet where their gap says. spent: they touch and their impact has been resolved. live: they touch and one of
/// them was hit since (or they touch by start), so that approaching means now.
enum class Touch : std::uint8_t { none, spent, live };

/// The contact that ball i holds with a wall feature, in a periodic space with that of one period; or nullptr.
template <class Real, int D>
[[nodiscard]] inline const Contact<D>* wall_contact(const World<Real, D>& world, std::uint32_t i, std::uint32_t wall,
                                                    std::int32_t feature, const Image<D>& image = {}) {
  if (!world.balls[i].in_contact) return nullptr;
  for (const Contact<D>& c : world.details[i].contacts)
    if (c.with(Party::wall, wall, feature, image)) return &c;
  return nullptr;
}

template <class Real, int D>
[[nodiscard]] inline Touch touch_of_wall(const Contact<D>* c, const Ball<Real, D>& ball) {
  if (c == nullptr) return Touch::none;
  return c->acted && c->own_stamp == ball.stamp ? Touch::spent : Touch::live;
}

/// Two balls touch if each lists the other and their stored times are equal.
template <class Real, int D>
[[nodiscard]] inline Touch touch_of_pair(const World<Real, D>& world, std::uint32_t i, std::uint32_t j,
                                         const Image<D>& image) {
  const Ball<Real, D>& a = world.balls[i];
  const Ball<Real, D>& b = world.balls[j];
  if (!a.in_contact || !b.in_contact || a.time != b.time) return Touch::none;
  const Image<D> back = -image;
  const Contact<D>* mine = nullptr;
  for (const Contact<D>& c : world.details[i].contacts)
    if (c.with(Party::ball, j, 0, image)) mine = &c;
  if (mine == nullptr) return Touch::none;
  for (const Contact<D>& c : world.details[j].contacts)
    if (c.with(Party::ball, i, 0, back))
      return mine->acted && mine->own_stamp == a.stamp && mine->partner_stamp == b.stamp ? Touch::spent : Touch::live;
  return Touch::none;
}

}  // namespace carom
