#pragma once
// How many balls have not left through an opening yet, and how fast they leave.

#include "carom/observe/estimate.hpp"
#include "carom/observe/table.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// The simulation itself remembers who left, when and where, so nothing is kept beside it and a checkpoint has it all.
///
/// The escape rate is the slope of the straight line that is nearest to -ln N(t) over `from` .. `to`, each moment alike (if all
/// leave: to the last departure):
///   gamma = -12 / T^3 integral (t - m) ln N(t) dt,   T = to - from, m = (from + to) / 2,
/// an exact sum, as N is constant between departures. Where flights are nearly equally long, N falls in steps, which this averages
/// over some of; the most likely rate of an exponential, n over all time waited, depends on the step that `from` is in (by
/// 10 % either way at the three-disk pinball). The standard error is the jackknife's over 20 groups of balls [Efron1982].
class Survival {
 public:
  /// Throws InputError if nothing can leave.
  Survival(const Scene& scene, const Simulation& simulation);

  [[nodiscard]] bool any() const noexcept { return asked_.has_value(); }

  /// survival.escape_rate [1/time]; survival.departures, their number between `from` and `to`. NaN: none left then.
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
