#include "carom/observe/course.hpp"

#include <algorithm>
#include <limits>

namespace carom {

Course::Course(const Scene& scene, const Simulation& simulation) : subject_(subject_of(scene, simulation)) {
  for (const BallState& b : simulation.balls()) {
    Leg leg{simulation.time(), {}, {}};
    std::copy(b.unwrapped_position.begin(), b.unwrapped_position.end(), leg.position.begin());
    std::copy(b.velocity.begin(), b.velocity.end(), leg.velocity.begin());
    paths_.push_back({leg});
    fixed_.push_back(b.index < scene.balls.size() && scene.balls[b.index].fixed);
  }
}

void Course::add(const Collision& c) {
  meetings_.push_back({c.time, c.kind, c.ball.number, c.partner.number, c.impulse});
  add(c.ball, c.time);
  if (c.kind == EventKind::ball_ball) add(c.partner, c.time);
  if (c.dissipated != 0 || c.injected != 0) keeps_energy_ = false;
}

void Course::add(const Collision::Party& party, double time) {
  if (fixed_[party.number]) return;
  Leg leg{time, party.position, party.velocity_after};
  if (subject_.space == SpaceKind::periodic)
    for (std::size_t k = 0; k < 3; ++k) leg.position[k] += static_cast<double>(party.image[k]) * subject_.edge[k];
  std::vector<Leg>& path = paths_[party.number];
  if (path.back().time == time) {
    path.back() = leg;
  } else {
    path.push_back(leg);
  }
}

Place Course::at(std::uint32_t ball, double t) const {
  const std::vector<Leg>& path = paths_[ball];
  const auto after =
      std::upper_bound(path.begin(), path.end(), t, [](double time, const Leg& leg) { return time < leg.time; });
  const Leg& leg = after == path.begin() ? path.front() : *(after - 1);
  if (fixed_[ball]) return {leg.position, leg.velocity};
  const double s = t - leg.time;
  Place place;
  for (std::size_t k = 0; k < 3; ++k) {
    const double g = subject_.acceleration[k];
    place.position[k] = leg.position[k] + s * (leg.velocity[k] + 0.5 * g * s);
    place.velocity[k] = leg.velocity[k] + g * s;
  }
  return place;
}

std::int64_t Course::meetings_until(double t) const {
  const auto after =
      std::upper_bound(meetings_.begin(), meetings_.end(), t, [](double time, const Meeting& m) { return time < m.time; });
  return after - meetings_.begin();
}

double Course::extent() const {
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::vector<Leg>& path : paths_)
      for (const Leg& leg : path) {
        low = std::min(low, leg.position[k]);
        high = std::max(high, leg.position[k]);
      }
    longest = std::max(longest, high - low);
  }
  return longest;
}

}  // namespace carom
