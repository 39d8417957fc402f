#pragma once
// The event-driven integrator for few balls: a table of all meetings to come, of which the first happens.
//
// The events are those of EventDriven, bit for bit: the same contact times of the same stored states. What is not settled
// here (a pair close to contact or grazing, a velocity whose rounding is in doubt, an impact that dissipates) is computed by
// the code of EventDriven; what is out of the ordinary, two events at one moment above all, is left to it.

#include <atomic>
#include <cmath>
#include <cstdint>

#include "carom/sim/few_flights.hpp"
#include "carom/sim/few_impacts.hpp"
#include "carom/sim/few_run.hpp"

namespace carom {

/// `Target` is the instruction set that this is compiled for: a name of its own keeps the versions apart.
template <int D, class Target, bool periodic>
class FewLoop {
 public:
  using Run = FewRun<D>;

  [[gnu::flatten]] static FewHalt advance(Run& run, const Time<double>& until, std::int64_t goal,
                                          const std::atomic<bool>* interrupt) {
    EventCounts& counts = run.collider->counts;
    while (true) {
      if (counts.collisions() >= goal) return FewHalt::events;
      if (interrupt != nullptr && interrupt->load(std::memory_order_relaxed)) return FewHalt::interrupted;
      bool tied = false;
      const std::uint32_t s = run.slots == 1 ? 0 : first(run, tied);
      if (run.slots == 0 || !(run.flight[s] < never<double>())) return periodic ? FewHalt::unusual : FewHalt::idle;
      typename Run::Slot& slot = run.slot[s];
      const std::uint32_t i = slot.low, j = slot.high;
      const Time<double> t = time_of(run, s);
      if (t > until) return FewHalt::until;
      if (periodic && !slot.settled && !t.is_never()) {
        if (++run.passages > 8 + 4 * static_cast<std::int64_t>(run.slots)) return FewHalt::unusual;
        if (i == j) {
          detail::predict_walls(run, i);
        } else {
          detail::predict_pair(run, s);
        }
        continue;
      }
      if (i == j) tied = tied || run.wall[i].tied;
      if (tied || t.is_never() || !(t > run.now)) return FewHalt::unusual;
      const bool usual = run.plain && (i == j ? Impacts::hit_wall(run, i, t) : Impacts::hit_ball(run, slot, t));
      if (!usual) {
        const Verdict verdict = detail::collide_slot(run, s, t);
        if (verdict != Verdict::go_on) {
          run.now = t;
          return verdict == Verdict::collapse ? FewHalt::collapse : FewHalt::non_finite;
        }
      }
      run.now = t;
      run.passages = 0;
      if (t.epoch - run.base > most_epochs) detail::rebase(run);
      Flights::look(run, i, j);
      if (i != j && (run.other_count[j] > 1 || !run.world->balls[j].fixed)) Flights::look(run, j, i);
    }
  }

 private:
  using Impacts = FewImpacts<D, Target, periodic>;
  using Flights = FewFlights<D, Target, periodic>;
  static constexpr std::int64_t most_epochs = std::int64_t{1} << 20;

  /// The slot whose event comes first; `tied`: two come at one moment.
  CAROM_INLINE static std::uint32_t first(const Run& run, bool& tied) {
    double least_due = run.due[0], second = never<double>();
    std::uint32_t at = 0;
    if (run.slots <= 6) {
      for (std::uint32_t s = 1; s < run.slots; ++s) {
        const double d = run.due[s];
        const bool less = d < least_due;
        const double loser = less ? least_due : d;
        second = loser < second ? loser : second;
        least_due = less ? d : least_due;
        at = less ? s : at;
      }
    } else {
      const double* const due = run.due.data();
      Lanes one = load(due), two = spread(never<double>());
      LaneMask where = {0, 1, 2, 3}, best = where;
      for (std::uint32_t s = lanes; s < run.slots; s += lanes) {
        const Lanes d = load(due + s);
        where += lanes;
        const LaneMask less = d < one;
        two = least(two, less ? one : d);
        best = less ? where : best;
        one = less ? d : one;
      }
      const Lanes all = least_of(one);
      const int k = __builtin_ctz(static_cast<unsigned>(sign_bits(one == all)) | 16u);
      least_due = all[0];
      at = static_cast<std::uint32_t>(best[k & 3]);
      const Lanes rest = (LaneMask{0, 1, 2, 3} == LaneMask{} + k) ? two : least(one, two);
      second = least_of(rest)[0];
    }
    // Three roundings of numbers not above it lie between a due time and the true one.
    if (second - least_due > 0x1p-50 * std::fabs(second) + 0x1p-50 || !(second < never<double>())) return at;
    return detail::first_of_close(run, second, tied);
  }
};

}  // namespace carom
