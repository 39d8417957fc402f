#include "carom/observe/flights.hpp"

#include <cmath>

namespace carom {

Flights::Course Flights::course_at(std::uint32_t i, const Time<double>& t) const {
  Course c{subject_.position[i], subject_.velocity[i]};
  const double s = elapsed_time(from_[i], t);
  if (subject_.moves_freely(i) && subject_.magnetic != 0) {
    const Triple v = c.velocity;
    const double omega = subject_.magnetic, angle = omega * s, half = std::sin(angle / 2);
    const double along = std::sin(angle) / omega, across = 2 * half * half / omega;
    c.position = {c.position[0] + along * v[0] - across * v[1], c.position[1] + across * v[0] + along * v[1], 0};
    c.velocity = {std::cos(angle) * v[0] - std::sin(angle) * v[1], std::sin(angle) * v[0] + std::cos(angle) * v[1], 0};
    return c;
  }
  const Triple g = subject_.moves_freely(i) ? subject_.acceleration : Triple{};
  for (std::size_t k = 0; k < 3; ++k) {
    c.position[k] += s * (c.velocity[k] + s / 2 * g[k]);
    c.velocity[k] += s * g[k];
  }
  return c;
}

Triple Flights::place(const Collision::Party& party) const {
  Triple x = party.position;
  if (subject_.space == SpaceKind::periodic)
    for (std::size_t k = 0; k < 3; ++k) x[k] += static_cast<double>(party.image[k]) * subject_.edge[k];
  return x;
}

Flight Flights::flight(std::uint32_t i, const Time<double>& now, const Triple& to, bool hit) const {
  return {i,
          subject_.mass[i],
          subject_.velocity[i],
          subject_.acceleration,
          elapsed_time(measured_from_, from_[i]),
          elapsed_time(measured_from_, now),
          elapsed_time(from_[i], now),
          hit,
          subject_.magnetic,
          subject_.position[i],
          to};
}

void Flights::go_on(const Collision& c, const Time<double>& now) {
  const auto set = [&](const Collision::Party& party) {
    subject_.position[party.number] = place(party);
    subject_.velocity[party.number] = party.velocity_after;
    from_[party.number] = now;
  };
  set(c.ball);
  if (c.kind != EventKind::ball_ball) return;
  set(c.partner);
  if (!subject_.merging) return;
  subject_.mass[c.ball.number] += subject_.mass[c.partner.number];
  subject_.mass[c.partner.number] = 0;
  --subject_.free;
}

}  // namespace carom
