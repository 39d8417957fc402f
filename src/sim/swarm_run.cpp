#include "carom/sim/swarm_run.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "carom/solve/quadratic.hpp"
#include "carom/world/wall_pieces.hpp"
#include "machine.hpp"
#include "swarm_collision.hpp"
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
    Place place{EventKind::none, a, 0, 0};
    if (partner >= Slot::wall)
      with_piece(run.swarm.rest.walls, partner - Slot::wall,
                 [&](const auto& shape) { place = {EventKind::ball_wall, a, index(shape.wall), shape.feature}; });
    return place;
  }
  const std::uint32_t b = run.swarm.past[partner].number;
  return {EventKind::ball_ball, std::min(a, b), std::max(a, b), 0};
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
  if (partner >= Slot::wall) return collide_with_wall(run, i, partner - Slot::wall, t);
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
    send(run, event, impact, outcome, gap, a, hit_a, before_a.time(), b, hit_b, before_b.time(), [](auto&) {});
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
       ordered ? hit_j : hit_i, before_b.time(), [](auto&) {});
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
