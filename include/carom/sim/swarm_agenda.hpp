#pragma once
// What is due next among many balls: the bucket of the calendar at hand, in order, and the records that it will need.

#include <cstdint>

#include "carom/sim/swarm_exits.hpp"
#include "carom/sim/swarm_run.hpp"

namespace carom {

/// `Target`: see SwarmLoop.
template <int D, class Target, bool periodic, bool equal>
class SwarmAgenda {
 public:
  using Run = SwarmRun<D>;
  using Exits = SwarmExits<D, Target, periodic, equal>;

  /// Ball i is entered where it is due.
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

  /// Two balls that are still to be entered, in buckets after the current one. When a ball is due is known late, and where
  /// that belongs nobody can foresee: to put it off until the next impact is under way costs nothing, to wait for it does.
  struct Waiting {
    std::uint32_t ball[2];
    std::int64_t bucket[2];
    bool any = false;
  };

  /// Balls i and j are to be entered where they are due: at once if that is the current bucket. Nobody is waiting.
  CAROM_INLINE static void enqueue_later(Run& run, std::uint32_t i, std::uint32_t j, Waiting& waiting) {
    const Time<double> ti = run.shells.slots[i].due_of_both(), tj = run.shells.slots[j].due_of_both();
    const std::int64_t bi = run.calendar.bucket(ti), bj = run.calendar.bucket(tj), now = run.calendar.current();
    if ((bi <= now) | (bj <= now) | ti.is_never() | tj.is_never()) [[unlikely]] {
      enqueue(run, i);
      enqueue(run, j);
    } else {
      waiting = {{i, j}, {bi, bj}, true};
    }
  }
  [[gnu::noinline]] static void enqueue_waiting(Run& run, Waiting& waiting) {
    if (!waiting.any) return;
    run.calendar.push(waiting.ball[0], waiting.bucket[0]);
    run.calendar.push(waiting.ball[1], waiting.bucket[1]);
    waiting.any = false;
  }

  /// The next fine bucket of the calendar, in order.
  [[gnu::noinline, gnu::flatten]] static bool next_bucket(Run& run) {
    run.head = 0;
    run.agenda.resize(0);
    if (run.work.buckets >= run.next_tuning) detail::tune_calendar(run);
    const auto bucket_of = [&run](std::uint32_t i) { return run.calendar.bucket(run.shells.slots[i].due()); };
    // One step after the other, so that what one entry must wait for keeps no other from being fetched.
    std::size_t found = 0, n = 0;
    const bool any = run.calendar.next(
        [&run, &found](std::uint32_t i) {
          __builtin_prefetch(&run.shells.slots[i]);
          run.drained.resize(found + 1);
          run.drained[found++].ball = i;
        },
        bucket_of);
    if (!any) return detail::refill_calendar(run);
    run.work.drained += static_cast<std::int64_t>(found);
    for (std::size_t k = 0; k < found; ++k) {
      Due& due = run.drained[k];
      const Slot& slot = run.shells.slots[due.ball];
      due.time = slot.due();
      due.partner = slot.partner;
    }
    for (std::size_t k = 0; k < found; ++k) {  // those that are due in another bucket are stale
      const Due due = run.drained[k];
      run.drained[n] = due;
      n += run.calendar.bucket(due.time) == run.calendar.current();
    }
    ++run.work.buckets;
    run.work.due += static_cast<std::int64_t>(n);
    run.agenda.resize(n);
    if (n <= few) {
      sort_by_rank(run, n);
    } else if (n <= 128) {
      sort_by_bins<64>(run, n);
    } else {
      sort_by_bins<256>(run, n);
    }
    if (run.far_sighted)
      for (std::size_t k = 0; k < 20 && k < n; ++k) fetch_parties(run, run.agenda[k]);
    return true;
  }

  /// Fetches what the events to come will read: the records of both parties, then those around them.
  CAROM_INLINE static void fetch_ahead(const Run& run) {
    const std::size_t n = run.agenda.size();
    if (run.head + 20 < n) fetch_parties(run, run.agenda[run.head + 20]);
    if (run.head + 12 < n) {
      const std::uint32_t i = run.agenda[run.head + 12].ball;
      fetch_near(run, i);
      if (run.shells.slots[i].exit_first()) {
        double x[D];
        Exits::find_centre(run, i, run.agenda[run.head + 12].time, x);
        run.shells.template fetch_cells<equal>(i, x);
      }
    }
    if (run.head + 6 < n) {
      const std::uint32_t j = run.agenda[run.head + 6].partner;
      if (j < run.swarm.size()) fetch_near(run, j);
    }
  }

 private:
  CAROM_INLINE static bool earlier(const Run& run, const Due& a, const Due& b) {
    if (a.time.epoch != b.time.epoch) return a.time.epoch < b.time.epoch;
    if (a.time.offset != b.time.offset) return a.time.offset < b.time.offset;
    return a.ball != b.ball && detail::first_due_at_a_tie(run, a.ball, b.ball);
  }

  static constexpr std::size_t few = 24;  ///< below 32: a key of sort_by_rank ends with its place, in five bits

  /// Puts the n <= few balls of the current bucket in order: by shares of its width, without a branch, and then those whose
  /// shares are alike.
  CAROM_INLINE static void sort_by_rank(Run& run, std::size_t n) {
    const Due* const drained = run.drained.data();
    Due* const agenda = run.agenda.data();
    alignas(32) long long key[few], rank[few];
    for (std::size_t k = 0; k < n; ++k)
      key[k] = static_cast<long long>(run.calendar.share(drained[k].time) * 0x1p57) << 5 | static_cast<long long>(k);
    for (std::size_t k = n; k % lanes != 0; ++k) key[k] = 0;
    for (std::size_t k = 0; k < n; k += lanes) {
      const LaneMask keys = *reinterpret_cast<const StoredMask*>(key + k);
      LaneMask after = {};
      for (std::size_t m = 0; m < n; ++m) after -= keys > LaneMask{} + key[m];
      *reinterpret_cast<StoredMask*>(rank + k) = after;
    }
    for (std::size_t k = 0; k < n; ++k) agenda[rank[k]] = drained[k];
    std::uint64_t open = 0;
    for (std::size_t k = 1; k < n; ++k) {
      const Time<double>&a = agenda[k - 1].time, &b = agenda[k].time;
      open |= static_cast<std::uint64_t>((a.epoch > b.epoch) | ((a.epoch == b.epoch) & (a.offset >= b.offset))) << k;
    }
    if (open != 0)
      for (std::size_t k = static_cast<std::size_t>(__builtin_ctzll(open)); k < n; ++k) insert(run, k);
  }

  /// The same for any n: by shares into bins, and then those that are close.
  template <std::uint32_t bins>
  CAROM_INLINE static void sort_by_bins(Run& run, std::size_t n) {
    std::uint32_t begin[bins + 1] = {};
    PageArray<std::uint8_t>& bin = run.bins;
    bin.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double share = run.calendar.share(run.drained[k].time) * bins;
      bin[k] = static_cast<std::uint8_t>(share < bins - 1 ? static_cast<std::int32_t>(share) : static_cast<std::int32_t>(bins - 1));
      ++begin[bin[k] + 1];
    }
    for (std::uint32_t b = 0; b < bins; ++b) begin[b + 1] += begin[b];
    for (std::size_t k = 0; k < n; ++k) run.agenda[begin[bin[k]]++] = run.drained[k];
    for (std::size_t k = 1; k < n; ++k) insert(run, k);
  }

  /// Entry k of the agenda goes to its place among those before it, which are in order.
  CAROM_INLINE static void insert(Run& run, std::size_t k) {
    const Due due = run.agenda[k];
    for (; k > 0 && earlier(run, due, run.agenda[k - 1]); --k) run.agenda[k] = run.agenda[k - 1];
    run.agenda[k] = due;
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
    run.shells.template fetch_home<equal>(i);
    __builtin_prefetch(&run.shells.slots[i].near);
  }

  CAROM_INLINE static void fetch_near(const Run& run, std::uint32_t i) {
    const Slot& slot = run.shells.slots[i];
    // All that there is room for: a branch for the number of neighbours would cost more than rows that are not in the list.
    for (std::uint32_t k = 0; k < Slot::here; ++k) {
      __builtin_prefetch(&run.swarm.flights[slot.near[k]]);
      if constexpr (!equal) __builtin_prefetch(&run.swarm.radius[slot.near[k]]);
    }
  }
};

}  // namespace carom
