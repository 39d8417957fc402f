#pragma once
// Whom a ball of a swarm meets first, and second: from its list, with the bits of one pair alone.

#include <cstdint>

#include "carom/predict/first_meetings.hpp"
#include "carom/sim/swarm_exits.hpp"
#include "carom/sim/swarm_run.hpp"

namespace carom {

/// `Target`: see SwarmLoop.
template <int D, class Target, bool periodic, bool equal>
class SwarmPredictions {
 public:
  using Run = SwarmRun<D>;
  using Exits = SwarmExits<D, Target, periodic, equal>;
  static constexpr std::uint32_t nobody = FirstMeetings::nobody;

  /// Both meetings of balls i and j, which have just hit each other at run.now, are found anew.
  [[gnu::noinline, gnu::flatten]] static void look_around(Run& run, std::uint32_t i, std::uint32_t j) {
    if (!periodic || (!equal && (many_near(run, i) || many_near(run, j)))) {
      look_at_all(run, i, j);
      look_at_all(run, j, i);
      return Exits::set_exits(run, i, j);
    }
    Look a, b;
    look(run, i, j, a);
    look(run, j, i, b);
    Exits::set_exits(run, i, j);
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

  /// Both meetings of ball i are found anew, from the moment of its last collision, run.now.
  [[gnu::noinline, gnu::flatten]] static void look_at_all(Run& run, std::uint32_t i, std::uint32_t hit = nobody) {
    Look at;
    if (!equal && many_near(run, i)) {
      look_at_many(run, i, hit, at);
    } else {
      look(run, i, hit, at);
      meet(run, i, at);
    }
    if (!settle(run, i, at)) return look_again(run, i);
    FirstMeetings found;
    for (int k = 0; k < 3; ++k) found.offer(at.first.flight[k], static_cast<std::uint32_t>(at.first.row[k]));
    if constexpr (!periodic)
      for (std::size_t f = 0; f < run.swarm.rest.walls.faces.size(); ++f)
        found.offer(flight_to_face(run, i, f), Slot::wall + static_cast<std::uint32_t>(f));
    if (near_walls(run, i))
      for (std::size_t f = run.swarm.rest.walls.faces.size(); f < run.pieces; ++f)
        found.offer(detail::flight_to_piece(run, i, f), Slot::wall + static_cast<std::uint32_t>(f));
    if (undecided(found.flight[0], found.flight[1], found.flight[2])) return look_again(run, i);
    Slot& slot = run.shells.slots[i];
    const Time<double> since = run.swarm.flights[i].time();
    slot.first = after(since, found.flight[0]);
    slot.partner = found.partner[0];
    slot.second = after(since, found.flight[1]);
    slot.second_partner = found.partner[1];
  }

  /// The same whatever the stored times, pair by pair and in the total order of events.
  CAROM_INLINE static void look_again(Run& run, std::uint32_t i) {
    Slot& slot = run.shells.slots[i];
    slot.first = slot.second = Time<double>::never();
    slot.partner = slot.second_partner = nobody;
    run.shells.for_each_piece(i, [&](const std::uint32_t* near, std::uint32_t count) {
      for (std::uint32_t k = 0; k < count; ++k)
        if (!hit_later(run, near[k], i)) offer(run, i, near[k], meeting(run, i, near[k]));
    });
    if constexpr (!periodic)
      for (std::size_t f = 0; f < run.swarm.rest.walls.faces.size(); ++f)
        offer(run, i, Slot::wall + static_cast<std::uint32_t>(f),
              after(run.swarm.flights[i].time(), flight_to_face(run, i, f)));
    offer_walls(run, i);
  }

  /// The meetings of ball i with walls that are no faces take their places among those known, if its shell reaches them.
  CAROM_INLINE static void offer_walls(Run& run, std::uint32_t i) {
    if (!near_walls(run, i)) return;
    for (std::size_t f = run.swarm.rest.walls.faces.size(); f < run.pieces; ++f)
      offer(run, i, Slot::wall + static_cast<std::uint32_t>(f),
            after(run.swarm.flights[i].time(), detail::flight_to_piece(run, i, f)));
  }
  CAROM_INLINE static bool near_walls(const Run& run, std::uint32_t i) {
    return !periodic && run.near_walls.size() != 0 && run.near_walls[i] != 0;
  }

  /// Ball j has been hit after ball i: what they are to each other is known to j.
  CAROM_INLINE static bool hit_later(const Run& run, std::uint32_t j, std::uint32_t i) {
    const Flight<D>&a = run.swarm.flights[i], &b = run.swarm.flights[j];
    return (b.epoch > a.epoch) | ((b.epoch == a.epoch) & (b.offset > a.offset));
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
    const double sigma = run.swarm.template radius_of<equal>(i) + run.swarm.template radius_of<equal>(j), ss = sigma * sigma;
    if (b >= 0.0 && rr > detail::apart * ss) return Time<double>::never();
    double a = g[0] * g[0], cross;
    for (int k = 1; k < D; ++k) a += g[k] * g[k];
    if constexpr (D == 2) {
      cross = (r[0] * g[1] - r[1] * g[0]) * (r[0] * g[1] - r[1] * g[0]);
    } else {
      const double x = r[1] * g[2] - r[2] * g[1], y = r[2] * g[0] - r[0] * g[2], z = r[0] * g[1] - r[1] * g[0];
      cross = x * x + y * y + z * z;
    }
    double t;
    if (!detail::meet_plainly(b, rr - ss, ss, a * ss - cross, a * rr, t))
      t = detail::careful_flight(run, i, j, image, r, g, sigma);
    return after(since, t);
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
      slot.first = t;
      slot.partner = partner;
    } else if (slot.second_partner != Slot::unknown && before(slot.second, slot.second_partner)) {
      slot.second = t;
      slot.second_partner = partner;
    }
  }

 private:
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

  /// Too many for one look.
  CAROM_INLINE static bool many_near(const Run& run, std::uint32_t i) { return run.shells.slots[i].count >= most_near; }

  /// `look` and `meet`, some at a time.
  [[gnu::noinline, gnu::flatten]] static void look_at_many(Run& run, std::uint32_t i, std::uint32_t hit, Look& at) {
    constexpr std::uint32_t some = most_near - lanes;
    auto& terms = at.terms;
    terms.b[most_near] = terms.rr[most_near] = terms.a[most_near] = terms.cross[most_near] = 1;
    if constexpr (!equal) terms.sigma[most_near] = 1;
    at.count = run.shells.slots[i].count;
    run.work.predictions += at.count;
    at.first = meet_four(terms, 0, run.shells.slots[i].near, 0);
    run.shells.for_each_piece(i, [&](const std::uint32_t* near, std::uint32_t count) {
      for (std::uint32_t from = 0; from < count; from += some) {
        const std::uint32_t n = count - from < some ? count - from : some;
        find_candidates<D, periodic>(run.swarm, i, near + from, n, (n + lanes - 1) / lanes, run.reach, terms);
        terms.candidates &= ~bits_of(near + from, n, hit);
        for (std::uint64_t left = terms.candidates; left != 0;) {
          const FirstFew few = meet_four(terms, left, near + from, 2 * run.swarm.template radius_of<equal>(i));
          left = few.left;
          at.first.merge(few);
        }
      }
    });
    at.first.left = 0;
  }

  CAROM_INLINE static void meet(const Run& run, std::uint32_t i, Look& at) {
    at.first = meet_four(at.terms, at.terms.candidates, at.near, 2 * run.swarm.template radius_of<equal>(i));
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
      at.first.merge(meet_four(at.terms, at.first.left, at.near, 2 * run.swarm.template radius_of<equal>(i)));
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

  CAROM_INLINE static void keep(Run& run, std::uint32_t i, const FirstFew& few, const long long* epoch, const double* offset) {
    Slot& slot = run.shells.slots[i];
    slot.first = {epoch[0], offset[0]};
    slot.partner = static_cast<std::uint32_t>(few.row[0]);
    slot.second = {epoch[1], offset[1]};
    slot.second_partner = static_cast<std::uint32_t>(few.row[1]);
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
    const double sigma = run.swarm.template radius_of<equal>(i) + run.swarm.template radius_of<equal>(j);
    double r[D], g[D], image[D];
    (void)pair_state<D, periodic>(run.swarm, i, j, run.clock, r, g, image);
    Vec<double, D> place, velocity;
    for (int m = 0; m < D; ++m) {
      place[m] = r[m];
      velocity[m] = g[m];
    }
    return detail::meet_time_wide<D>(place, velocity, sigma, t);
  }

  CAROM_INLINE static double flight_to_face(const Run& run, std::uint32_t i, std::size_t f) {
    const auto& face = run.swarm.rest.walls.faces[f];
    const Flight<D>& ball = run.swarm.flights[i];
    const double rate = face.sign > 0 ? ball.v[face.axis] : -ball.v[face.axis];
    if (!(rate < 0)) return never<double>();
    const double x = ball.x[face.axis];
    const double gap = (face.sign > 0 ? x - face.coordinate : face.coordinate - x) - run.swarm.template radius_of<equal>(i);
    return gap > 0 ? gap / -rate : 0.0;
  }
};

}  // namespace carom
