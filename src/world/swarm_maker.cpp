#include "carom/world/swarm_maker.hpp"

#include <cmath>
#include <utility>

#include "carom/core/page_vector.hpp"

namespace carom {
namespace {

constexpr std::size_t most_species = 1U << 16;

template <int D>
Alike alike(const Ball<double, D>& ball, const BallDetail<double, D>& detail) {
  return {ball.radius, detail.mass, detail.material, ball.fixed};
}

/// A ball's contacts are those that its last collision leaves behind.
template <int D>
bool ordinary(const Ball<double, D>& ball, const BallDetail<double, D>& detail) {
  if (!detail.last_hit.is_never() && detail.last_hit != ball.time) return false;
  if (!ball.in_contact) return true;
  if (detail.contacts.size() != 1) return false;
  const Contact<D>& c = detail.contacts[0];
  for (int k = 0; k < D; ++k)
    if (c.image[k] < -1 || c.image[k] > 1) return false;
  return c.acted && !c.left && c.own_stamp == ball.stamp && c.party == detail.last_party && c.partner == detail.last_partner &&
         c.feature == detail.last_feature;
}

/// Ball and detail of the balls of a gas, but for place and velocity.
template <int D>
std::pair<Ball<double, D>, BallDetail<double, D>> ball_of(const GasBalls& gas, const Time<double>& start) {
  std::pair<Ball<double, D>, BallDetail<double, D>> made;
  made.first.radius = gas.radius;
  made.first.time = start;
  made.second.mass = gas.mass;
  made.second.material = gas.material;
  return made;
}

}  // namespace

template <int D>
void SwarmJudge<D>::add(const Ball<double, D>& ball, const BallDetail<double, D>& detail) {
  fit_ = fit_ && ball.alive && ordinary(ball, detail) && ball.held == 0 && detail.body < 0 && ball.radius > 0;
  for (int k = 0; k < D; ++k) fit_ = fit_ && std::abs(detail.image[static_cast<std::size_t>(k)]) <= (1 << 30);
  if (!fit_) return;
  kinds_[alike(ball, detail)] = true;
  fit_ = kinds_.size() <= most_species;
}

template <int D>
SwarmMaker<D>::SwarmMaker(World<double, D>&& rest, std::size_t balls) {
  swarm_.rest = std::move(rest);
  swarm_.flights = PageArray<Flight<D>>(balls);
  swarm_.past = PageArray<Past>(balls);
  swarm_.stamp = PageArray<std::uint32_t>(balls);
  swarm_.row = PageArray<std::uint32_t>(balls);
  if (swarm_.rest.restitution.any_below_one()) swarm_.reach.resize(balls);
  for (int k = 0; k < D; ++k) {
    swarm_.lower[k] = swarm_.rest.space.lower[k];
    swarm_.edge[k] = swarm_.rest.space.edge[k];
    swarm_.per_edge[k] = 1 / swarm_.edge[k];
  }
}

template <int D>
void SwarmMaker<D>::add(std::uint32_t number, const Ball<double, D>& ball, const BallDetail<double, D>& detail) {
  const auto [kind, is_new] = kinds_.try_emplace(alike(ball, detail), static_cast<std::uint16_t>(swarm_.species.size()));
  if (is_new) swarm_.species.push_back({ball.radius, detail.mass, detail.material, ball.fixed});
  Flight<D>& flight = swarm_.flights[number];
  Past& past = swarm_.past[number];
  past = Past{};
  for (int k = 0; k < D; ++k) {
    flight.x[k] = ball.position[k];
    flight.v[k] = ball.velocity[k];
    past.image[k] = static_cast<std::int32_t>(detail.image[static_cast<std::size_t>(k)]);
  }
  flight.epoch = ball.time.epoch;
  flight.offset = ball.time.offset;
  swarm_.stamp[number] = ball.stamp;
  swarm_.row[number] = number;
  past.number = number;
  past.species = kind->second;
  past.flags = static_cast<std::uint8_t>((detail.last_hit.is_never() ? 0 : Past::hit) |
                                         (detail.last_party == Party::wall ? Past::last_was_wall : 0));
  past.last_partner = detail.last_partner;
  past.last_feature = detail.last_feature;
  if (ball.in_contact) {
    int image[D];
    for (int k = 0; k < D; ++k) image[k] = detail.contacts[0].image[k];
    past.flags |= Past::in_contact;
    past.contact_image = detail.last_party == Party::wall ? static_cast<std::uint8_t>(detail.contacts[0].side + 1)
                                                          : packed_image<D>(image);
    past.partner_stamp = detail.contacts[0].partner_stamp;
  }
  if (!swarm_.reach.empty()) swarm_.reach[number] = detail.reach;
  if (!detail.name.empty()) {
    swarm_.names.resize(swarm_.size());
    swarm_.names[number] = detail.name;
  }
}

template <int D>
Swarm<D> SwarmMaker<D>::finish() {
  return std::move(swarm_);
}

template <int D>
bool is_swarm(const World<double, D>& world) {
  SwarmJudge<D> judge;
  for (std::size_t i = 0; i < world.balls.size() && judge.fit(); ++i) judge.add(world.balls[i], world.details[i]);
  return judge.fit() && !world.balls.empty();
}

template <int D>
bool is_swarm(const WorldAndGases<D>& parts) {
  SwarmJudge<D> judge;
  const World<double, D>& world = parts.world;
  for (std::size_t i = 0; i < world.balls.size() && judge.fit(); ++i) judge.add(world.balls[i], world.details[i]);
  for (const GasBalls& gas : parts.gases) {
    const auto [ball, detail] = ball_of<D>(gas, world.start);
    judge.add(ball, detail);
  }
  return judge.fit() && parts.size() > 0;
}

template <int D>
Swarm<D> make_swarm(World<double, D>&& world) {
  return make_swarm(WorldAndGases<D>{std::move(world), {}});
}

template <int D>
Swarm<D> make_swarm(WorldAndGases<D>&& parts) {
  const std::size_t size = parts.size();
  const Time<double> start = parts.world.start;
  auto balls = std::move(parts.world.balls);
  auto details = std::move(parts.world.details);
  SwarmMaker<D> maker(std::move(parts.world), size);
  std::uint32_t number = 0;
  for (; number < balls.size(); ++number) maker.add(number, balls[number], details[number]);
  give_back(balls);
  give_back(details);
  for (GasBalls& gas : parts.gases) {
    auto [ball, detail] = ball_of<D>(gas, start);
    for (std::size_t i = 0; i < gas.position.size(); i += D) {
      for (int k = 0; k < D; ++k) {
        ball.position[k] = gas.position[i + static_cast<std::size_t>(k)];
        ball.velocity[k] = gas.velocity[i + static_cast<std::size_t>(k)];
      }
      maker.add(number++, ball, detail);
    }
    give_back(gas.position);
    give_back(gas.velocity);
  }
  return maker.finish();
}

template class SwarmJudge<2>;
template class SwarmJudge<3>;
template class SwarmMaker<2>;
template class SwarmMaker<3>;
template bool is_swarm(const World<double, 2>&);
template bool is_swarm(const World<double, 3>&);
template bool is_swarm(const WorldAndGases<2>&);
template bool is_swarm(const WorldAndGases<3>&);
template Swarm<2> make_swarm(World<double, 2>&&);
template Swarm<3> make_swarm(World<double, 3>&&);
template Swarm<2> make_swarm(WorldAndGases<2>&&);
template Swarm<3> make_swarm(WorldAndGases<3>&&);

}  // namespace carom
