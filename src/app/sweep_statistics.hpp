#pragma once
// Means and standard errors over the runs of a sweep, for each combination of what was listed.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sweep_plan.hpp"

namespace carom::app {

/// Mean and standard error over runs of one number of their rows, from sums in the order of runs.
class RunMean {
 public:
  void add(double x) noexcept;
  [[nodiscard]] std::int64_t count() const noexcept { return count_; }
  [[nodiscard]] double mean() const noexcept { return mean_; }
  [[nodiscard]] double error() const noexcept;  ///< NaN for fewer than two runs

 private:
  std::int64_t count_ = 0;
  double mean_ = 0, squares_ = 0;  // of the deviations [Welford1962]
};

struct SweepGroup {
  std::int64_t done = 0, stopped = 0, refused = 0;
  std::vector<RunMean> values;  ///< as SweepStatistics::names
  [[nodiscard]] std::int64_t runs() const noexcept { return done + stopped + refused; }
};

class SweepStatistics {
 public:
  /// Up to so many combinations are kept apart; of more, only all runs together.
  static constexpr std::int64_t most_groups = 10'000;

  explicit SweepStatistics(const SweepPlan& plan);

  void add(const std::string& row);

  /// All numbers of the rows that were done, except for the run, what was set and standard errors: "time",
  /// "events.ball_ball", "observed.pressure.Z", ...
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  [[nodiscard]] const std::vector<SweepGroup>& groups() const noexcept { return groups_; }
  [[nodiscard]] SweepGroup total() const;
  [[nodiscard]] bool grouped() const noexcept { return groups_.size() > 1; }

  /// The object of `carom sweep --json` but for what the clock says.
  [[nodiscard]] Json object() const;
  /// For people.
  [[nodiscard]] std::string table() const;

 private:
  [[nodiscard]] std::string long_table() const;
  [[nodiscard]] std::string wide_table() const;
  [[nodiscard]] std::vector<std::size_t> shown() const;

  const SweepPlan& plan_;
  std::vector<std::string> names_;
  std::map<std::string, std::size_t> number_of_;
  std::vector<SweepGroup> groups_;
};

}  // namespace carom::app
