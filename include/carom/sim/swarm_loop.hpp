#pragma once
// The event-driven integrator for many balls: the algorithm of event_driven.hpp on records made for speed.
//
// One live event a ball [Lubachevsky1991], neighbour lists (search/shells.hpp), a calendar (queue/calendar.hpp). A ball
// keeps its first meeting and its second: if the partner of the first is hit by another, the second is a bound below all
// that are left, so it is queued in its place, and the list is gone through anew only if that one surfaces and is stale too
// (whoever was hit has itself looked at this ball). The events are those of EventDriven, bit for bit; what is out of the
// ordinary, a second event of a ball at one moment above all, is left to it.

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "carom/core/double_double.hpp"
#include "carom/predict/first_meetings.hpp"
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
      const std::uint32_t found = run.shells.gather(run.swarm, i);
      for (std::uint32_t k = 0; k < found; ++k) run.shells.add(i, run.shells.found()[k]);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      look_again(run, i);  // stored times differ where a run goes on from a state
      set_exit(run, i);
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
      if (!wall && run.swarm.past[j].stamp != slot.partner_stamp) {
        ++run.head;
        ++run.exactness.repredicted;
        fall_back(run, i);
        continue;
      }
      const Time<double> t = due.time;
      if (run.swarm.flights[i].time() == t || (!wall && run.swarm.flights[j].time() == t)) return Halt::unusual;
      if (run.plain && !wall) {
        collide(run, i, j, t);
      } else if (!detail::collide_carefully(run, i, j, t)) {
        return Halt::unusual;
      }
      ++run.head;
      run.exactness.clamped += t < run.now;
      run.now = t;
      run.quiet = 0;
      look_at_all(run, i, j);
      set_exit(run, i);
      enqueue(run, i);
      if (!wall) {
        look_at_all(run, j, i);
        set_exit(run, j);
        enqueue(run, j);
      }
      if (run.verdict != Halt::until) return std::exchange(run.verdict, Halt::until);
    }
  }

 private:
  static constexpr std::uint32_t nobody = ~std::uint32_t{0};
  static constexpr std::uint32_t most_open = 16;

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
      std::sort(first, first + n, [&run](const Due& a, const Due& b) { return earlier(run, a, b); });
    }
    return true;
  }

  /// Fetches what the events to come will read: the records of both parties, then those around them.
  CAROM_INLINE static void fetch_ahead(const Run& run) {
    const std::size_t n = run.agenda.size();
    if (run.head + 20 < n) {
      const Due& due = run.agenda[run.head + 20];
      fetch_ball(run, due.ball);
      if (due.partner < run.swarm.size()) {
        fetch_ball(run, due.partner);
        __builtin_prefetch(&run.shells.slots[due.partner]);
      }
    }
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
  CAROM_INLINE static void fetch_ball(const Run& run, std::uint32_t i) {
    __builtin_prefetch(&run.swarm.flights[i]);
    __builtin_prefetch(&run.swarm.past[i]);
    __builtin_prefetch(&run.shells.slots[i].near);
  }
  CAROM_INLINE static void fetch_near(const Run& run, std::uint32_t i) {
    const Slot& slot = run.shells.slots[i];
    const std::uint32_t n = slot.count < Slot::here ? slot.count : Slot::here;
    for (std::uint32_t k = 0; k < n; ++k) __builtin_prefetch(&run.swarm.flights[slot.near[k]]);
  }

  // --- predictions ---

  /// Both meetings of ball i are found anew, from the moment of its last collision, run.now; `hit`, if anyone, is whom it has
  /// just hit: they do not meet again before one of them is hit.
  [[gnu::noinline, gnu::flatten]] static void look_at_all(Run& run, std::uint32_t i, std::uint32_t hit = nobody) {
    FirstMeetings found;
    MeetingTimes times;
    OpenPair<D> open[most_open];
    std::uint32_t opened = 0;
    bool again = false;  // pair by pair
    const auto settle = [&](const OpenPair<D>& pair) {
      if (pair.bound > found.flight[2]) return;
      Vec<double, D> r, g;
      for (int k = 0; k < D; ++k) {
        r[k] = pair.r[k];
        g[k] = pair.g[k];
      }
      double t;
      const bool may_touch = run.swarm.flights[pair.partner].time() == run.swarm.flights[i].time();
      if (may_touch || !detail::meet_time_wide<D>(r, g, pair.sigma, t)) {
        again = true;
      } else {
        found.offer(t, pair.partner);
      }
    };
    run.shells.for_each_piece(i, [&](const std::uint32_t* near, std::uint32_t count) {
      run.work.predictions += count;
      for (std::uint32_t k = (count + 3) / 4 * 4; k < MeetingTimes::most; ++k) times.flight[k] = never<double>();
      look_at<D, periodic, equal>(run.swarm, i, near, count, hit, times.flight, [&](const OpenPair<D>& pair) {
        if (opened < most_open) {
          open[opened++] = pair;
        } else {
          settle(pair);
        }
      });
      times.into(found, near);
    });
    for (std::uint32_t k = 0; k < opened; ++k) settle(open[k]);  // most come later than what is known by now
    if constexpr (!periodic)
      for (std::size_t f = 0; f < run.swarm.rest.walls.faces.size(); ++f)
        found.offer(flight_to_face(run, i, f), Slot::wall + static_cast<std::uint32_t>(f));
    if (again || found.undecided()) {
      look_again(run, i);
      return;
    }
    Slot& slot = run.shells.slots[i];
    const Time<double> since = run.swarm.flights[i].time();
    slot.first = after(since, found.flight[0]);
    slot.partner = found.partner[0];
    slot.partner_stamp = stamp_of(run, slot.partner);
    slot.second = after(since, found.flight[1]);
    slot.second_partner = found.partner[1];
    slot.second_stamp = stamp_of(run, slot.second_partner);
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
    const double sigma = run.swarm.template kind<equal>(i).radius + run.swarm.template kind<equal>(j).radius;
    if (b >= 0.0 && rr > detail::apart * (sigma * sigma)) return Time<double>::never();
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
    return partner < run.swarm.size() ? run.swarm.past[partner].stamp : 0;
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

  /// When ball i leaves its shell.
  [[gnu::noinline, gnu::flatten]] static void set_exit(Run& run, std::uint32_t i) {
    const Flight<D>& ball = run.swarm.flights[i];
    const double flown = elapsed(ball.time(), run.clock);
    double x[D], u[D];
    for (int k = 0; k < D; ++k) x[k] = ball.x[k] + ball.v[k] * flown;
    run.shells.from_centre(i, x, u);
    double a = 0, b = 0, c = run.shells.radius() * run.shells.radius();
    for (int k = 0; k < D; ++k) {
      a += ball.v[k] * ball.v[k];
      b += u[k] * ball.v[k];
      c -= u[k] * u[k];
    }
    constexpr std::int64_t far = std::int64_t{1} << 60;
    std::int64_t& exit = run.shells.slots[i].exit;
    if (!(c > 0)) {
      exit = run.clock.epoch;
    } else if (a == 0) {
      exit = Time<double>::never().epoch;
    } else {
      const double root = __builtin_sqrt(b * b + a * c);
      const double flight = b > 0 ? c / (b + root) : (root - b) / a;
      exit = flight < 0x1p60 ? run.clock.epoch + static_cast<std::int64_t>(run.clock.offset + flight) : run.clock.epoch + far;
    }
  }

  /// Ball i has come to the edge of its shell: it gets another, and its list is mended.
  [[gnu::noinline, gnu::flatten]] static void renew(Run& run, std::uint32_t i) {
    ++run.work.renewals;
    Shells<D>& shells = run.shells;
    shells.displace(i);
    place(run, i);
    const std::uint32_t n = shells.gather(run.swarm, i);
    std::uint32_t* const found = shells.found();
    shells.update(i, n, [&](std::uint32_t k) { offer(run, i, found[k], meeting(run, i, found[k])); });
    set_exit(run, i);
    enqueue(run, i);
  }

  // --- the elastic impact ---

  /// The impact of law/impact.hpp for e = 1 and finite masses: the same operations, those by powers of two left out.
  [[gnu::noinline, gnu::flatten]] static void collide(Run& run, std::uint32_t i, std::uint32_t j, const Time<double>& t) {
    using W = DoubleDouble;
    Flight<D>&a = run.swarm.flights[i], &b = run.swarm.flights[j];
    const Flight<D> before_a = a, before_b = b;
    const double lag_a = elapsed(a.time(), t), lag_b = elapsed(b.time(), t);
    double xa[D], xb[D], image[D] = {};
    W r[D], g[D], gr(0.0), rr(0.0);
    for (int k = 0; k < D; ++k) {
      xa[k] = a.x[k] + a.v[k] * lag_a;
      xb[k] = b.x[k] + b.v[k] * lag_b;
      r[k] = two_diff(xb[k], xa[k]);
      if constexpr (periodic) {
        image[k] = nearest_integer((xa[k] - xb[k]) * run.swarm.per_edge[k]);
        if (image[k] != 0) r[k] = r[k] + two_prod(image[k], run.swarm.edge[k]);
      }
      g[k] = two_diff(a.v[k], b.v[k]);
      gr = gr + g[k] * r[k];
      rr = rr + r[k] * r[k];
    }
    const double sigma = run.swarm.template kind<equal>(i).radius + run.swarm.template kind<equal>(j).radius;
    note_gap(run, rr, sigma);
    if (narrow(gr) > 0) {
      const W q = W(2.0) * gr / rr;
      const double ma = run.swarm.template kind<equal>(i).mass, mb = run.swarm.template kind<equal>(j).mass;
      const bool alike = equal || ma == mb;
      const W sa = alike ? W(0.5) : W(mb) / (W(ma) + W(mb)), sb = alike ? W(0.5) : W(ma) / (W(mb) + W(ma));
      for (int k = 0; k < D; ++k) {
        const W change = q * r[k];
        a.v[k] = narrow(W(a.v[k]) - sa * change);
        b.v[k] = narrow(W(b.v[k]) + sb * change);
      }
    }
    int turns[D] = {};
    write(run, i, xa, t, turns, -1);
    write(run, j, xb, t, turns, 1);
    Past&pa = run.swarm.past[i], &pb = run.swarm.past[j];
    const bool hit_a = (pa.flags & Past::hit) != 0, hit_b = (pb.flags & Past::hit) != 0;
    int image_ab[D], image_ba[D];
    for (int k = 0; k < D; ++k) {
      image_ab[k] = static_cast<int>(image[k]) + turns[k];
      image_ba[k] = -image_ab[k];
    }
    remember(pa, run.swarm.number[j], pb.stamp, packed_image<D>(image_ab));
    remember(pb, run.swarm.number[i], pa.stamp, packed_image<D>(image_ba));
    ++run.counts.ball_ball;
    for (int k = 0; k < D; ++k)
      if (!(a.v[k] - a.v[k] == 0) || !(b.v[k] - b.v[k] == 0)) run.verdict = Halt::non_finite;
    if (run.sink != nullptr) detail::report_collision(run, i, j, t, before_a, before_b, hit_a, hit_b, image);
  }

  CAROM_INLINE static void remember(Past& past, std::uint32_t partner, std::uint32_t partner_stamp, std::uint8_t image) {
    past.flags = Past::hit | Past::in_contact;
    past.contact_image = image;
    past.last_partner = partner;
    past.last_feature = 0;
    past.partner_stamp = partner_stamp;
  }

  /// The motion of ball i changes at t: its place is stored, wrapped. Adds side * (periods taken out) to `turns`.
  CAROM_INLINE static void write(Run& run, std::uint32_t i, const double (&x)[D], const Time<double>& t, int (&turns)[D],
                                 int side) {
    Flight<D>& ball = run.swarm.flights[i];
    Past& past = run.swarm.past[i];
    for (int k = 0; k < D; ++k) {
      double at = x[k];
      if constexpr (periodic) {
        const auto& space = run.swarm.rest.space;
        const double share = (at - space.lower[k]) * run.swarm.per_edge[k];
        if (!(share > 0x1p-50 && share < 1 - 0x1p-50)) {  // else the quotient's floor is 0 and nothing is to be done
          const int n = detail::wrap_coordinate(space.lower[k], space.edge[k], at);
          past.image[k] += n;
          turns[k] += side * n;
        }
      }
      ball.x[k] = at;
    }
    ball.epoch = t.epoch;
    ball.offset = t.offset;
    ++past.stamp;
  }

  /// The gap that was left, |r| - sigma, if it is the largest so far: (r.r - sigma^2) / (|r| + sigma), where |r| + sigma is
  /// close to 2 sigma.
  CAROM_INLINE static void note_gap(Run& run, const DoubleDouble& rr, double sigma) {
    const double excess = narrow(rr - two_prod(sigma, sigma));
    const double size = excess < 0 ? -excess : excess;
    if (size < run.exactness.max_gap_error * sigma && size < run.exactness.max_gap_error_relative * sigma * sigma) return;
    const double gap = size / (__builtin_sqrt(narrow(rr)) + sigma);
    if (gap > run.exactness.max_gap_error) run.exactness.max_gap_error = gap;
    if (gap > run.exactness.max_gap_error_relative * sigma) run.exactness.max_gap_error_relative = gap / sigma;
  }
};

}  // namespace carom
