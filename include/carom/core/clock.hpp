#pragma once
// Time that keeps its precision for ever: a count of epochs and an offset on a fixed grid.

#include <cstdint>
#include <limits>

namespace carom {

/// A moment, in units of the epoch length L: `epoch` + `offset`, with offset in [0, 1) a multiple of 2^-p, where p is the
/// number of significand bits of Real (53 for double).
///
/// Two offsets lie on one grid and differ by less than 1, so their difference is exact; `elapsed` is rounded once (while
/// the epochs differ by less than 2^p). Adding a whole number of epochs to every time of a run changes no elapsed time and
/// no offset, so it changes no decision [papers/clock.md].
template <class Real>
struct Time {
  std::int64_t epoch = 0;
  Real offset = Real(0);

  [[nodiscard]] static Time never() { return {std::numeric_limits<std::int64_t>::max(), Real(0)}; }
  [[nodiscard]] bool is_never() const { return epoch == std::numeric_limits<std::int64_t>::max(); }

  friend bool operator==(const Time& a, const Time& b) { return a.epoch == b.epoch && a.offset == b.offset; }
  friend bool operator!=(const Time& a, const Time& b) { return !(a == b); }
  friend bool operator<(const Time& a, const Time& b) {
    return a.epoch < b.epoch || (a.epoch == b.epoch && a.offset < b.offset);
  }
  friend bool operator>(const Time& a, const Time& b) { return b < a; }
  friend bool operator<=(const Time& a, const Time& b) { return !(b < a); }
  friend bool operator>=(const Time& a, const Time& b) { return !(a < b); }
};

/// Moments are kept below this many epochs; what lies beyond is `never`.
inline constexpr std::int64_t last_epoch = std::int64_t{1} << 62;

/// Time from `from` to `to` [L], rounded once.
template <class Real>
[[nodiscard]] inline Real elapsed(const Time<Real>& from, const Time<Real>& to) {
  return Real(to.epoch - from.epoch) + (to.offset - from.offset);
}

/// The moment `flight` >= 0 after `t`, rounded to the grid. Monotone in `flight`. `never` if flight is infinite or leads
/// beyond `last_epoch`.
template <class Real>
[[nodiscard]] inline Time<Real> after(const Time<Real>& t, const Real& flight) {
  constexpr double limit = 4611686018427387904.0;  // 2^62
  if (!(flight < Real(limit))) return Time<Real>::never();
  const std::int64_t whole = static_cast<std::int64_t>(flight);
  const Real part = flight - Real(whole);   // exact: flight and its integer part share a grid
  const Real past = part + (t.offset - 1);  // t.offset - 1 is exact
  const Real sum_of_both = t.offset + part;
  const Real half = Real(1) / 2;
  const bool next = past >= 0 || sum_of_both >= 1;  // the latter: rounded up to the next epoch
  const Real offset = past >= 0 ? past : (next ? Real(0) : sum_of_both);
  const Real on_grid = (offset + half) - half;  // [1/2, 1) has the spacing of the grid
  const Time<Real> sum{t.epoch + whole + (next ? 1 : 0), offset < half ? on_grid : offset};
  if (sum.epoch > last_epoch || sum.epoch < t.epoch) return Time<Real>::never();
  return sum;
}

}  // namespace carom
