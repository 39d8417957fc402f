#include "carom/sim/swarm_run.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "carom/law/impact.hpp"
#include "carom/sim/collapse_reason.hpp"
#include "carom/sim/contact_rule.hpp"
#include "carom/sim/measures.hpp"
#include "carom/sim/recording.hpp"
#include "carom/solve/quadratic.hpp"
#include "machine.hpp"
#include "swarm_targets.hpp"

namespace carom {
namespace detail {
namespace {

/// What orders events of one moment (precedes, predict/event.hpp): kind, ball, partner, feature.
using Place = std::tuple<EventKind, std::uint32_t, std::uint32_t, std::int32_t>;

template <int D>
Place place_of(const SwarmRun<D>& run, std::uint32_t i, std::uint32_t partner) {
  const std::uint32_t a = run.swarm.past[i].number;
  if (partner >= run.swarm.size()) {
    const auto& faces = run.swarm.rest.walls.faces;
    const std::size_t f = partner - Slot::wall;
    if (partner < Slot::wall || f >= faces.size()) return {EventKind::none, a, 0, 0};
    return {EventKind::ball_wall, a, index(faces[f].wall), faces[f].feature};
  }
  const std::uint32_t b = run.swarm.past[partner].number;
  return {EventKind::ball_ball, std::min(a, b), std::max(a, b), 0};
}

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

template <int D>
double restitution_at_face(const SwarmRun<D>& run, const Impact<double, D>& impact, std::uint32_t i, std::uint32_t wall,
                           const Time<double>& t) {
  const auto& world = run.swarm.rest;
  if (world.contact_time > 0 && world.regularise != Regularise::rest && lasting(run, i, t)) return 1;
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

template <int D>
void send(SwarmRun<D>& run, const Event<double, D>& event, const Impact<double, D>& impact, const Outcome<double, D>& outcome,
          double gap, std::uint32_t a, bool hit_a, const Time<double>& before_a, std::uint32_t b, bool hit_b,
          const Time<double>& before_b, const Face<double, D>* face = nullptr) {
  Record<double, D> record = record_of(event, impact, outcome, gap, false);
  if (face != nullptr) fill_place(record, *face, vector<D>(run.swarm.flights[a].x), run.swarm.kind(a).radius, event.side);
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

template <int D>
std::uint8_t unmoved_image() {
  const int none[D] = {};
  return packed_image<D>(none);
}

template <int D>
bool collide_with_face(SwarmRun<D>& run, std::uint32_t i, const Face<double, D>& face, const Time<double>& t) {
  const Flight<D> before = run.swarm.flights[i];
  const bool hit = (run.swarm.past[i].flags & Past::hit) != 0;
  Impact<double, D> impact;
  impact.va = vector<D>(before.v);
  impact.vb = Vec<double, D>::Zero();
  impact.ma = run.swarm.kind(i).mass;
  impact.mb = infinity<double>();
  if (infinite(impact.ma)) return false;
  const Vec<double, D> x = flown_to(before, t);
  const Vec<double, D> n = face.normal(x);
  for (int k = 0; k < D; ++k) impact.r[static_cast<std::size_t>(k)] = DoubleDouble(-n[k]);
  const double radius = run.swarm.kind(i).radius;
  const double gap = note_gap(run.exactness, face.gap(x) - radius, radius);
  const std::uint32_t wall = index(face.wall);
  impact.e = restitution_at_face(run, impact, i, wall, t);
  const Outcome<double, D> outcome = resolve_impact(impact);
  write(run, i, x, outcome.va, t);
  Past& past = run.swarm.past[i];
  past.flags = Past::hit | Past::in_contact | Past::last_was_wall;
  past.contact_image = unmoved_image<D>();
  past.last_partner = wall;
  past.last_feature = face.feature;
  past.partner_stamp = 0;
  ++run.counts.ball_wall;
  book(run.books, outcome);
  if (run.sink != nullptr) {
    Event<double, D> event;
    event.time = t;
    event.kind = EventKind::ball_wall;
    event.ball = run.swarm.past[i].number;
    event.partner = wall;
    event.feature = face.feature;
    send(run, event, impact, outcome, gap, i, hit, before.time(), i, false, before.time(), &face);
  }
  for (int k = 0; k < D; ++k)
    if (!(outcome.va[k] - outcome.va[k] == 0)) run.verdict = Halt::non_finite;
  if (run.verdict == Halt::until) watch(run, impact, t, outcome.impulse, i, {run.swarm.past[i].number}, Support::corner);
  return true;
}

}  // namespace

template <int D>
double careful_flight(const SwarmRun<D>& run, std::uint32_t i, std::uint32_t j, const double* image, const double* r,
                      const double* v, double sigma) {
  const Past&a = run.swarm.past[i], &b = run.swarm.past[j];
  constexpr std::uint8_t held = Past::in_contact | Past::last_was_wall;
  bool same_image = true;
  const Image<D> contact = unpacked_image<D>(a.contact_image);
  for (int k = 0; k < D; ++k) same_image = same_image && static_cast<double>(contact[k]) == image[k];
  if (same_image && (a.flags & held) == Past::in_contact && (b.flags & held) == Past::in_contact &&
      a.last_partner == run.swarm.past[j].number && b.last_partner == run.swarm.past[i].number &&
      run.swarm.flights[i].time() == run.swarm.flights[j].time()) {
    if (a.partner_stamp == run.swarm.stamp[j] && b.partner_stamp == run.swarm.stamp[i]) return never<double>();
    double approach = r[0] * v[0];
    for (int k = 1; k < D; ++k) approach += r[k] * v[k];
    return approach < 0 ? 0.0 : never<double>();
  }
  return meet_time<double, D>(vector<D>(r), vector<D>(v), sigma);
}

template <int D>
bool first_at_a_tie(const SwarmRun<D>& run, std::uint32_t i, std::uint32_t p, std::uint32_t q) {
  return place_of(run, i, p) < place_of(run, i, q);
}

template <int D>
bool first_due_at_a_tie(const SwarmRun<D>& run, std::uint32_t i, std::uint32_t k) {
  const auto place = [&run](std::uint32_t b) {
    const Slot& slot = run.shells.slots[b];
    return slot.exit_first() ? Place{EventKind::bookkeeping, run.swarm.past[b].number, 0, 0} : place_of(run, b, slot.partner);
  };
  return place(i) < place(k);
}

int wrap_coordinate(double lower, double edge, double& x) {
  Space<double, 1> space{SpaceKind::periodic, Vec<double, 1>(lower), Vec<double, 1>(edge)};
  Vec<double, 1> at(x);
  const Turns<1> turns = wrap(space, at);
  x = at[0];
  return static_cast<int>(turns[0]);
}

template <int D>
bool collide_carefully(SwarmRun<D>& run, std::uint32_t i, std::uint32_t partner, const Time<double>& t) {
  if (partner >= Slot::wall) return collide_with_face(run, i, run.swarm.rest.walls.faces[partner - Slot::wall], t);
  const bool ordered = run.swarm.past[i].number < run.swarm.past[partner].number;
  const std::uint32_t a = ordered ? i : partner, b = ordered ? partner : i;
  const Flight<D> before_a = run.swarm.flights[a], before_b = run.swarm.flights[b];
  Past&pa = run.swarm.past[a], &pb = run.swarm.past[b];
  const bool hit_a = (pa.flags & Past::hit) != 0, hit_b = (pb.flags & Past::hit) != 0;
  const Vec<double, D> xa = flown_to(before_a, t), xb = flown_to(before_b, t);
  double image[D] = {};
  if (run.swarm.rest.space.periodic())
    for (int k = 0; k < D; ++k) image[k] = std::nearbyint((xa[k] - xb[k]) / run.swarm.rest.space.edge[k]);
  Impact<double, D> impact = impact_of(run, a, b, xa, xb, before_a, before_b, image);
  if (infinite(impact.ma) && infinite(impact.mb)) return false;
  const double sigma = run.swarm.kind(a).radius + run.swarm.kind(b).radius;
  const double gap = note_gap(run.exactness, gap_of_pair<double>(impact.r, sigma), sigma);
  impact.e = restitution(run, impact, a, b, t);
  const Outcome<double, D> outcome = resolve_impact(impact);
  const Turns<D> turns_a = write(run, a, xa, outcome.va, t), turns_b = write(run, b, xb, outcome.vb, t);
  int image_ab[D], image_ba[D];
  for (int k = 0; k < D; ++k) {
    const std::size_t m = static_cast<std::size_t>(k);
    image_ab[k] = static_cast<int>(image[k]) + static_cast<int>(turns_b[m] - turns_a[m]);
    image_ba[k] = -image_ab[k];
  }
  const auto remember = [](Past& past, std::uint32_t other, std::uint32_t stamp, const int(&turns)[D]) {
    past.flags = Past::hit | Past::in_contact;
    past.contact_image = packed_image<D>(turns);
    past.last_partner = other;
    past.last_feature = 0;
    past.partner_stamp = stamp;
  };
  remember(pa, run.swarm.past[b].number, run.swarm.stamp[b], image_ab);
  remember(pb, run.swarm.past[a].number, run.swarm.stamp[a], image_ba);
  ++run.counts.ball_ball;
  book(run.books, outcome);
  Event<double, D> event;
  event.time = t;
  event.kind = EventKind::ball_ball;
  event.ball = run.swarm.past[a].number;
  event.partner = run.swarm.past[b].number;
  if (run.sink != nullptr)
    send(run, event, impact, outcome, gap, a, hit_a, before_a.time(), b, hit_b, before_b.time());
  for (int k = 0; k < D; ++k)
    if (!(outcome.va[k] - outcome.va[k] == 0) || !(outcome.vb[k] - outcome.vb[k] == 0)) run.verdict = Halt::non_finite;
  if (run.verdict == Halt::until) watch(run, impact, t, outcome.impulse, a, {event.ball, event.partner}, Support::ball);
  return true;
}

template <int D>
void report_collision(SwarmRun<D>& run, std::uint32_t i, std::uint32_t j, const Time<double>& t, const double* image) {
  const auto& [before_i, before_j, hit_i, hit_j] = run.before;
  const bool ordered = run.swarm.past[i].number < run.swarm.past[j].number;
  const std::uint32_t a = ordered ? i : j, b = ordered ? j : i;
  const Flight<D>&before_a = ordered ? before_i : before_j, &before_b = ordered ? before_j : before_i;
  double image_ab[D];
  for (int k = 0; k < D; ++k) image_ab[k] = ordered ? image[k] : -image[k];
  const Vec<double, D> xa = flown_to(before_a, t), xb = flown_to(before_b, t);
  const Impact<double, D> impact = impact_of(run, a, b, xa, xb, before_a, before_b, image_ab);
  const Outcome<double, D> outcome = resolve_impact(impact);
  const double sigma = run.swarm.kind(a).radius + run.swarm.kind(b).radius;
  Event<double, D> event;
  event.time = t;
  event.kind = EventKind::ball_ball;
  event.ball = run.swarm.past[a].number;
  event.partner = run.swarm.past[b].number;
  send(run, event, impact, outcome, gap_of_pair<double>(impact.r, sigma), a, ordered ? hit_i : hit_j, before_a.time(), b,
       ordered ? hit_j : hit_i, before_b.time());
}

template <int D>
bool refill_calendar(SwarmRun<D>& run) {
  // The events of the next quarter of the balls tell the rate.
  const std::uint32_t n = run.swarm.size();
  const std::uint32_t step = std::max(1U, n / 4096);
  std::vector<double> waits;
  bool any = false;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Time<double> t = run.shells.slots[i].due();
    if (t.is_never()) continue;
    any = true;
    if (i % step == 0 || n < 8192) waits.push_back(std::max(0.0, elapsed(run.clock, t)));
  }
  if (!any) return false;
  double width = 1;
  if (!waits.empty()) {
    const std::size_t quarter = waits.size() / 4;
    std::nth_element(waits.begin(), waits.begin() + static_cast<std::ptrdiff_t>(quarter), waits.end());
    const double share = static_cast<double>(quarter + 1) / static_cast<double>(waits.size());
    width = run.per_bucket * waits[quarter] / (share * n);
    if (run.mean_free_time == 0) run.mean_free_time = 2 * waits[quarter];
  }
  width = std::clamp(width, 0x1p-20, 0x1p40);
  std::uint32_t outer = 64;
  while (outer < 0x1p16 && outer < 8 * n / (Calendar::fine * run.per_bucket)) outer *= 2;
  run.calendar.reset(run.clock, width, outer);
  run.agenda.resize(0);
  run.head = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Time<double> t = run.shells.slots[i].due();
    if (!t.is_never()) run.calendar.push(i, run.calendar.bucket(t));
  }
  run.tuned_due = run.work.due;
  run.tuned_buckets = run.work.buckets;
  run.tuned_at = run.now;
  run.tuned_collisions = run.counts.collisions();
  run.next_tuning = run.work.buckets + 4096;
  return true;
}

template <int D>
void tune_calendar(SwarmRun<D>& run) {
  const double per_bucket = static_cast<double>(run.work.due - run.tuned_due) /
                            static_cast<double>(std::max<std::int64_t>(1, run.work.buckets - run.tuned_buckets));
  const std::int64_t collisions = run.counts.collisions() - run.tuned_collisions;
  if (collisions > 0)
    run.mean_free_time =
        elapsed(run.tuned_at, run.now) * run.swarm.size() / (2 * static_cast<double>(collisions));
  const bool off = per_bucket < run.per_bucket / 3 || per_bucket > run.per_bucket * 3;
  if (off) refill_calendar(run);
  run.tuned_due = run.work.due;
  run.tuned_buckets = run.work.buckets;
  run.tuned_at = run.now;
  run.tuned_collisions = run.counts.collisions();
  run.next_tuning = run.work.buckets + (off ? 8192 : 4096);
}

template double careful_flight(const SwarmRun<2>&, std::uint32_t, std::uint32_t, const double*, const double*, const double*,
                               double);
template double careful_flight(const SwarmRun<3>&, std::uint32_t, std::uint32_t, const double*, const double*, const double*,
                               double);
template bool first_at_a_tie(const SwarmRun<2>&, std::uint32_t, std::uint32_t, std::uint32_t);
template bool first_at_a_tie(const SwarmRun<3>&, std::uint32_t, std::uint32_t, std::uint32_t);
template bool first_due_at_a_tie(const SwarmRun<2>&, std::uint32_t, std::uint32_t);
template bool first_due_at_a_tie(const SwarmRun<3>&, std::uint32_t, std::uint32_t);
template bool collide_carefully(SwarmRun<2>&, std::uint32_t, std::uint32_t, const Time<double>&);
template bool collide_carefully(SwarmRun<3>&, std::uint32_t, std::uint32_t, const Time<double>&);
template void report_collision(SwarmRun<2>&, std::uint32_t, std::uint32_t, const Time<double>&, const double*);
template void report_collision(SwarmRun<3>&, std::uint32_t, std::uint32_t, const Time<double>&, const double*);
template bool refill_calendar(SwarmRun<2>&);
template bool refill_calendar(SwarmRun<3>&);
template void tune_calendar(SwarmRun<2>&);
template void tune_calendar(SwarmRun<3>&);

}  // namespace detail

template <int D>
SwarmKernel<D> swarm_kernel(const Swarm<D>& swarm, [[maybe_unused]] bool vectors) {
  const bool periodic = swarm.rest.space.periodic(), equal = swarm.species.size() == 1;
#if defined(CAROM_HAVE_AVX2_TARGET)
  if (vectors && machine_has_avx2()) return swarm_kernel_of<D, Avx2>(periodic, equal);
#endif
  return swarm_kernel_of<D, Baseline>(periodic, equal);
}
template SwarmKernel<2> swarm_kernel(const Swarm<2>&, bool);
template SwarmKernel<3> swarm_kernel(const Swarm<3>&, bool);

}  // namespace carom
