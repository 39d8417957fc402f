#pragma once
// How many balls have not left through an opening yet, and how fast they leave.

#include "carom/observe/estimate.hpp"
#include "carom/observe/table.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// The simulation itself remembers who left, when and where, so nothing is kept beside it and a checkpoint has it all.
///
/// The escape rate is the most likely gamma of N(t) ~ exp(-gamma t) between `from` and `to`, from n departures at t_k between
/// them and the N balls that are left at `to`:
///   gamma = n / (sum (t_k - from) + N (to - from)),   standard error gamma / sqrt n   [Lawless2003, sec. 4.1].
class Survival {
 public:
  /// Throws InputError if nothing can leave.
  Survival(const Scene& scene, const Simulation& simulation);

  [[nodiscard]] bool any() const noexcept { return asked_.has_value(); }

  /// survival.escape_rate [1/time], survival.departures between `from` and `to`; NaN if none left then.
  [[nodiscard]] Estimates estimates(const Simulation& simulation) const;

  /// "survival": time, number of balls left, its share of all and the standard error of that; "departures": ball, time, place,
  /// velocity, wall and its feature.
  [[nodiscard]] std::vector<Table> tables(const Simulation& simulation) const;

 private:
  [[nodiscard]] double until(const Simulation& simulation) const;

  std::optional<SurvivalSpec> asked_;
  double start_ = 0.0;
  int dimension_ = 2;
};

/// The name and the file of each of Survival::tables; none if it is not asked for.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> survival_files(const ObserveSpec& observe);

}  // namespace carom
