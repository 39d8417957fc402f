#pragma once
// Sums over a time of unknown length, with the standard error of any function of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "carom/observe/estimate.hpp"

namespace carom {

/// K sums, kept apart for 32 to 64 blocks of equal time. When time runs out of the 64th block, neighbours are joined two by
/// two and blocks last twice as long [FlyvbjergPetersen1989, sec. IV: their transformation]; so memory is constant, and a
/// run may be of any length.
///
/// Errors come from leaving out one complete block after the other (the jackknife [Efron1982, ch. 3]); for a mean this is
/// the standard error of block averages. It is right where what is summed forgets itself within a block, that is within
/// 1/64 of the time measured, and is itself known to about 1/sqrt(2 n) of its size for n blocks: 13 to 9 %.
template <std::size_t K>
class BlockSums {
 public:
  using Sums = std::array<double, K>;
  static constexpr std::size_t most_blocks = 64;

  /// `first_length` > 0 is the length of the first blocks: far below the times to be measured.
  explicit BlockSums(double first_length) : length_(first_length) {}

  /// Adds x at time t >= 0 since the beginning.
  void add(double t, const Sums& x) {
    make_room(t);
    add_to(block_of(t), x, 1.0);
  }

  /// Adds x, spread evenly over the times from `begin` to `end`.
  void spread(double begin, double end, const Sums& x) {
    make_room(end);
    const std::size_t first = block_of(begin), last = block_of(end);
    if (first == last) return add_to(first, x, 1.0);
    const double share = 1.0 / (end - begin);
    for (std::size_t k = first; k <= last; ++k) {
      const double from = std::max(begin, static_cast<double>(k) * length_);
      const double to = std::min(end, static_cast<double>(k + 1) * length_);
      add_to(k, x, (to - from) * share);
    }
  }

  /// Measuring ends at t.
  void end(double t) {
    make_room(t);
    complete_ = block_of(t);
  }

  [[nodiscard]] std::size_t complete_blocks() const noexcept { return complete_; }

  [[nodiscard]] Sums total() const {
    Sums sum{};
    for (const Sums& block : blocks_)
      for (std::size_t i = 0; i < K; ++i) sum[i] += block[i];
    return sum;
  }

  /// f(sums) with its standard error. `f` must not depend on how long was measured, other than through the sums. With less
  /// than two complete blocks the error is NaN.
  template <class F>
  [[nodiscard]] Estimate estimate(std::string name, F&& f) const {
    const Sums all = total();
    Estimate e{std::move(name), f(all)};
    if (complete_ < 2) return e;
    std::array<double, most_blocks> without;
    double mean = 0;
    for (std::size_t k = 0; k < complete_; ++k) {
      Sums rest = all;
      for (std::size_t i = 0; i < K; ++i) rest[i] -= blocks_[k][i];
      without[k] = f(rest);
      mean += without[k];
    }
    const double n = static_cast<double>(complete_);
    mean /= n;
    double squares = 0;
    for (std::size_t k = 0; k < complete_; ++k) squares += (without[k] - mean) * (without[k] - mean);
    e.error = std::sqrt(squares * (n - 1) / n);
    return e;
  }

 private:
  [[nodiscard]] std::size_t block_of(double t) const { return static_cast<std::size_t>(t / length_); }

  void add_to(std::size_t k, const Sums& x, double share) {
    for (std::size_t i = 0; i < K; ++i) blocks_[k][i] += share * x[i];
  }

  void make_room(double t) {
    while (t / length_ >= static_cast<double>(most_blocks)) {
      for (std::size_t k = 0; k < most_blocks / 2; ++k)
        for (std::size_t i = 0; i < K; ++i) blocks_[k][i] = blocks_[2 * k][i] + blocks_[2 * k + 1][i];
      std::fill(blocks_.begin() + most_blocks / 2, blocks_.end(), Sums{});
      length_ *= 2;
    }
  }

  double length_;
  std::size_t complete_ = 0;
  std::array<Sums, most_blocks> blocks_{};
};

}  // namespace carom
