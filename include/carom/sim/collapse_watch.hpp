#pragma once
// Recognises infinitely many impacts in finite time: an accumulation of dissipating impacts, or a contact that never ends.

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "carom/core/clock.hpp"
#include "carom/core/real.hpp"

namespace carom {

/// A change of velocity of so many of its own roundings is lost in them [papers/collapse.md, eq. 6].
inline constexpr double lost_in_rounding = 64.0;

/// Follows the contacts of each ball in blocks of `block`. In an accumulation the durations d of the blocks and the largest
/// impulses J in them fall by factors, so the rest of it takes d q / (1 - q), q = d / d_before [papers/collapse.md, eq. 1],
/// and exchanges J s / (1 - s), s = J / J_before [eq. 2]. It is a collapse when nothing of that rest can be seen:
///   the rest is no tick of the clock (eq. 3), and has no energy beside the strongest impact (eq. 4);
///   or it takes no time at all, and the rest of its impulses is below a rounding of the largest of them, or their factor s
///   has not fallen in `blocks_in_turn` blocks (eq. 5);
///   or each of the last `falls_in_turn` impulses of the ball was below the one before, and the last is lost in the
///   rounding of the velocities (eq. 6); or the clock cannot tell one block from the next, in which the parties move by
///   less than a rounding of their coordinates (eq. 7).
/// Where an infinite mass that moves takes part, impulses need not fall: it crushes what it meets.
/// A block in which nothing dissipates breaks the sequence, so no elastic sequence is ever a collapse.
template <class Real>
class CollapseWatch {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::uint32_t block = 16;
  static constexpr std::uint32_t falls_in_turn = 8;
  static constexpr std::uint32_t blocks_in_turn = 16;

  struct Streak {
    std::array<std::uint32_t, 4> recent{none, none, none, none};
    std::uint32_t count = 0;
    std::uint32_t falls = 0;   // impulses in turn, each below the one before
    bool dissipates = false;   // an impact of this block did
    bool driven = false;       // by an infinite mass that moves, in this block
    std::uint32_t steady = 0;  // blocks in turn at one moment whose impulses fall by no smaller factor than before
    Real factor = Real(0);     // by which they fell last
    Real impulse = Real(0);    // the last
    Real largest = Real(0);    // of this block
    Real before = Real(0);     // of the block before
    Real strongest = Real(0);  // since time last went on
    Real peak = Real(0);       // of the streak
    Time<Real> block_start;
    Real duration = Real(0);  // of the block before
  };

  /// What the watch is told of a contact.
  struct Contact {
    Time<Real> now;
    Real impulse;   ///< size
    Real rounding;  ///< of the velocities, as an impulse
    Real place;     ///< a rounding of the coordinates, times the smaller mass
    bool dissipates;
    bool driven;  ///< one party is an infinite mass that moves
  };

  void reset(std::size_t balls) { streaks_.assign(balls, Streak{}); }
  [[nodiscard]] bool watching() const noexcept { return !streaks_.empty(); }

  void end_streak(std::uint32_t ball) {
    if (watching()) streaks_[ball] = Streak{};
  }

  /// The balls that `ball` hit last in its streak.
  [[nodiscard]] std::vector<std::uint32_t> partners(std::uint32_t ball) const {
    std::vector<std::uint32_t> recent;
    if (!watching()) return recent;
    for (const std::uint32_t p : streaks_[ball].recent)
      if (p != none) recent.push_back(p);
    return recent;
  }

  /// Counts a contact of `ball`; true if it belongs to a collapse. `balls` are those that took part.
  [[nodiscard]] bool collapses(std::uint32_t ball, std::initializer_list<std::uint32_t> balls, const Contact& contact) {
    Streak& s = streaks_[ball];
    for (const std::uint32_t p : balls)
      if (p != ball) s.recent[s.count % s.recent.size()] = p;
    if (s.count == 0) s.block_start = contact.now;
    s.falls = s.count > 0 && contact.impulse < s.impulse ? s.falls + 1 : 0;
    s.impulse = contact.impulse;
    s.largest = std::max(s.largest, contact.impulse);
    s.strongest = std::max(s.strongest, contact.impulse);
    s.dissipates = s.dissipates || contact.dissipates;
    s.driven = s.driven || contact.driven;
    ++s.count;
    if (contact.dissipates && s.falls + 1 >= falls_in_turn && contact.impulse <= Real(lost_in_rounding) * contact.rounding)
      return true;
    return s.count % block == 0 && ends_block(s, contact);
  }

  /// By ball; empty if nothing is watched. For checkpoints.
  [[nodiscard]] std::vector<Streak>& streaks() noexcept { return streaks_; }
  [[nodiscard]] const std::vector<Streak>& streaks() const noexcept { return streaks_; }

 private:
  [[nodiscard]] static bool ends_block(Streak& s, const Contact& contact) {
    if (!s.dissipates) {
      s = Streak{};
      return false;
    }
    const Real duration = elapsed(s.block_start, contact.now);
    s.peak = std::max(s.peak, s.largest);
    const bool over =
        s.count >= 2 * block && (duration == 0 && s.duration == 0 ? over_at_once(s) : over_in_time(s, duration, contact));
    if (duration > 0) {
      s.strongest = s.largest;
      s.steady = 0;
      s.factor = Real(0);
    }
    s.block_start = contact.now;
    s.duration = duration;
    s.before = s.largest;
    s.largest = Real(0);
    s.dissipates = s.driven = false;
    return over;
  }

  /// Two blocks that took no time [papers/collapse.md, eq. 5].
  [[nodiscard]] static bool over_at_once(Streak& s) {
    if (s.largest == 0) return true;
    if (!(s.largest < s.before)) {
      s.steady = 0;
      return false;
    }
    const Real u = unit_roundoff<Real>(), factor = s.largest / s.before;
    s.steady = factor >= s.factor * (1 - Real(lost_in_rounding) * u) ? s.steady + 1 : 0;
    s.factor = factor;
    return s.steady >= blocks_in_turn || s.largest * factor <= u * s.strongest * (1 - factor);
  }

  [[nodiscard]] static bool over_in_time(const Streak& s, const Real& duration, const Contact& contact) {
    const Real u = unit_roundoff<Real>();  // and a tick of the clock, in epochs
    const Real faint = s.peak * s.peak * u;
    const Real loss = s.duration - duration;
    if (loss <= Real(block) * u && -loss <= Real(block) * u && s.largest * duration <= contact.place &&
        s.largest * s.largest <= faint)
      return true;  // [eq. 7]
    if (!(duration > 0) || !(loss > 0)) return false;
    const Real rest = s.before > s.largest ? Real(s.largest * s.largest / (s.before - s.largest)) : never<Real>();
    if (!s.driven && !(rest * rest <= faint)) return false;                        // [eq. 4]
    return after(contact.now, Real(duration * (duration / loss))) == contact.now;  // [eq. 3]
  }

  std::vector<Streak> streaks_;
};

}  // namespace carom
