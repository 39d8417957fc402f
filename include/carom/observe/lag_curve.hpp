#pragma once
// A mean over balls and origins for each lag, with errors from blocks of origins.

#include <string>

#include "carom/observe/block_rows.hpp"
#include "carom/observe/table.hpp"

namespace carom {

class LagCurve {
 public:
  /// Lags 0, step, ..., lags step [time].
  LagCurve(std::size_t lags, double step) : lags_(lags), step_(step), sums_(2 * (lags + 1)) {}

  /// `sum` over `count` balls, seen from origin number 0, 1, ....
  void add(std::size_t origin, std::size_t lag, double sum, double count) {
    const std::span<double> row = sums_.row(origin);
    row[lag] += sum;
    row[lags_ + 1 + lag] += count;
  }

  [[nodiscard]] std::size_t lags() const noexcept { return lags_; }
  [[nodiscard]] double step() const noexcept { return step_; }

  /// f(curve) with its error; curve[lag] is the mean.
  template <class F>
  [[nodiscard]] Estimate estimate(std::string name, F&& f) const {
    return sums_.estimate(std::move(name), [&](BlockRows::Row row) { return f(means(row)); });
  }

  /// Columns: lag, `column`, error.
  [[nodiscard]] Table table(const std::string& name, const std::string& column) const {
    const Estimates curve =
        sums_.estimates(std::vector<std::string>(lags_ + 1), [this](BlockRows::Row row) { return means(row); });
    Table table{name, {"lag", column, "error"}, {}};
    for (std::size_t lag = 0; lag <= lags_; ++lag)
      table.rows.push_back({static_cast<double>(lag) * step_, curve[lag].value, curve[lag].error});
    return table;
  }

 private:
  [[nodiscard]] std::vector<double> means(BlockRows::Row row) const {
    std::vector<double> mean(lags_ + 1);
    for (std::size_t lag = 0; lag <= lags_; ++lag) mean[lag] = row[lag] / row[lags_ + 1 + lag];
    return mean;
  }

  std::size_t lags_;
  double step_;
  BlockRows sums_;
};

}  // namespace carom
