#pragma once
// Contacts that act at one moment, as a cluster of bodies for law/simultaneous.hpp.

#include <algorithm>
#include <limits>
#include <vector>

#include "carom/law/simultaneous.hpp"
#include "carom/predict/event.hpp"
#include "carom/sim/contact_rule.hpp"
#include "carom/sim/measures.hpp"
#include "carom/sim/touching.hpp"
#include "carom/sim/wall_party.hpp"
#include "carom/sim/wall_touch.hpp"
#include "carom/world/state.hpp"

namespace carom {

/// Balls and walls of a cluster, with the numbers that they have in the world.
template <class Real, int D>
struct Together {
  /// A ball at the moment, before.
  struct Member {
    std::uint32_t ball = 0;
    std::size_t body = 0;  ///< in the cluster
    Vec<Real, D> position, velocity;
    Time<Real> previous_hit;
  };
  /// A contact at the moment, before.
  struct Contact {
    Event<Real, D> event;
    bool held = false;         ///< by state alone
    std::size_t a = 0, b = 0;  ///< members; b of a wall: none
    Impact<Real, D> impact;
    Real gap = Real(0), radii = Real(0);
    bool singular = false;  ///< a point at a vertex
  };
  static constexpr std::size_t none = ~std::size_t{0};

  std::vector<Member> members;
  std::vector<Contact> contacts;
  Cluster<Real, D> cluster;  ///< its contacts in the order of `contacts`
};

namespace detail {

template <Motion M>
class TogetherMaker {
 public:
  using Real = typename M::Real;
  static constexpr int D = M::dimension;
  using Result = Together<Real, D>;

  TogetherMaker(const World<Real, D>& world, const M& motion, const Time<Real>& now)
      : world_(world), motion_(motion), now_(now) {}

  [[nodiscard]] Result make(const std::vector<TouchingContact<Real, D>>& found) {
    for (const auto& [e, held] : found) {
      typename Result::Contact contact;
      contact.event = e;
      contact.held = held;
      contact.a = member(e.ball);
      contact.b = e.kind == EventKind::ball_ball ? member(e.partner) : Result::none;
      if (e.kind == EventKind::ball_ball) {
        meet_ball(contact);
      } else if (!meet_wall(contact)) {
        continue;
      }
      result_.contacts.push_back(std::move(contact));
    }
    return std::move(result_);
  }

 private:
  using W = Wide<Real>;
  using Vector = Vec<Real, D>;

  [[nodiscard]] std::size_t member(std::uint32_t ball) {
    auto& members = result_.members;
    const auto found =
        std::find_if(members.begin(), members.end(), [ball](const auto& m) { return m.ball == ball; });
    if (found != members.end()) return static_cast<std::size_t>(found - members.begin());
    members.push_back({ball, result_.cluster.bodies.size(), position_at(motion_, world_, ball, now_),
                       velocity_at(motion_, world_, ball, now_), world_.details[ball].last_hit});
    result_.cluster.bodies.push_back({world_.body_mass(ball), members.back().velocity});
    return members.size() - 1;
  }

  void meet_ball(typename Result::Contact& c) {
    const auto &a = result_.members[c.a], &b = result_.members[c.b];
    Impact<Real, D>& impact = c.impact;
    for (int k = 0; k < D; ++k) {
      impact.r[k] = wide_difference<Real>(b.position[k], a.position[k]);
      if (world_.space.periodic())
        impact.r[k] = impact.r[k] + wide_product<Real>(Real(c.event.image[k]), world_.space.edge[k]);
    }
    c.radii = world_.balls[a.ball].radius + world_.balls[b.ball].radius;
    c.gap = gap_of_pair<Real>(impact.r, c.radii);
    if constexpr (D == 1) impact.r[0] = W(Real(side_on_line(world_, a.ball, b.ball, c.event.image)));
    impact.va = a.velocity;
    impact.vb = b.velocity;
    impact.ma = world_.body_mass(a.ball);
    impact.mb = world_.body_mass(b.ball);
    impact.e = restitution_of_pair(world_, impact, a.ball, b.ball, now_);
    result_.cluster.contacts.push_back({a.body, b.body, impact.r, impact.e});
  }

  /// False for a point at rest at a vertex: there is no direction to act in.
  [[nodiscard]] bool meet_wall(typename Result::Contact& c) {
    const auto& a = result_.members[c.a];
    Impact<Real, D>& impact = c.impact;
    impact.va = a.velocity;
    impact.ma = world_.body_mass(a.ball);
    impact.mb = infinity<Real>();
    c.radii = world_.balls[a.ball].radius;
    bool flat = false;
    with_wall(world_, c.event.partner, c.event.feature, c.event.image, [&](const auto& shape, const auto& placed) {
      impact.vb = wall_velocity(world_, shape, now_);
      const Vector at = a.position - wall_drift(world_, shape, now_);
      const WallTouch<Real, D> place = touch_at<Real, D>(placed, at, c.radii, c.event.side);
      impact.r = place.into_wall;
      c.singular = place.singular;
      if (c.singular)
        for (int k = 0; k < D; ++k) impact.r[k] = W(Real(impact.va[k] - impact.vb[k]));
      c.gap = place.gap;
      flat = flat_number(world_.walls, shape) != 0;
    });
    if (c.singular && impact.va == impact.vb) return false;
    impact.e = restitution_at_wall(world_, impact, a.ball, c.event.partner, flat, now_);
    result_.cluster.contacts.push_back({a.body, result_.cluster.bodies.size(), impact.r, impact.e});
    result_.cluster.bodies.push_back({impact.mb, impact.vb});
    return true;
  }

  const World<Real, D>& world_;
  const M& motion_;
  const Time<Real>& now_;
  Result result_;
};

}  // namespace detail

/// A contact closes faster than the rounding of the two velocities explains.
template <class Real, int D>
[[nodiscard]] inline bool still_closes(const typename Cluster<Real, D>::Contact& contact, const Vec<Real, D>& va,
                                       const Vec<Real, D>& vb) {
  using std::abs;
  Wide<Real> closing(Real(0));
  Real size(0);
  for (int k = 0; k < D; ++k) {
    closing = closing + wide_difference<Real>(va[k], vb[k]) * contact.r[k];
    size += (abs(va[k]) + abs(vb[k])) * abs(narrow(contact.r[k]));
  }
  return narrow(closing) > 2 * unit_roundoff<Real>() * size;
}

/// resolve_cluster, refined: masses far apart make its equations so ill-conditioned that contacts may still close
/// afterwards. What they close with is then resolved as a plastic cluster of its own, at most `most_refinements` times.
template <class Real, int D>
[[nodiscard]] ClusterOutcome<Real, D> resolve_to_rounding(Cluster<Real, D> cluster) {
  constexpr int most_refinements = 3;
  ClusterOutcome<Real, D> out = resolve_cluster(cluster);
  if (!out.crushed.empty() || !out.cut_short.empty() || !out.unfinished.empty()) return out;
  for (int n = 0; n < most_refinements; ++n) {
    const auto closes = [&](const auto& c) { return still_closes<Real, D>(c, out.velocities[c.a], out.velocities[c.b]); };
    if (std::none_of(cluster.contacts.begin(), cluster.contacts.end(), closes)) break;
    for (std::size_t b = 0; b < cluster.bodies.size(); ++b) cluster.bodies[b].velocity = out.velocities[b];
    for (auto& contact : cluster.contacts) contact.e = Real(0);
    const ClusterOutcome<Real, D> rest = resolve_cluster(cluster);
    if (!rest.crushed.empty()) break;
    out.velocities = rest.velocities;
    for (std::size_t k = 0; k < out.impulses.size(); ++k) out.impulses[k] += rest.impulses[k];
    out.dissipated = out.dissipated + rest.dissipated;
    out.injected = out.injected + rest.injected;
  }
  return out;
}

/// The cluster that the contacts `found`, all at the time `now`, make.
template <Motion M>
[[nodiscard]] Together<typename M::Real, M::dimension> together(
    const World<typename M::Real, M::dimension>& world, const M& motion,
    const std::vector<TouchingContact<typename M::Real, M::dimension>>& found, const Time<typename M::Real>& now) {
  return detail::TogetherMaker<M>(world, motion, now).make(found);
}

}  // namespace carom
