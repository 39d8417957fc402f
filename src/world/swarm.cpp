#include "carom/world/swarm.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/page_vector.hpp"

namespace carom {
namespace {

/// The bits of x with two zeros (one in the plane) between each and the next.
template <int D>
std::uint64_t spread_bits(std::uint64_t x) {
  std::uint64_t spread = 0;
  constexpr int bits = D == 2 ? 31 : 21;
  for (int b = 0; b < bits; ++b) spread |= (x >> b & 1U) << (D * b);
  return spread;
}

template <class T>
void permute(PageArray<T>& records, const PageVector<std::uint32_t>& from) {
  PageArray<T> sorted(records.size());
  for (std::size_t i = 0; i < from.size(); ++i) sorted[i] = records[from[i]];
  records = std::move(sorted);
}

}  // namespace

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
Contact<D> held_contact(const Swarm<D>& swarm, std::uint32_t i) {
  const Past& past = swarm.past[i];
  const bool wall = (past.flags & Past::last_was_wall) != 0;
  Contact<D> contact;
  contact.party = wall ? Party::wall : Party::ball;
  contact.partner = past.last_partner;
  contact.feature = past.last_feature;
  contact.acted = true;
  contact.own_stamp = swarm.stamp[i];
  contact.partner_stamp = past.partner_stamp;
  if (wall)
    contact.side = static_cast<std::int8_t>(past.contact_image - 1);
  else
    contact.image = unpacked_image<D>(past.contact_image);
  return contact;
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
  if ((past.flags & Past::in_contact) != 0) detail.contacts.push_back(held_contact(swarm, i));
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
Space<double, D> frame_of(const World<double, D>& world) {
  if (world.space.kind != SpaceKind::open) return world.space;
  Space<double, D> frame;
  frame.kind = SpaceKind::box;
  Vec<double, D> upper = Vec<double, D>::Zero();
  bool any = false;
  const auto widen = [&](const Vec<double, D>& x, double by) {
    for (int k = 0; k < D; ++k) {
      frame.lower[k] = any ? std::min(frame.lower[k], x[k] - by) : x[k] - by;
      upper[k] = any ? std::max(upper[k], x[k] + by) : x[k] + by;
    }
    any = true;
  };
  for (const auto& s : world.walls.spheres) widen(s.centre, s.radius);
  if constexpr (D == 2) {
    for (const auto& s : world.walls.segments) {
      widen(s.from, 0);
      widen(s.to, 0);
    }
    for (const auto& a : world.walls.arcs) widen(a.centre, a.radius);
  }
  frame.edge = upper - frame.lower;
  return frame;
}

template <int D>
void sort_rows(Swarm<D>& swarm, const Time<double>& t) {
  const std::uint32_t n = swarm.size();
  swarm.frame = frame_of(swarm.rest);
  const auto& space = swarm.frame;
  constexpr double cells = D == 2 ? 0x1p31 : 0x1p21;
  PageVector<std::uint32_t> from(n);
  {
    PageVector<std::pair<std::uint64_t, std::uint32_t>> keys(n);
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
  if (swarm.species.size() == 1) return;
  swarm.radius = PageArray<double>(n);
  for (std::uint32_t i = 0; i < n; ++i) swarm.radius[i] = swarm.kind(i).radius;
}

template Ball<double, 2> stored_ball(const Swarm<2>&, std::uint32_t);
template Ball<double, 3> stored_ball(const Swarm<3>&, std::uint32_t);
template BallDetail<double, 2> stored_detail(const Swarm<2>&, std::uint32_t);
template BallDetail<double, 3> stored_detail(const Swarm<3>&, std::uint32_t);
template Contact<2> held_contact(const Swarm<2>&, std::uint32_t);
template Contact<3> held_contact(const Swarm<3>&, std::uint32_t);
template World<double, 2> make_world(const Swarm<2>&);
template World<double, 3> make_world(const Swarm<3>&);
template Space<double, 2> frame_of(const World<double, 2>&);
template Space<double, 3> frame_of(const World<double, 3>&);
template void sort_rows(Swarm<2>&, const Time<double>&);
template void sort_rows(Swarm<3>&, const Time<double>&);

}  // namespace carom
