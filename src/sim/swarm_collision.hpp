#pragma once
// What collisions of many balls have in common: restitution, what is written of them, and the watch for collapse.

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "carom/law/impact.hpp"
#include "carom/sim/collapse_reason.hpp"
#include "carom/sim/contact_rule.hpp"
#include "carom/sim/measures.hpp"
#include "carom/sim/recording.hpp"
#include "carom/sim/swarm_run.hpp"

namespace carom::detail {

template <int D>
Vec<double, D> vector(const double* x) {
  Vec<double, D> v;
  for (int k = 0; k < D; ++k) v[k] = x[k];
  return v;
}

/// TC model: as still_in_contact in contact_rule.hpp.
template <int D>
bool lasting(const SwarmRun<D>& run, std::uint32_t i, const Time<double>& t) {
  return (run.swarm.past[i].flags & Past::hit) != 0 && !infinite(run.swarm.kind(i).mass) &&
         elapsed(run.swarm.flights[i].time(), t) <= run.swarm.rest.contact_time;
}

template <int D>
double restitution(const SwarmRun<D>& run, const Impact<double, D>& impact, std::uint32_t i, std::uint32_t j,
                   const Time<double>& t) {
  const auto& world = run.swarm.rest;
  if (world.contact_time > 0 && (lasting(run, i, t) || lasting(run, j, t))) return 1;
  const std::uint32_t a = run.swarm.kind(i).material, b = run.swarm.kind(j).material;
  if (world.regularise == Regularise::viscoelastic) return restitution_at_speed(world, impact, world.viscoelastic.between(a, b));
  return world.restitution.between(a, b);
}

/// `flat`: balls that come to rest there do so by a rule of their own.
template <int D>
double restitution_at_wall(const SwarmRun<D>& run, const Impact<double, D>& impact, std::uint32_t i, std::uint32_t wall,
                           bool flat, const Time<double>& t) {
  const auto& world = run.swarm.rest;
  if (world.contact_time > 0 && !(flat && world.regularise == Regularise::rest) && lasting(run, i, t)) return 1;
  const std::uint32_t material = run.swarm.kind(i).material;
  if (world.regularise == Regularise::viscoelastic)
    return restitution_at_speed(world, impact, world.viscoelastic.at_wall(material, wall));
  return world.restitution.at_wall(material, wall);
}

/// Ball i is at x with velocity v from t on; gives the periods taken out.
template <int D>
Turns<D> write(SwarmRun<D>& run, std::uint32_t i, const Vec<double, D>& x, const Vec<double, D>& v, const Time<double>& t) {
  Flight<D>& flight = run.swarm.flights[i];
  Past& past = run.swarm.past[i];
  if (!run.swarm.reach.empty())
    for (int k = 0; k < D; ++k)
      run.swarm.reach[i] = std::max({run.swarm.reach[i], std::abs(flight.x[k]), std::abs(x[k])});
  Vec<double, D> at = x;
  const Turns<D> turns = wrap(run.swarm.rest.space, at);
  for (int k = 0; k < D; ++k) {
    flight.x[k] = at[k];
    flight.v[k] = v[k];
    past.image[k] += static_cast<std::int32_t>(turns[static_cast<std::size_t>(k)]);
  }
  flight.epoch = t.epoch;
  flight.offset = t.offset;
  ++run.swarm.stamp[i];
  return turns;
}

template <int D>
void fill(RecordParty<double, D>& party, const SwarmRun<D>& run, std::uint32_t i, bool hit, const Time<double>& before) {
  party.number = run.swarm.past[i].number;
  party.position = vector<D>(run.swarm.flights[i].x);
  for (int k = 0; k < D; ++k) party.image[static_cast<std::size_t>(k)] = run.swarm.past[i].image[k];
  party.previous_hit = hit ? before : Time<double>::never();
}

/// What an impact of balls a and b at t starts from; `image` is that of b relative to a.
template <int D>
Impact<double, D> impact_of(const SwarmRun<D>& run, std::uint32_t a, std::uint32_t b, const Vec<double, D>& xa,
                            const Vec<double, D>& xb, const Flight<D>& before_a, const Flight<D>& before_b,
                            const double* image) {
  Impact<double, D> impact;
  impact.va = vector<D>(before_a.v);
  impact.vb = vector<D>(before_b.v);
  impact.ma = run.swarm.kind(a).mass;
  impact.mb = run.swarm.kind(b).mass;
  impact.e = 1;
  for (int k = 0; k < D; ++k) {
    impact.r[static_cast<std::size_t>(k)] = wide_difference<double>(xb[k], xa[k]);
    if (run.swarm.rest.space.periodic())
      impact.r[static_cast<std::size_t>(k)] =
          impact.r[static_cast<std::size_t>(k)] + wide_product<double>(image[k], run.swarm.rest.space.edge[k]);
  }
  return impact;
}

template <int D>
Vec<double, D> flown_to(const Flight<D>& flight, const Time<double>& t) {
  const double s = elapsed(flight.time(), t);
  Vec<double, D> x;
  for (int k = 0; k < D; ++k) x[k] = flight.x[k] + flight.v[k] * s;
  return x;
}

/// `place(record)` adds where on a wall it was.
template <int D, class F>
void send(SwarmRun<D>& run, const Event<double, D>& event, const Impact<double, D>& impact, const Outcome<double, D>& outcome,
          double gap, std::uint32_t a, bool hit_a, const Time<double>& before_a, std::uint32_t b, bool hit_b,
          const Time<double>& before_b, F&& place) {
  Record<double, D> record = record_of(event, impact, outcome, gap, false);
  place(record);
  fill(record.ball, run, a, hit_a, before_a);
  record.partner.number = event.partner;
  if (event.kind == EventKind::ball_ball) fill(record.partner, run, b, hit_b, before_b);
  record.partner.velocity_before = impact.vb;
  record.partner.velocity_after = event.kind == EventKind::ball_ball ? outcome.vb : impact.vb;
  record.point = record.ball.position - record.normal * run.swarm.kind(a).radius;
  run.sink(run.sink_data, record);
}

/// What the watch for collapse makes of an impact of the balls `numbers`, the first of which is in row i.
template <int D>
void watch(SwarmRun<D>& run, const Impact<double, D>& impact, const Time<double>& t, double impulse, std::uint32_t i,
           std::initializer_list<std::uint32_t> numbers, Support support) {
  if (!run.watch.watching()) return;
  const double mass = std::min(impact.ma, impact.mb);
  const Vec<double, D> still = Vec<double, D>::Zero();
  const double reach = run.swarm.reach.empty() ? 0 : run.swarm.reach[i];
  const typename CollapseWatch<double>::Contact contact{
      t,
      impulse,
      mass * rounding_of_velocity(impact),
      mass * (unit_roundoff<double>() * std::max(reach, run.swarm.kind(i).radius)),
      impact.e < 1,
      (infinite(impact.ma) && impact.va != still) || (infinite(impact.mb) && impact.vb != still)};
  bool collapse = false;
  for (const std::uint32_t number : numbers) collapse = run.watch.collapses(number, numbers, contact) || collapse;
  if (!collapse) return;
  run.verdict = Halt::collapse;
  run.reason = collapse_reason(run.swarm.rest.regularise, support);
  run.reason_balls = numbers;
  for (const std::uint32_t number : numbers)
    for (const std::uint32_t p : run.watch.partners(number))
      if (std::find(run.reason_balls.begin(), run.reason_balls.end(), p) == run.reason_balls.end())
        run.reason_balls.push_back(p);
  std::sort(run.reason_balls.begin(), run.reason_balls.end());
}

}  // namespace carom::detail
