#pragma once
// The files of a comparison: a row a stepper, and position errors in time.

#include <string>

#include "carom/write/comparison_report.hpp"
#include "carom/write/output_file.hpp"

namespace carom {

/// rows.csv: what `carom compare --json` has in a row, a line a stepper as it is finished. Empty: none, not defined.
class ComparisonCsv {
 public:
  /// Throws OutputError.
  explicit ComparisonCsv(std::string path);

  void write(const ComparisonRow& row);
  /// Throws OutputError if anything of it could not be written.
  void finish() { file_.close(); }

 private:
  OutputFile file_;
};

/// position_error.csv: method, engine, dt, time, error: the largest distance of a ball from its place in the exact run.
class PositionErrorCsv {
 public:
  /// Throws OutputError.
  explicit PositionErrorCsv(std::string path);

  void write(const ComparisonRow& row, double time, double error);
  /// Throws OutputError if anything of it could not be written.
  void finish() { file_.close(); }

 private:
  OutputFile file_;
};

}  // namespace carom
