#pragma once
// How many balls have not left through an opening yet, and how fast they leave.

#include "carom/observe/estimate.hpp"
#include "carom/observe/table.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// The simulation itself remembers who left, when and where, so nothing is kept beside it and a checkpoint has it all.
///
/// The escape rate is a mean of the rate of leaving over `from` .. `to` (if all leave: to the last departure), with weights that
/// go to 0 at both ends [RamlauHansen1983]:
///   gamma = sum w(u) / N / integral w dt,   w(u) = (1 - u^2)^4,   u = (t - (from + to) / 2) / ((to - from) / 2),
/// summed over departures, N those inside before. A sum over 1 / N is without bias however few are left [Aalen1978]. Where
/// flights are nearly equally long, N falls in steps, and those cancel as (span / step)^-5; of a straight line through ln N as
/// the square, w being 1 - u^2; the most likely rate of an exponential depends on the step that `from` is in. The standard error is
/// that of independent balls, sqrt(sum (w / N)^2) / integral w dt.
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
