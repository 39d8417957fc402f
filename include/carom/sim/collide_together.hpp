#pragma once
// The collision of several contacts at one moment: resolve them as one cluster, write what has changed, keep the books.

#include <algorithm>

#include "carom/sim/collision.hpp"

namespace carom {

template <Motion M>
template <class Sink>
Verdict Collider<M>::collide_together(WorldType& world, const M& motion,
                                      const std::vector<TouchingContact<Real, D>>& found, Sink&& sink) {
  moved_.clear();
  const Time<Real> now = found.front().event.time;
  const Together<Real, D> all = together(world, motion, found, now);
  const ClusterOutcome<Real, D> outcome = resolve_to_rounding(all.cluster);
  std::vector<std::uint32_t> balls;
  for (const auto& m : all.members) balls.push_back(m.ball);
  std::sort(balls.begin(), balls.end());
  if (!outcome.crushed.empty())
    return stop(Verdict::collapse, "balls are crushed: no finite impulse keeps them apart", balls);
  if (!outcome.cut_short.empty())
    return stop(Verdict::collapse, "balls that touch exchange impulses without end", balls);

  std::vector<Turns<D>> images;
  for (const auto& m : all.members) images.push_back(world.details[m.ball].image);
  for (std::size_t k = 0; k < all.members.size(); ++k) {
    const auto& m = all.members[k];
    const auto meets = [k](const auto& c) { return !c.held && (c.a == k || c.b == k); };
    const Vector& v = outcome.velocities[m.body];
    if (v == m.velocity && std::none_of(all.contacts.begin(), all.contacts.end(), meets)) continue;
    if (detail::infinite(world.body_mass(m.ball)) && world.balls[m.ball].fixed) continue;
    sides_.note(world, m.ball);
    write_motion(world, motion, m.ball, m.position, v, now, moved_);
    sides_.keep(world, m.ball, Vector(v - m.velocity));
    note_potential(world, m.ball);
  }
  for (std::size_t k = 0; k < all.contacts.size(); ++k) {
    const auto& unfinished = outcome.unfinished;
    const bool acted = std::find(unfinished.begin(), unfinished.end(), k) == unfinished.end();
    hold_together(world, all.contacts[k], images, now, acted);
  }

  book(books, Outcome<Real, D>{{}, {}, Real(0), outcome.dissipated, outcome.injected});
  Verdict verdict = Verdict::go_on;
  bool first = true;
  for (std::size_t k = 0; k < all.contacts.size(); ++k) {
    const auto& c = all.contacts[k];
    const Real& impulse = outcome.impulses[k];
    if (c.held && impulse == 0) continue;
    exactness.unresolved += c.event.unresolved;
    exactness.singular += c.singular;
    const Outcome<Real, D> share{outcome.velocities[all.members[c.a].body],
                                 c.b == all.none ? c.impact.vb : outcome.velocities[all.members[c.b].body], impulse,
                                 first ? outcome.dissipated : W(Real(0)), first ? outcome.injected : W(Real(0))};
    first = false;
    const Verdict one = count_together(world, all, c, share, sink);
    if (one != Verdict::go_on) verdict = one;
  }
  return verdict;
}

/// Parties that were both written now hold their contact: as spent if it has `acted` to the end.
template <Motion M>
void Collider<M>::hold_together(WorldType& world, const typename Together<Real, D>::Contact& c,
                                const std::vector<Turns<D>>& images, const Time<Real>& now, bool acted) {
  const std::uint32_t i = c.event.ball, j = c.event.partner;
  if (world.balls[i].time != now) return;
  if (c.event.kind == EventKind::ball_wall) {
    hold_contact(world, i,
                 Contact<D>{Party::wall, j, c.event.feature, image_since(world, i, c.event.image, images[c.a]), c.event.side,
                            acted, world.balls[i].stamp, 0});
  } else if (world.balls[j].time == now) {
    hold_pair(world, i, j, c.event.image, images[c.a], images[c.b], acted);
  }
}

/// A member may not have been written: its motion goes on.
template <Motion M>
void Collider<M>::fill_member(RecordParty<Real, D>& party, const WorldType& world,
                              const typename Together<Real, D>::Member& m, const Time<Real>& now) {
  fill_party(party, world, m.ball, m.previous_hit);
  if (world.balls[m.ball].time == now) return;
  party.position = m.position;
  const Turns<D> turns = wrap(world.space, party.position);
  for (int k = 0; k < D; ++k) party.image[k] += turns[k];
}

template <Motion M>
template <class Sink>
Verdict Collider<M>::count_together(WorldType& world, const Together<Real, D>& all,
                                    const typename Together<Real, D>::Contact& c, const Outcome<Real, D>& share,
                                    Sink&& sink) {
  const Event<Real, D>& event = c.event;
  const bool pair = event.kind == EventKind::ball_ball;
  BallDetail<Real, D>& a = world.details[event.ball];
  bool tie = is_tie(a, event.time, pair ? Party::ball : Party::wall, event.partner, event.feature);
  remember(a, event.time, pair ? Party::ball : Party::wall, event.partner, event.feature);
  if (pair) {
    BallDetail<Real, D>& b = world.details[event.partner];
    tie = tie || is_tie(b, event.time, Party::ball, event.ball, 0);
    remember(b, event.time, Party::ball, event.ball, 0);
  }
  (pair ? counts.ball_ball : counts.ball_wall) += 1;
  counts.ties += tie;
  const Real gap = note_gap(exactness, c.gap, c.radii);
  if constexpr (std::remove_cvref_t<Sink>::wants_records) {
    Record<Real, D> record = record_of(event, c.impact, share, gap, tie);
    fill_member(record.ball, world, all.members[c.a], event.time);
    if (pair) {
      fill_member(record.partner, world, all.members[c.b], event.time);
    } else {
      record.partner.number = event.partner;
    }
    record.partner.velocity_before = c.impact.vb;
    record.partner.velocity_after = share.vb;
    record.point = all.members[c.a].position - record.normal * world.balls[event.ball].radius;
    if (!pair) note_place(world, event, all.members[c.a].position, record);
    sink(record);
  }
  if (!finite(share.va) || !finite(share.vb))
    return stop(Verdict::non_finite, "a velocity is no longer a finite number", {event.ball});
  if (pair) return watch_contact(world, c.impact, event.time, {event.ball, event.partner}, share.impulse, Support::ball);
  return watch_contact(world, c.impact, event.time, {event.ball}, share.impulse, Support::corner);
}

}  // namespace carom
