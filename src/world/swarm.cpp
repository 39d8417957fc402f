#include "carom/world/swarm.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "carom/world/state.hpp"

namespace carom {
namespace {

constexpr std::size_t most_species = 1U << 16;

using Alike = std::tuple<double, double, std::uint32_t, bool>;

template <int D>
Alike alike(const World<double, D>& world, std::size_t i) {
  return {world.balls[i].radius, world.details[i].mass, world.details[i].material, world.balls[i].fixed};
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

/// The bits of x with two zeros (one in the plane) between each and the next.
template <int D>
std::uint64_t spread_bits(std::uint64_t x) {
  std::uint64_t spread = 0;
  constexpr int bits = D == 2 ? 31 : 21;
  for (int b = 0; b < bits; ++b) spread |= (x >> b & 1U) << (D * b);
  return spread;
}

template <class T>
void permute(PageArray<T>& records, const std::vector<std::uint32_t>& from) {
  PageArray<T> sorted(records.size());
  for (std::size_t i = 0; i < from.size(); ++i) sorted[i] = records[from[i]];
  records = std::move(sorted);
}

}  // namespace

template <int D>
bool is_swarm(const World<double, D>& world) {
  std::map<Alike, bool> kinds;
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    const auto& ball = world.balls[i];
    const auto& detail = world.details[i];
    if (!ball.alive || !ordinary(ball, detail) || ball.held != 0 || detail.body >= 0 || !(ball.radius > 0)) return false;
    if (kinds.size() <= most_species) kinds[alike(world, i)] = true;
    for (int k = 0; k < D; ++k)
      if (std::abs(detail.image[static_cast<std::size_t>(k)]) > (1 << 30)) return false;
  }
  return !world.balls.empty() && kinds.size() <= most_species;
}

template <int D>
Swarm<D> make_swarm(World<double, D>&& world) {
  Swarm<D> swarm;
  const std::size_t n = world.balls.size();
  const bool dissipates = world.restitution.any_below_one();
  std::map<Alike, std::uint16_t> kinds;

  swarm.past = PageArray<Past>(n);
  swarm.stamp = PageArray<std::uint32_t>(n);
  if (dissipates) swarm.reach.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const BallDetail<double, D>& detail = world.details[i];
    const auto [kind, is_new] = kinds.try_emplace(alike(world, i), static_cast<std::uint16_t>(swarm.species.size()));
    if (is_new)
      swarm.species.push_back({world.balls[i].radius, detail.mass, detail.material, world.balls[i].fixed});
    Past& past = swarm.past[i];
    past = Past{};
    for (int k = 0; k < D; ++k) past.image[k] = static_cast<std::int32_t>(detail.image[static_cast<std::size_t>(k)]);
    swarm.stamp[i] = world.balls[i].stamp;
    past.number = static_cast<std::uint32_t>(i);
    past.species = kind->second;
    past.flags = static_cast<std::uint8_t>((detail.last_hit.is_never() ? 0 : Past::hit) |
                                           (detail.last_party == Party::wall ? Past::last_was_wall : 0));
    past.last_partner = detail.last_partner;
    past.last_feature = detail.last_feature;
    if (world.balls[i].in_contact) {
      int image[D];
      for (int k = 0; k < D; ++k) image[k] = detail.contacts[0].image[k];
      past.flags |= Past::in_contact;
      past.contact_image = packed_image<D>(image);
      past.partner_stamp = detail.contacts[0].partner_stamp;
    }
    if (dissipates) swarm.reach[i] = detail.reach;
    if (!detail.name.empty()) {
      swarm.names.resize(n);
      swarm.names[i] = detail.name;
    }
  }
  world.details = {};

  swarm.flights = PageArray<Flight<D>>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Ball<double, D>& ball = world.balls[i];
    Flight<D>& flight = swarm.flights[i];
    for (int k = 0; k < D; ++k) {
      flight.x[k] = ball.position[k];
      flight.v[k] = ball.velocity[k];
    }
    flight.epoch = ball.time.epoch;
    flight.offset = ball.time.offset;
  }
  world.balls = {};
  swarm.rest = std::move(world);
  for (int k = 0; k < D; ++k) {
    swarm.lower[k] = swarm.rest.space.lower[k];
    swarm.edge[k] = swarm.rest.space.edge[k];
    swarm.per_edge[k] = 1 / swarm.edge[k];
  }

  swarm.row = PageArray<std::uint32_t>(n);
  for (std::size_t i = 0; i < n; ++i) swarm.row[i] = static_cast<std::uint32_t>(i);
  return swarm;
}

template <int D>
Ball<double, D> stored_ball(const Swarm<D>& swarm, std::uint32_t number) {
  const std::uint32_t i = swarm.row[number];
  const Species& kind = swarm.kind(i);
  Ball<double, D> ball;
  for (int k = 0; k < D; ++k) {
    ball.position[k] = swarm.flights[i].x[k];
    ball.velocity[k] = swarm.flights[i].v[k];
  }
  ball.time = swarm.flights[i].time();
  ball.radius = kind.radius;
  ball.fixed = kind.fixed;
  ball.stamp = swarm.stamp[i];
  ball.in_contact = (swarm.past[i].flags & Past::in_contact) != 0;
  return ball;
}

template <int D>
BallDetail<double, D> stored_detail(const Swarm<D>& swarm, std::uint32_t number) {
  const std::uint32_t i = swarm.row[number];
  const Past& past = swarm.past[i];
  const Species& kind = swarm.kind(i);
  BallDetail<double, D> detail;
  detail.mass = kind.mass;
  detail.material = kind.material;
  for (int k = 0; k < D; ++k) detail.image[static_cast<std::size_t>(k)] = past.image[k];
  if (!swarm.reach.empty()) detail.reach = swarm.reach[i];
  const bool wall = (past.flags & Past::last_was_wall) != 0;
  if ((past.flags & Past::hit) != 0) detail.last_hit = swarm.flights[i].time();
  detail.last_party = wall ? Party::wall : Party::ball;
  detail.last_partner = past.last_partner;
  detail.last_feature = past.last_feature;
  if ((past.flags & Past::in_contact) != 0) {
    Contact<D> contact;
    contact.party = detail.last_party;
    contact.partner = past.last_partner;
    contact.feature = past.last_feature;
    contact.acted = true;
    contact.own_stamp = swarm.stamp[i];
    contact.partner_stamp = past.partner_stamp;
    contact.image = unpacked_image<D>(past.contact_image);
    detail.contacts.push_back(contact);
  }
  if (!swarm.names.empty()) detail.name = swarm.names[number];
  return detail;
}

template <int D>
World<double, D> make_world(const Swarm<D>& swarm) {
  World<double, D> world = swarm.rest;
  world.balls.reserve(swarm.size());
  world.details.reserve(swarm.size());
  for (std::uint32_t number = 0; number < swarm.size(); ++number) {
    world.balls.push_back(stored_ball(swarm, number));
    world.details.push_back(stored_detail(swarm, number));
  }
  return world;
}

template <int D>
void sort_rows(Swarm<D>& swarm, const Time<double>& t) {
  const std::uint32_t n = swarm.size();
  const auto& space = swarm.rest.space;
  constexpr double cells = D == 2 ? 0x1p31 : 0x1p21;
  std::vector<std::uint32_t> from(n);
  {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(n);
    for (std::uint32_t i = 0; i < n; ++i) {
      const Flight<D>& flight = swarm.flights[i];
      const double flown = elapsed(flight.time(), t);
      std::uint64_t key = 0;
      for (int k = 0; k < D; ++k) {
        double share = (flight.x[k] + flight.v[k] * flown - space.lower[k]) / space.edge[k];
        share = std::clamp(share - (space.periodic() ? std::floor(share) : 0), 0.0, 0x1.fffffp-1);
        key |= spread_bits<D>(static_cast<std::uint64_t>(share * cells)) << k;
      }
      keys[i] = {key, i};
    }
    std::sort(keys.begin(), keys.end());
    for (std::uint32_t i = 0; i < n; ++i) from[i] = keys[i].second;
  }
  permute(swarm.flights, from);
  permute(swarm.past, from);
  permute(swarm.stamp, from);
  if (!swarm.reach.empty()) {
    std::vector<double> sorted(n);
    for (std::uint32_t i = 0; i < n; ++i) sorted[i] = swarm.reach[from[i]];
    swarm.reach = std::move(sorted);
  }
  for (std::uint32_t i = 0; i < n; ++i) swarm.row[swarm.past[i].number] = i;
}

template bool is_swarm(const World<double, 2>&);
template bool is_swarm(const World<double, 3>&);
template Swarm<2> make_swarm(World<double, 2>&&);
template Swarm<3> make_swarm(World<double, 3>&&);
template Ball<double, 2> stored_ball(const Swarm<2>&, std::uint32_t);
template Ball<double, 3> stored_ball(const Swarm<3>&, std::uint32_t);
template BallDetail<double, 2> stored_detail(const Swarm<2>&, std::uint32_t);
template BallDetail<double, 3> stored_detail(const Swarm<3>&, std::uint32_t);
template World<double, 2> make_world(const Swarm<2>&);
template World<double, 3> make_world(const Swarm<3>&);
template void sort_rows(Swarm<2>&, const Time<double>&);
template void sort_rows(Swarm<3>&, const Time<double>&);

}  // namespace carom
