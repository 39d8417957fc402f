#pragma once
// The event-driven integrator for many balls: the algorithm of event_driven.hpp on records made for speed.
//
// One live event a ball [Lubachevsky1991], neighbour lists (search/shells.hpp), a calendar (queue/calendar.hpp). A ball
// keeps its first meeting and its second: if the partner of the first is hit by another, the second is a bound below all
// that are left, so it is queued in its place, and the list is gone through anew only if that one surfaces and is stale too
// (whoever was hit has itself looked at this ball). The events are those of EventDriven, bit for bit; what is out of the
// ordinary, a second event of a ball at one moment above all, is left to it.

#include <atomic>
#include <cstdint>

#include "carom/predict/first_meetings.hpp"
#include "carom/sim/swarm_impact.hpp"
#include "carom/sim/swarm_run.hpp"

namespace carom {

/// `Target` is the instruction set that this is compiled for: a name of its own keeps the versions apart.
template <int D, class Target, bool periodic, bool equal>
class SwarmLoop {
 public:
  using Run = SwarmRun<D>;

  [[gnu::flatten]] static void start(Run& run) {
    const std::uint32_t n = run.swarm.size();
    run.clock = run.now;
    for (std::uint32_t i = 0; i < n; ++i) place(run, i);
    for (std::uint32_t i = 0; i < n; ++i) {
      Slot& slot = run.shells.slots[i];
      slot.count = 0;
      const std::uint32_t found = run.shells.template gather<periodic, equal>(run.swarm, i);
      for (std::uint32_t k = 0; k < found; ++k) run.shells.add(i, run.shells.found()[k]);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      look_again(run, i);  // stored times differ where a run goes on from a state
      set_exits(run, i, i);
    }
    detail::refill_calendar(run);
  }

  [[gnu::flatten]] static Halt advance(Run& run, const Time<double>& until, std::int64_t goal,
                                       const std::atomic<bool>* interrupt) {
    while (true) {
      if (run.counts.collisions() >= goal) return Halt::events;
      if (interrupt != nullptr && interrupt->load(std::memory_order_relaxed)) return Halt::interrupted;
      if (run.head == run.agenda.size()) {
        if (!next_bucket(run)) return Halt::idle;
        continue;
      }
      const Due due = run.agenda[run.head];
      if (due.time > until) return Halt::until;
      const std::uint32_t i = due.ball;
      const Slot& slot = run.shells.slots[i];
      if (slot.due() != due.time) {
        ++run.head;
        continue;
      }
      if (run.far_sighted) fetch_ahead(run);
      if (due.time > run.clock) run.clock = due.time;
      if (slot.exit_first()) {
        ++run.head;
        renew(run, i);
        if (slot.exit <= run.clock.epoch || ++run.quiet > 1024 + 64 * static_cast<std::int64_t>(run.swarm.size())) return Halt::unusual;
        continue;
      }
      const std::uint32_t j = slot.partner;
      const bool wall = j >= Slot::wall;
      if (!wall && run.swarm.stamp[j] != slot.partner_stamp) {
        ++run.head;
        ++run.exactness.repredicted;
        fall_back(run, i);
        continue;
      }
      const Time<double> t = due.time;
      if (run.swarm.flights[i].time() == t || (!wall && run.swarm.flights[j].time() == t)) return Halt::unusual;
      if (run.plain && !wall) {
        SwarmImpact<D, Target, periodic, equal>::collide(run, i, j, t);
      } else if (!detail::collide_carefully(run, i, j, t)) {
        return Halt::unusual;
      }
      ++run.head;
      run.exactness.clamped += t < run.now;
      run.now = t;
      run.quiet = 0;
      if (wall) {
        look_at_all(run, i, nobody);
        set_exits(run, i, i);
        enqueue(run, i);
      } else {
        look_around(run, i, j);
                enqueue(run, i);
        enqueue(run, j);
      }
      if (run.verdict != Halt::until) return std::exchange(run.verdict, Halt::until);
    }
  }

 private:
  static constexpr std::uint32_t nobody = ~std::uint32_t{0};

  // --- what is due ---

  [[gnu::noinline, gnu::flatten]] static void enqueue(Run& run, std::uint32_t i) {
    const Slot& slot = run.shells.slots[i];
    const Time<double> t = slot.due();
    if (t.is_never()) return;
    const std::int64_t b = run.calendar.bucket(t);
    if (b > run.calendar.current()) {
      run.calendar.push(i, b);
      return;
    }
    const std::size_t n = run.agenda.size();
    run.agenda.resize(n + 1);
    std::size_t k = n;
    const Due due{t, i, slot.partner};
    for (; k > run.head && earlier(run, due, run.agenda[k - 1]); --k) run.agenda[k] = run.agenda[k - 1];
    run.agenda[k] = due;
  }

  CAROM_INLINE static bool earlier(const Run& run, const Due& a, const Due& b) {
    if (a.time.epoch != b.time.epoch) return a.time.epoch < b.time.epoch;
    if (a.time.offset != b.time.offset) return a.time.offset < b.time.offset;
    return a.ball != b.ball && detail::first_due_at_a_tie(run, a.ball, b.ball);
  }

  /// The next fine bucket of the calendar, in order.
  [[gnu::noinline, gnu::flatten]] static bool next_bucket(Run& run) {
    run.head = 0;
    run.agenda.resize(0);
    if (run.work.buckets >= run.next_tuning) detail::tune_calendar(run);
    const auto bucket_of = [&run](std::uint32_t i) { return run.calendar.bucket(run.shells.slots[i].due()); };
    std::size_t n = 0;
    const bool any = run.calendar.next(
        [&run, &n](std::uint32_t i) {
          ++run.work.drained;
          const Slot& slot = run.shells.slots[i];
          const Time<double> t = slot.due();
          if (run.calendar.bucket(t) != run.calendar.current()) return;
          run.agenda.resize(n + 1);
          run.agenda[n++] = Due{t, i, slot.partner};
        },
        bucket_of);
    if (!any) return detail::refill_calendar(run);
    if (run.far_sighted) run.calendar.peek([&run](std::uint32_t i) { __builtin_prefetch(&run.shells.slots[i]); });
    ++run.work.buckets;
    run.work.due += static_cast<std::int64_t>(n);
    Due* const first = run.agenda.data();
    if (n <= 24) {
      for (std::size_t k = 1; k < n; ++k) {
        const Due due = first[k];
        std::size_t to = k;
        for (; to > 0 && earlier(run, due, first[to - 1]); --to) first[to] = first[to - 1];
        first[to] = due;
      }
    } else {
      sort_by_time(run, first, n);
    }
    if (run.far_sighted)
      for (std::size_t k = 0; k < 20 && k < n; ++k) fetch_parties(run, first[k]);
    return true;
  }

  /// Puts n balls of the current bucket in order: by shares of its width into bins, and then those that are close.
  CAROM_INLINE static void sort_by_time(Run& run, Due* first, std::size_t n) {
    constexpr std::uint32_t bins = 256;
    run.sorted.resize(n);
    std::uint32_t begin[bins + 1] = {};
    PageArray<std::uint8_t>& bin = run.bins;
    bin.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double share = run.calendar.share(first[k].time) * bins;
      bin[k] = static_cast<std::uint8_t>(share < bins - 1 ? static_cast<std::int32_t>(share) : static_cast<std::int32_t>(bins - 1));
      ++begin[bin[k] + 1];
    }
    for (std::uint32_t b = 0; b < bins; ++b) begin[b + 1] += begin[b];
    for (std::size_t k = 0; k < n; ++k) run.sorted[begin[bin[k]]++] = first[k];
    first[0] = run.sorted[0];
    for (std::size_t k = 1; k < n; ++k) {
      const Due due = run.sorted[k];
      std::size_t to = k;
      for (; to > 0 && earlier(run, due, first[to - 1]); --to) first[to] = first[to - 1];
      first[to] = due;
    }
  }

  /// Fetches what the events to come will read: the records of both parties, then those around them.
  CAROM_INLINE static void fetch_ahead(const Run& run) {
    const std::size_t n = run.agenda.size();
    if (run.head + 20 < n) fetch_parties(run, run.agenda[run.head + 20]);
    if (run.head + 12 < n) {
      const std::uint32_t i = run.agenda[run.head + 12].ball;
      fetch_near(run, i);
      if (run.shells.slots[i].exit_first()) run.shells.fetch_cells(i);
    }
    if (run.head + 6 < n) {
      const std::uint32_t j = run.agenda[run.head + 6].partner;
      if (j < run.swarm.size()) fetch_near(run, j);
    }
  }
  CAROM_INLINE static void fetch_parties(const Run& run, const Due& due) {
    fetch_ball(run, due.ball);
    if (due.partner >= run.swarm.size()) return;
    fetch_ball(run, due.partner);
    __builtin_prefetch(&run.shells.slots[due.partner]);
  }
  CAROM_INLINE static void fetch_ball(const Run& run, std::uint32_t i) {
    __builtin_prefetch(&run.swarm.flights[i]);
    __builtin_prefetch(&run.swarm.past[i]);
    __builtin_prefetch(&run.swarm.stamp[i]);
    run.shells.fetch_home(i);
    __builtin_prefetch(&run.shells.slots[i].near);
  }
  CAROM_INLINE static void fetch_near(const Run& run, std::uint32_t i) {
    const Slot& slot = run.shells.slots[i];
    const std::uint32_t n = slot.count < Slot::here ? slot.count : Slot::here;
    for (std::uint32_t k = 0; k < n; ++k) __builtin_prefetch(&run.swarm.flights[slot.near[k]]);
  }

  // --- predictions ---

  /// The list of a ball that is looked at, and what decides whom it meets.
  struct Look {
    const std::uint32_t* near;
    std::uint32_t count;
    PairTermsOfList<equal> terms;
    FirstFew first;
    std::uint32_t all[PairTermsOfList<equal>::most];  // where the slot does not hold it
  };
  static constexpr std::uint32_t most_near = PairTermsOfList<equal>::most;

  /// The terms of ball i with all around it but `hit`, whom it has just hit: they do not meet again before one of them is hit.
  CAROM_INLINE static void look(Run& run, std::uint32_t i, std::uint32_t hit, Look& at) {
    const Slot& slot = run.shells.slots[i];
    at.near = slot.near;
    at.count = slot.count;
    if (at.count > Slot::here) {
      at.count = at.count < most_near ? at.count : 0;
      run.shells.copy_list(i, at.count, at.all);
      at.near = at.all;
    }
    auto& terms = at.terms;
    terms.b[most_near] = terms.rr[most_near] = terms.a[most_near] = terms.cross[most_near] = 1;
    if constexpr (!equal) terms.sigma[most_near] = 1;
    run.work.predictions += at.count;
    find_candidates<D, periodic>(run.swarm, i, at.near, at.count, (at.count + lanes - 1) / lanes, run.reach, terms);
    terms.candidates &= ~bits_of(at.near, at.count, hit);
  }
  CAROM_INLINE static void meet(const Run& run, std::uint32_t i, Look& at) {
    at.first = meet_four(at.terms, at.terms.candidates, at.near, 2 * run.swarm.template kind<equal>(i).radius);
  }

  /// Goes on until the first two meetings are certain, and their order. False: they are to be found pair by pair.
  CAROM_INLINE static bool settle(Run& run, std::uint32_t i, Look& at) {
    FirstFew& few = at.first;
    if (few.left != 0) [[unlikely]]
      meet_others(run, i, at);
    if ((sign_bits(few.doubt) & 3) != 0) [[unlikely]]
      if (!settle_doubts(run, i, at)) return false;
    return !undecided(few.flight[0], few.flight[1], few.flight[2]) & (at.count != 0);
  }
  [[gnu::noinline, gnu::flatten]] static void meet_others(const Run& run, std::uint32_t i, Look& at) {
    while (at.first.left != 0)
      at.first.merge(meet_four(at.terms, at.first.left, at.near, 2 * run.swarm.template kind<equal>(i).radius));
  }
  /// Those in doubt that may be among the first two are settled. What is not among the four that are known comes after the
  /// last of them: one of these at least must stay.
  [[gnu::noinline, gnu::flatten]] static bool settle_doubts(Run& run, std::uint32_t i, Look& at) {
    FirstFew& few = at.first;
    const double known = few.flight[3];
    for (int turn = 0; turn < 8; ++turn) {
      const int doubts = sign_bits(few.doubt) & 3;
      if (doubts == 0) return few.flight[2] <= known || known == FirstMeetings::no_flight;
      const int k = (doubts & 1) != 0 ? 0 : 1;
      double t;
      if (!meet_closely(run, i, static_cast<std::uint32_t>(few.row[k]), t)) return false;
      few.flight[k] = t < FirstMeetings::no_flight ? t : FirstMeetings::no_flight;
      few.doubt[k] = 0;
      few.put_in_order();
    }
    return false;
  }

  /// Both meetings of balls i and j, which have just hit each other at run.now, are found anew.
  [[gnu::noinline, gnu::flatten]] static void look_around(Run& run, std::uint32_t i, std::uint32_t j) {
    if constexpr (!periodic) {
      look_at_all(run, i, j);
      look_at_all(run, j, i);
      return set_exits(run, i, j);
    }
    Look a, b;
    look(run, i, j, a);
    look(run, j, i, b);
    set_exits(run, i, j);
    meet(run, i, a);
    meet(run, j, b);
    const bool found_a = settle(run, i, a), found_b = settle(run, j, b);
    const Lanes flights = __builtin_shufflevector(a.first.flight, b.first.flight, 0, 1, 4, 5);
    alignas(32) long long epoch[lanes];
    alignas(32) double offset[lanes];
    LaneMask epochs;
    Lanes offsets;
    after(run.now, flights, epochs, offsets);
    *reinterpret_cast<StoredMask*>(epoch) = epochs;
    *reinterpret_cast<Lanes*>(offset) = offsets;
    const bool in_range = sign_bits((flights < 0x1p50) | (flights == FirstMeetings::no_flight)) == 15;
    if (found_a & found_b & in_range) [[likely]] {
      keep(run, i, a.first, epoch, offset);
      keep(run, j, b.first, epoch + 2, offset + 2);
    } else {
      look_again(run, i);
      look_again(run, j);
    }
  }
  CAROM_INLINE static void keep(Run& run, std::uint32_t i, const FirstFew& few, const long long* epoch, const double* offset) {
    Slot& slot = run.shells.slots[i];
    slot.first = {epoch[0], offset[0]};
    slot.partner = static_cast<std::uint32_t>(few.row[0]);
    slot.partner_stamp = run.swarm.stamp[slot.partner == nobody ? i : slot.partner];
    slot.second = {epoch[1], offset[1]};
    slot.second_partner = static_cast<std::uint32_t>(few.row[1]);
    slot.second_stamp = run.swarm.stamp[slot.second_partner == nobody ? i : slot.second_partner];
  }

  /// Both meetings of ball i are found anew, from the moment of its last collision, run.now.
  [[gnu::noinline, gnu::flatten]] static void look_at_all(Run& run, std::uint32_t i, std::uint32_t hit = nobody) {
    Look at;
    look(run, i, hit, at);
    meet(run, i, at);
    if (!settle(run, i, at)) return look_again(run, i);
    FirstMeetings found;
    for (int k = 0; k < 3; ++k) found.offer(at.first.flight[k], static_cast<std::uint32_t>(at.first.row[k]));
    if constexpr (!periodic)
      for (std::size_t f = 0; f < run.swarm.rest.walls.faces.size(); ++f)
        found.offer(flight_to_face(run, i, f), Slot::wall + static_cast<std::uint32_t>(f));
    if (undecided(found.flight[0], found.flight[1], found.flight[2])) return look_again(run, i);
    Slot& slot = run.shells.slots[i];
    const Time<double> since = run.swarm.flights[i].time();
    slot.first = after(since, found.flight[0]);
    slot.partner = found.partner[0];
    slot.partner_stamp = stamp_of(run, slot.partner);
    slot.second = after(since, found.flight[1]);
    slot.second_partner = found.partner[1];
    slot.second_stamp = stamp_of(run, slot.second_partner);
  }

  /// Bit k is set where near[k] is `row`.
  CAROM_INLINE static std::uint64_t bits_of(const std::uint32_t* near, std::uint32_t count, std::uint32_t row) {
    const Ints8 wanted = Ints8{} + static_cast<std::int32_t>(row);
    if (count <= Slot::here) return sign_bits8(load8(near) == wanted) | sign_bits8(load8(near + 8) == wanted) << 8;
    std::uint64_t bits = 0;
    for (std::uint32_t k = 0; k < count; ++k) bits |= static_cast<std::uint64_t>(near[k] == row) << k;
    return bits;
  }

  /// The flight of ball i to its meeting with j in twice the precision. False: it can be found only pair by pair.
  CAROM_INLINE static bool meet_closely(const Run& run, std::uint32_t i, std::uint32_t j, double& t) {
    if (run.swarm.flights[j].time() == run.swarm.flights[i].time()) return false;  // they may touch
    const double sigma = run.swarm.template kind<equal>(i).radius + run.swarm.template kind<equal>(j).radius;
    double r[D], g[D], image[D];
    (void)pair_state<D, periodic>(run.swarm, i, j, run.clock, r, g, image);
    Vec<double, D> place, velocity;
    for (int m = 0; m < D; ++m) {
      place[m] = r[m];
      velocity[m] = g[m];
    }
    return detail::meet_time_wide<D>(place, velocity, sigma, t);
  }

  /// The same whatever the stored times, pair by pair and in the total order of events.
  CAROM_INLINE static void look_again(Run& run, std::uint32_t i) {
    Slot& slot = run.shells.slots[i];
    slot.first = slot.second = Time<double>::never();
    slot.partner = slot.second_partner = nobody;
    run.shells.for_each_piece(i, [&](const std::uint32_t* near, std::uint32_t count) {
      for (std::uint32_t k = 0; k < count; ++k) offer(run, i, near[k], meeting(run, i, near[k]));
    });
    if constexpr (!periodic)
      for (std::size_t f = 0; f < run.swarm.rest.walls.faces.size(); ++f)
        offer(run, i, Slot::wall + static_cast<std::uint32_t>(f),
              after(run.swarm.flights[i].time(), flight_to_face(run, i, f)));
  }

  /// When balls i and j, which are neighbours now, meet.
  CAROM_INLINE static Time<double> meeting(Run& run, std::uint32_t i, std::uint32_t j) {
    ++run.work.predictions;
    double r[D], g[D], image[D];
    const Time<double> since = pair_state<D, periodic>(run.swarm, i, j, run.clock, r, g, image);
    double b = r[0] * g[0], rr = r[0] * r[0];
    for (int k = 1; k < D; ++k) {
      b += r[k] * g[k];
      rr += r[k] * r[k];
    }
    const double sigma = run.swarm.template kind<equal>(i).radius + run.swarm.template kind<equal>(j).radius, ss = sigma * sigma;
    if (b >= 0.0 && rr > detail::apart * ss) return Time<double>::never();
    double a = g[0] * g[0], cross;
    for (int k = 1; k < D; ++k) a += g[k] * g[k];
    if constexpr (D == 2) {
      cross = (r[0] * g[1] - r[1] * g[0]) * (r[0] * g[1] - r[1] * g[0]);
    } else {
      const double x = r[1] * g[2] - r[2] * g[1], y = r[2] * g[0] - r[0] * g[2], z = r[0] * g[1] - r[1] * g[0];
      cross = x * x + y * y + z * z;
    }
    const double c = rr - ss, ass = a * ss, d = ass - cross;
    if (c > detail::near_contact * ss) {  // as meet_time in solve/quadratic.hpp
      if (-d > detail::no_root * (a * rr) + detail::no_underflow) return Time<double>::never();
      if (d > detail::near_grazing * ass + detail::no_underflow) return after(since, c / (__builtin_sqrt(d) - b));
    }
    return after(since, detail::careful_flight(run, i, j, image, r, g, sigma));
  }

  CAROM_INLINE static double flight_to_face(const Run& run, std::uint32_t i, std::size_t f) {
    const auto& face = run.swarm.rest.walls.faces[f];
    const Flight<D>& ball = run.swarm.flights[i];
    const double rate = face.sign > 0 ? ball.v[face.axis] : -ball.v[face.axis];
    if (!(rate < 0)) return never<double>();
    const double x = ball.x[face.axis];
    const double gap = (face.sign > 0 ? x - face.coordinate : face.coordinate - x) - run.swarm.template kind<equal>(i).radius;
    return gap > 0 ? gap / -rate : 0.0;
  }

  CAROM_INLINE static std::uint32_t stamp_of(const Run& run, std::uint32_t partner) {
    return partner < run.swarm.size() ? run.swarm.stamp[partner] : 0;
  }

  /// A meeting of ball i with `partner` at t takes its place among those known.
  CAROM_INLINE static void offer(Run& run, std::uint32_t i, std::uint32_t partner, const Time<double>& t) {
    Slot& slot = run.shells.slots[i];
    if (t.is_never() || t > slot.second) return;
    const auto before = [&](const Time<double>& other, std::uint32_t with) {
      return t < other || (t == other && with != nobody && with != Slot::unknown && detail::first_at_a_tie(run, i, partner, with));
    };
    if (before(slot.first, slot.partner)) {
      slot.second = slot.first;
      slot.second_partner = slot.partner;
      slot.second_stamp = slot.partner_stamp;
      slot.first = t;
      slot.partner = partner;
      slot.partner_stamp = stamp_of(run, partner);
    } else if (slot.second_partner != Slot::unknown && before(slot.second, slot.second_partner)) {
      slot.second = t;
      slot.second_partner = partner;
      slot.second_stamp = stamp_of(run, partner);
    }
  }

  /// The partner of ball i's first meeting has been hit by another.
  [[gnu::noinline, gnu::flatten]] static void fall_back(Run& run, std::uint32_t i) {
    Slot& slot = run.shells.slots[i];
    if (slot.second_partner == Slot::unknown) {
      ++run.work.rescans;
      look_again(run, i);
    } else {
      slot.first = slot.second;
      slot.partner = slot.second_partner;
      slot.partner_stamp = slot.second_stamp;
      slot.second_partner = Slot::unknown;
    }
    enqueue(run, i);
  }

  // --- shells ---

  /// A shell for ball i, set ahead of it on its way: by 1.2 mean free times, at most by 3/4 of its radius.
  [[gnu::noinline, gnu::flatten]] static void place(Run& run, std::uint32_t i) {
    const Flight<D>& ball = run.swarm.flights[i];
    const double flown = elapsed(ball.time(), run.clock);
    double square = 0, x[D];
    for (int k = 0; k < D; ++k) square += ball.v[k] * ball.v[k];
    double ahead = 1.2 * run.mean_free_time;
    const double most = 0.75 * run.shells.radius();
    if (ahead * ahead * square > most * most) ahead = most / __builtin_sqrt(square);
    for (int k = 0; k < D; ++k) x[k] = ball.x[k] + ball.v[k] * flown + ball.v[k] * ahead;
    run.shells.place(i, x);
  }

  /// When balls i and j leave their shells.
  CAROM_INLINE static void set_exits(Run& run, std::uint32_t i, std::uint32_t j) {
    const Flight<D>&a = run.swarm.flights[i], &b = run.swarm.flights[j];
    const Lanes va = load_vector<D>(a.v), vb = load_vector<D>(b.v);
    const Lanes ua = run.shells.from_centre(i, load_vector<D>(a.x) + va * elapsed(a.time(), run.clock));
    const Lanes ub = run.shells.from_centre(j, load_vector<D>(b.x) + vb * elapsed(b.time(), run.clock));
    // |u + v t|^2 = radius^2, of both: q t^2 + 2 p t = c.
    const Lanes pq = sums(va * va, vb * vb, ua * va, ub * vb), uu = sums(ua * ua, ub * ub, ua, ub);
    const Lanes q = __builtin_shufflevector(pq, pq, 0, 1, 0, 1), p = __builtin_shufflevector(pq, pq, 2, 3, 2, 3);
    const Lanes c = run.shells.radius() * run.shells.radius() - uu, root = sqrt(p * p + q * c);
    const LaneMask outward = p > 0.0;
    const Lanes flight = (outward ? c : root - p) / (outward ? p + root : q);
    for (int k = 0; k < 2; ++k) {
      constexpr double far = 0x1p60;
      const double t = run.clock.offset + flight[k];
      std::int64_t& exit = run.shells.slots[k == 0 ? i : j].exit;
      exit = run.clock.epoch + static_cast<std::int64_t>(t < far ? t : far);  // at rest it is a NaN
      if (!(c[k] > 0)) exit = run.clock.epoch;
    }
  }

  /// Ball i has come to the edge of its shell: it gets another, and its list is mended.
  [[gnu::noinline, gnu::flatten]] static void renew(Run& run, std::uint32_t i) {
    ++run.work.renewals;
    Shells<D>& shells = run.shells;
    shells.displace(i);
    place(run, i);
    const std::uint32_t n = shells.template gather<periodic, equal>(run.swarm, i);
    std::uint32_t* const found = shells.found();
    shells.update(
        i, n, [&](std::uint32_t k) { offer(run, i, found[k], meeting(run, i, found[k])); }, [&] { set_exits(run, i, i); });
    enqueue(run, i);
  }
};

}  // namespace carom
