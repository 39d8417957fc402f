#pragma once
// Recognises infinitely many impacts in finite time: an accumulation of dissipating impacts, or a contact that never ends.

#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "carom/core/clock.hpp"

namespace carom {

/// Follows each ball's unbroken streak of dissipating impacts (restitution below 1). Over blocks of `block` impacts the
/// durations d of an accumulation fall geometrically, so the rest of the streak takes d q / (1 - q), q = d / (duration of
/// the block before). The streak is a collapse when that rest is no tick of the clock. A streak that takes no time at all
/// is a persistent contact after `instant_limit` impacts, or after `weak_limit` in a row below 2^-32 of the streak's
/// strongest: impulses that shrink by a factor at each impact reach rounding (velocities equal to the last bit, and no more
/// events) after some fifty. One weak impact alone is a contact that grazes within rounding. Elastic impacts break a
/// streak, so no elastic sequence is ever a collapse.
template <class Real>
class CollapseWatch {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  struct Streak {
    std::array<std::uint32_t, 4> recent{none, none, none, none};
    std::uint32_t count = 0;
    std::uint32_t instant = 0;
    std::uint32_t weak = 0;    // impacts in a row, at one moment, far below the strongest
    Real strongest = Real(0);  // impulse of the streak
    Time<Real> last, block_start;
    Real duration = Real(0);
  };

  static constexpr std::uint32_t block = 16;
  static constexpr std::uint32_t instant_limit = 4096;
  static constexpr std::uint32_t weak_limit = 6;

  void reset(std::size_t balls) { streaks_.assign(balls, Streak{}); }
  [[nodiscard]] bool watching() const noexcept { return !streaks_.empty(); }

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

  /// Counts a dissipating impact of `ball` at `now`, of size `impulse`; true if it belongs to a collapse. `balls` are those
  /// that took part.
  [[nodiscard]] bool collapses(std::uint32_t ball, const Time<Real>& now, std::initializer_list<std::uint32_t> balls,
                               const Real& impulse) {
    Streak& s = streaks_[ball];
    for (const std::uint32_t p : balls)
      if (p != ball) s.recent[s.count % s.recent.size()] = p;
    s.instant = s.count > 0 && now == s.last ? s.instant + 1 : 0;
    s.last = now;
    if (s.count == 0) s.block_start = now;
    ++s.count;
    if (impulse > s.strongest) s.strongest = impulse;
    s.weak = s.instant > 0 && impulse <= s.strongest * Real(0x1p-32) ? s.weak + 1 : 0;
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
