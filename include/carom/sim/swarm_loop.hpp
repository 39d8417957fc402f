#pragma once
// The event-driven integrator for many balls: the algorithm of event_driven.hpp on records made for speed.
//
// One live event a ball [Lubachevsky1991], neighbour lists (search/shells.hpp), a calendar (queue/calendar.hpp). A ball
// keeps its first meeting and its second: if the partner of the first is hit by another, the second is a bound below all
// that are left, so it is queued in its place, and the list is gone through anew only if that one surfaces and is stale
// too. When two balls meet is known to the one that was hit later, and to both if that was at one moment: a meeting is
// stale if its partner's stored time has become later than the ball's own. The events are those of EventDriven, bit for
// bit; what is out of the ordinary, a second event of a ball at one moment above all, is left to it.

#include <atomic>
#include <cstdint>

#include "carom/sim/swarm_agenda.hpp"
#include "carom/sim/swarm_exits.hpp"
#include "carom/sim/swarm_impact.hpp"
#include "carom/sim/swarm_predictions.hpp"
#include "carom/sim/swarm_run.hpp"

namespace carom {

/// `Target` is the instruction set that this is compiled for: a name of its own keeps the versions apart.
template <int D, class Target, bool periodic, bool equal>
class SwarmLoop {
 public:
  using Run = SwarmRun<D>;
  using Agenda = SwarmAgenda<D, Target, periodic, equal>;
  using Exits = SwarmExits<D, Target, periodic, equal>;
  using Impact = SwarmImpact<D, Target, periodic, equal>;
  using Predictions = SwarmPredictions<D, Target, periodic, equal>;

  [[gnu::flatten]] static void start(Run& run) {
    const std::uint32_t n = run.swarm.size();
    run.clock = run.now;
    for (std::uint32_t i = 0; i < n; ++i) Exits::place(run, i);
    for (std::uint32_t i = 0; i < n; ++i) {
      Slot& slot = run.shells.slots[i];
      slot.count = 0;
      const std::uint32_t found = run.shells.template gather<periodic, equal>(i);
      for (std::uint32_t k = 0; k < found; ++k) run.shells.add(i, run.shells.found()[k]);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      Predictions::look_again(run, i);  // stored times differ where a run goes on from a state
      Exits::set_exits(run, i, i);
    }
    detail::refill_calendar(run);
  }

  [[gnu::flatten]] static Halt advance(Run& run, const Time<double>& until, std::int64_t goal,
                                       const std::atomic<bool>* interrupt) {
    typename Agenda::Waiting waiting;
    const Halt halt = go_on(run, until, goal, interrupt, waiting);
    Agenda::enqueue_waiting(run, waiting);
    return halt;
  }

 private:
  CAROM_INLINE static Halt go_on(Run& run, const Time<double>& until, std::int64_t goal, const std::atomic<bool>* interrupt,
                                 typename Agenda::Waiting& waiting) {
    while (true) {
      if (run.counts.collisions() >= goal) return Halt::events;
      if (interrupt != nullptr && interrupt->load(std::memory_order_relaxed)) return Halt::interrupted;
      if (run.head == run.agenda.size()) {
        Agenda::enqueue_waiting(run, waiting);
        if (!Agenda::next_bucket(run)) return Halt::idle;
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
      if (run.far_sighted) Agenda::fetch_ahead(run);
      if (due.time > run.clock) run.clock = due.time;
      if (slot.exit_first()) {
        ++run.head;
        renew(run, i);
        if (slot.exit <= run.clock.epoch || ++run.quiet > 1024 + 64 * static_cast<std::int64_t>(run.swarm.size())) return Halt::unusual;
        continue;
      }
      const std::uint32_t j = slot.partner;
      const bool wall = j >= Slot::wall;
      if (!wall && Predictions::hit_later(run, j, i)) {
        ++run.head;
        ++run.exactness.repredicted;
        fall_back(run, i);
        continue;
      }
      const Time<double> t = due.time;
      if (run.swarm.flights[i].time() == t || (!wall && run.swarm.flights[j].time() == t)) return Halt::unusual;
      if (run.plain && !wall) {
        Impact::collide(run, i, j, t);
      } else if (!detail::collide_carefully(run, i, j, t)) {
        return Halt::unusual;
      }
      ++run.head;
      run.exactness.clamped += t < run.now;
      const bool again = !(t > run.now);
      run.now = t;
      run.quiet = 0;
      Agenda::enqueue_waiting(run, waiting);
      if (wall) {
        Predictions::look_at_all(run, i, Predictions::nobody);
        Exits::set_exits(run, i, i);
        Agenda::enqueue(run, i);
      } else {
        Predictions::look_around(run, i, j);
        Agenda::enqueue_later(run, i, j, waiting);
      }
      if (again) [[unlikely]] {
        look_from_beside(run, i);
        if (!wall) look_from_beside(run, j);
      }
      if (run.verdict != Halt::until) return std::exchange(run.verdict, Halt::until);
    }
  }

  /// The partner of ball i's first meeting has been hit by another.
  [[gnu::noinline, gnu::flatten]] static void fall_back(Run& run, std::uint32_t i) {
    Slot& slot = run.shells.slots[i];
    if (slot.second_partner == Slot::unknown) {
      ++run.work.rescans;
      Predictions::look_again(run, i);
    } else {
      slot.first = slot.second;
      slot.partner = slot.second_partner;
      slot.second_partner = Slot::unknown;
    }
    Agenda::enqueue(run, i);
  }

  /// Balls i and j have become neighbours: when they meet is known to the one that was hit later.
  CAROM_INLINE static void meet_anew(Run& run, std::uint32_t i, std::uint32_t j) {
    const Time<double> t = Predictions::meeting(run, i, j);
    if (!Predictions::hit_later(run, j, i)) return Predictions::offer(run, i, j, t);
    Slot& slot = run.shells.slots[j];
    const Time<double> due = slot.due();
    Predictions::offer(run, j, i, t);
    if (slot.due() != due) Agenda::enqueue(run, j);
  }

  /// Ball i was hit at the moment of the collision before. Those around it that were hit at that moment too have looked at
  /// it as it was, and their times do not tell: they look anew.
  [[gnu::noinline, gnu::flatten]] static void look_from_beside(Run& run, std::uint32_t i) {
    run.shells.for_each_piece(i, [&run, i](const std::uint32_t* near, std::uint32_t count) {
      for (std::uint32_t k = 0; k < count; ++k)
        if (run.swarm.flights[near[k]].time() == run.swarm.flights[i].time()) {
          Predictions::look_again(run, near[k]);
          Agenda::enqueue(run, near[k]);
        }
    });
  }

  /// Ball i has come to the edge of its shell: it gets another, and its list is mended.
  [[gnu::noinline, gnu::flatten]] static void renew(Run& run, std::uint32_t i) {
    ++run.work.renewals;
    Shells<D>& shells = run.shells;
    shells.template displace<equal>(i);
    const bool near_walls = Predictions::near_walls(run, i);
    Exits::place(run, i);
    const std::uint32_t n = shells.template gather<periodic, equal>(i);
    std::uint32_t* const found = shells.found();
    shells.update(
        i, n, [&](std::uint32_t k) { meet_anew(run, i, found[k]); }, [&] { Exits::set_exits(run, i, i); });
    if (!near_walls) Predictions::offer_walls(run, i);
    Agenda::enqueue(run, i);
  }
};

}  // namespace carom
