#pragma once
// Exponents over spans of time: their mean, their spread and how they are distributed.

#include <cstdint>
#include <vector>

#include "carom/observe/estimate.hpp"
#include "carom/observe/table.hpp"

namespace carom {

/// lyapunov.finite_time.mean[k] and .spread[k] [1/time]: over equal spans of time, mean and standard deviation of the k-th
/// exponent of each; errors as for independent spans. Its table: `exponent` (the middle of a bin), then for each k the
/// density. There are 256 bins about 0, which become twice as wide whenever a value lies beyond them.
class FiniteTime {
 public:
  static constexpr std::size_t most_columns = 16;  ///< the table holds the first so many

  FiniteTime(double length, std::size_t exponents);

  [[nodiscard]] double length() const noexcept { return length_; }
  [[nodiscard]] std::int64_t spans() const noexcept { return spans_; }

  /// ln l_k within the span under way.
  void add(std::size_t k, double log) { sums_[k] += log; }
  /// The span is over.
  void next();

  [[nodiscard]] Estimates estimates() const;
  [[nodiscard]] Table table() const;

 private:
  static constexpr std::size_t bins = 256;

  void make_room(double value);

  double length_, width_ = 0.0;  // of a bin; 0: nothing was counted yet
  std::int64_t spans_ = 0;
  std::vector<double> sums_, means_, squares_;   // by exponent
  std::vector<std::vector<double>> counts_;      // by exponent, by bin
};

}  // namespace carom
