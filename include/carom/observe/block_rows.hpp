#pragma once
// BlockSums for rows of any length, counted in units (samples, curves) instead of time.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "carom/observe/estimate.hpp"

namespace carom {

/// Rows of `width` sums, kept apart for 32 to 64 blocks of equally many units; memory is constant. When units run out of
/// the 64th block, neighbours are joined [FlyvbjergPetersen1989, sec. IV]. Errors as in BlockSums: the jackknife over
/// complete blocks, right where units forget each other within a block.
class BlockRows {
 public:
  using Row = std::span<const double>;
  static constexpr std::size_t most_blocks = 64;

  explicit BlockRows(std::size_t width) : width_(width), sums_(most_blocks * width, 0.0) {}

  /// The sums of the block that unit 0, 1, 2, ... belongs to. Valid until the next call.
  [[nodiscard]] std::span<double> row(std::size_t unit) {
    while (unit / length_ >= most_blocks) halve();
    units_ = std::max(units_, unit + 1);
    return {sums_.data() + unit / length_ * width_, width_};
  }

  [[nodiscard]] std::size_t units() const noexcept { return units_; }

  [[nodiscard]] std::vector<double> total() const {
    std::vector<double> all(width_, 0.0);
    for (std::size_t b = 0; b < most_blocks; ++b)
      for (std::size_t i = 0; i < width_; ++i) all[i] += sums_[b * width_ + i];
    return all;
  }

  /// f(row of sums) with its standard error; NaN with less than two complete blocks.
  template <class F>
  [[nodiscard]] Estimate estimate(std::string name, F&& f) const {
    return estimates(std::vector<std::string>{std::move(name)}, [&](Row row) { return std::array{f(row)}; }).front();
  }

  /// The same for several functions of one row: f(row)[k] is called names[k].
  template <class F>
  [[nodiscard]] Estimates estimates(const std::vector<std::string>& names, F&& f) const {
    const std::vector<double> all = total();
    const auto values = f(Row(all));
    Estimates list;
    for (std::size_t k = 0; k < names.size(); ++k) list.push_back({names[k], values[k]});
    const std::size_t complete = units_ / length_;
    if (complete < 2) return list;
    const double n = static_cast<double>(complete);
    std::vector<double> rest(width_), mean(names.size(), 0.0), squares(names.size(), 0.0);
    for (std::size_t b = 0; b < complete; ++b) {
      for (std::size_t i = 0; i < width_; ++i) rest[i] = all[i] - sums_[b * width_ + i];
      const auto without = f(Row(rest));
      for (std::size_t k = 0; k < names.size(); ++k) {  // Welford's update: no cancellation
        const double step = without[k] - mean[k];
        mean[k] += step / static_cast<double>(b + 1);
        squares[k] += step * (without[k] - mean[k]);
      }
    }
    for (std::size_t k = 0; k < names.size(); ++k) list[k].error = std::sqrt(squares[k] * (n - 1) / n);
    return list;
  }

 private:
  void halve() {
    for (std::size_t b = 0; b < most_blocks / 2; ++b)
      for (std::size_t i = 0; i < width_; ++i)
        sums_[b * width_ + i] = sums_[2 * b * width_ + i] + sums_[(2 * b + 1) * width_ + i];
    std::fill(sums_.begin() + static_cast<std::ptrdiff_t>(most_blocks / 2 * width_), sums_.end(), 0.0);
    length_ *= 2;
  }

  std::size_t width_, length_ = 1, units_ = 0;
  std::vector<double> sums_;
};

}  // namespace carom
