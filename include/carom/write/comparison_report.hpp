#pragma once
// What a comparison of steppers with the exact run ends with, as a table for people and as JSON.

#include <string>
#include <vector>

#include "carom/observe/comparison.hpp"
#include "carom/write/run_report.hpp"
#include "carom/write/summary_table.hpp"

namespace carom {

/// One stepper: a fixed-step method or a game engine, as its name is written; the other is empty.
struct ComparisonRow {
  std::string method, engine;
  double dt = 0.0;  ///< [time]
  Comparison result;

  [[nodiscard]] const std::string& name() const noexcept { return engine.empty() ? method : engine; }
};

struct ComparisonReport {
  RunReport exact;
  std::vector<ComparisonRow> rows;
  bool interrupted = false;  ///< rows are missing
};

/// The object of `carom compare --json`, ended by a newline. What is not finite or not defined is null.
[[nodiscard]] std::string comparison_json(const ComparisonReport& report);

/// Units are the scene's. Lines that vary from run to run, of wall time, begin with "took".
[[nodiscard]] std::string comparison_table(const ComparisonReport& report, Colour colour = Colour::off);

}  // namespace carom
