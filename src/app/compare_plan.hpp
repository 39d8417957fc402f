#pragma once
// What a comparison is to do: every method and engine at every step, read from the words of the command line.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "carom/core/error.hpp"
#include "carom/core/number.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/stepper.hpp"

namespace carom::app {

/// One stepper of a comparison.
struct PlannedRow {
  std::string method, engine;                                  ///< as their names are written; one of them is empty
  Number dt;                                                   ///< [time]
  double delay = 0.0;                                          ///< [time] from the begin of a contact to its report
  std::function<std::unique_ptr<Stepper>(const Scene&)> make;  ///< throws InputError
};

/// `dt`, `methods`, `engines`: lists with commas. Neither methods nor engines: carom's own methods. Every problem found is
/// added; the rows are then of no use.
[[nodiscard]] std::vector<PlannedRow> plan_comparison(const std::string& dt, const std::string& methods,
                                                      const std::string& engines, std::vector<Problem>& problems);

/// What keeps the steppers, or the comparison, from this scene.
[[nodiscard]] std::vector<Problem> judge_comparison(const Scene& scene, const std::vector<PlannedRow>& rows);

}  // namespace carom::app
