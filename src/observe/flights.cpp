#include "carom/observe/flights.hpp"

namespace carom {

Triple Flights::velocity_at(std::uint32_t i, const Time<double>& t) const {
  Triple v = subject_.velocity[i];
  if (!subject_.moves_freely(i)) return v;
  const double flown = elapsed_time(from_[i], t);
  for (std::size_t k = 0; k < v.size(); ++k) v[k] += flown * subject_.acceleration[k];
  return v;
}

Flight Flights::flight(std::uint32_t i, const Time<double>& now, bool hit) const {
  return {i,
          subject_.mass[i],
          subject_.velocity[i],
          subject_.acceleration,
          elapsed_time(measured_from_, from_[i]),
          elapsed_time(measured_from_, now),
          elapsed_time(from_[i], now),
          hit};
}

void Flights::go_on(const Collision& c, const Time<double>& now) {
  const auto set = [&](const Collision::Party& party) {
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
