#include "carom/observe/finite_time.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace carom {

FiniteTime::FiniteTime(double length, std::size_t exponents)
    : length_(length),
      sums_(exponents, 0.0),
      means_(exponents, 0.0),
      squares_(exponents, 0.0),
      counts_(std::min(exponents, most_columns), std::vector<double>(bins, 0.0)) {}

void FiniteTime::make_room(double value) {
  if (width_ == 0) width_ = value == 0 ? 0x1p-40 / length_ : std::abs(value) / (bins / 8);
  while (std::abs(value) >= width_ * (bins / 2)) {
    for (std::vector<double>& column : counts_) {
      std::vector<double> wider(bins, 0.0);
      for (std::size_t b = 0; b < bins; ++b) wider[bins / 4 + b / 2] += column[b];
      column = std::move(wider);
    }
    width_ *= 2;
  }
}

void FiniteTime::next() {
  ++spans_;
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    const double value = sums_[k] / length_, step = value - means_[k];
    sums_[k] = 0;
    means_[k] += step / static_cast<double>(spans_);
    squares_[k] += step * (value - means_[k]);
    if (k >= counts_.size() || !std::isfinite(value)) continue;
    make_room(value);
    counts_[k][static_cast<std::size_t>(std::floor(value / width_) + bins / 2)] += 1;
  }
}

Estimates FiniteTime::estimates() const {
  Estimates list;
  const double n = static_cast<double>(spans_);
  for (std::size_t k = 0; k < means_.size(); ++k) {
    Estimate mean{"lyapunov.finite_time.mean[" + std::to_string(k) + "]"}, spread{"lyapunov.finite_time.spread[" + std::to_string(k) + "]"};
    if (spans_ > 0) mean.value = means_[k];
    if (spans_ > 1) {
      spread.value = std::sqrt(squares_[k] / (n - 1));
      mean.error = spread.value / std::sqrt(n);
      spread.error = spread.value / std::sqrt(2 * (n - 1));
    }
    list.push_back(std::move(mean));
    list.push_back(std::move(spread));
  }
  return list;
}

Table FiniteTime::table() const {
  Table table{"lyapunov_finite_time", {"exponent"}, {}};
  for (std::size_t k = 0; k < counts_.size(); ++k) table.columns.push_back("density_" + std::to_string(k));
  const auto used = [&](std::size_t b) {
    return std::any_of(counts_.begin(), counts_.end(), [b](const auto& column) { return column[b] > 0; });
  };
  std::size_t first = 0, last = bins;
  while (first < last && !used(first)) ++first;
  while (last > first && !used(last - 1)) --last;
  const double each = 1 / (static_cast<double>(spans_) * width_);
  for (std::size_t b = first; b < last; ++b) {
    std::vector<double> row{(static_cast<double>(b) + 0.5 - bins / 2) * width_};
    for (const std::vector<double>& column : counts_) row.push_back(column[b] * each);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace carom
