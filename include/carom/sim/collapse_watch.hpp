#pragma once
// Recognises infinitely many impacts in finite time: an accumulation of dissipating impacts, or a contact that never ends.

#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "carom/core/clock.hpp"
#include "carom/core/real.hpp"

namespace carom {

/// Follows each ball's unbroken streak of dissipating impacts (restitution below 1). Over blocks of `block` impacts the
/// durations d of an accumulation fall geometrically, so the rest of the streak takes d q / (1 - q), q = d / (duration of
/// the block before). The streak is a collapse when that rest is no tick of the clock. A streak that takes no time at all
/// is a persistent contact after `instant_limit` impacts. So is one of `weak_limit` impacts in a row, below 2^-32 of the
/// streak's strongest, at no more than `resolved_by(e)` ticks from one to the next: impulses that shrink by a factor at each
/// impact reach rounding (velocities equal to the last bit, and no more events) after some fifty, or else the rounding of
/// flights to ticks keeps them going for ever. One weak impact alone is a contact that grazes within rounding. Elastic
/// impacts break a streak, so no elastic sequence is ever a collapse.
template <class Real>
class CollapseWatch {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  struct Streak {
    std::array<std::uint32_t, 4> recent{none, none, none, none};
    std::uint32_t count = 0;
    std::uint32_t instant = 0;
    std::uint32_t weak = 0;    // impacts in a row, within the clock's resolution, far below the strongest
    Real strongest = Real(0);  // impulse of the streak
    Time<Real> last, block_start;
    Real duration = Real(0);
  };

  static constexpr std::uint32_t block = 16;
  static constexpr std::uint32_t instant_limit = 4096;
  static constexpr std::uint32_t weak_limit = 6;

  void reset(std::size_t balls) { streaks_.assign(balls, Streak{}); }
  [[nodiscard]] bool watching() const noexcept { return !streaks_.empty(); }

  /// [ticks] Bounces on a floor of restitution e < 1 whose flights, of n ticks, are shorter than this do not die away: with
  /// a flight rounded to n ticks the ball falls back at g n - v and leaves at v = e (g n - v) = g n e / (1 + e), so that the
  /// next flight 2 v / g = n - n (1 - e) / (1 + e) is rounded to n again as long as n (1 - e) / (1 + e) <= 1/2.
  [[nodiscard]] static Real resolved_by(const Real& e) { return (1 + e) / (2 * (1 - e)); }

  void end_streak(std::uint32_t ball) {
    if (watching()) streaks_[ball] = Streak{};
  }

  /// The balls that `ball` hit last in its streak.
  [[nodiscard]] std::vector<std::uint32_t> partners(std::uint32_t ball) const {
    std::vector<std::uint32_t> recent;
    for (const std::uint32_t p : streaks_[ball].recent)
      if (p != none) recent.push_back(p);
    return recent;
  }

  /// Counts an impact of `ball` at `now` with restitution e < 1, of size `impulse`; true if it belongs to a collapse.
  /// `balls` are those that took part.
  [[nodiscard]] bool collapses(std::uint32_t ball, const Time<Real>& now, std::initializer_list<std::uint32_t> balls,
                               const Real& impulse, const Real& e) {
    Streak& s = streaks_[ball];
    for (const std::uint32_t p : balls)
      if (p != ball) s.recent[s.count % s.recent.size()] = p;
    s.instant = s.count > 0 && now == s.last ? s.instant + 1 : 0;
    const bool unresolved = s.count > 0 && elapsed(s.last, now) <= resolved_by(e) * unit_roundoff<Real>();
    s.last = now;
    if (s.count == 0) s.block_start = now;
    ++s.count;
    if (impulse > s.strongest) s.strongest = impulse;
    s.weak = unresolved && impulse <= s.strongest * Real(0x1p-32) ? s.weak + 1 : 0;
    if (s.instant >= instant_limit || s.weak >= weak_limit) return true;
    if (s.count % block != 0) return false;
    const Real duration = elapsed(s.block_start, now);
    const Real before = s.duration;
    s.block_start = now;
    s.duration = duration;
    if (s.count < 2 * block || !(duration > 0) || !(duration < before)) return false;
    const Real q = duration / before;
    return after(now, Real(duration * q / (1 - q))) == now;
  }

  /// By ball; empty if nothing is watched. For checkpoints.
  [[nodiscard]] std::vector<Streak>& streaks() noexcept { return streaks_; }
  [[nodiscard]] const std::vector<Streak>& streaks() const noexcept { return streaks_; }

 private:
  std::vector<Streak> streaks_;
};

}  // namespace carom
