#pragma once
// The rows of a sweep on the disk: appended as they come, whole lines only, and found again by who goes on.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "sweep_plan.hpp"

namespace carom {
class PartFile;
}

namespace carom::app {

/// runs.jsonl in a folder, a line a run, runs.jsonl.part until all are there; beside it sweep.json, what the sweep is, and
/// at the end runs.csv, the same rows as a table.
class SweepRows {
 public:
  /// Begins a sweep, or goes on with the one in the folder (or begins it, if there is none). Throws InputError if the
  /// folder holds an unfinished sweep and is not to be resumed, or if the one in it is another; OutputError.
  SweepRows(const std::string& folder, const SweepPlan& plan, bool resume);
  ~SweepRows();
  SweepRows(const SweepRows&) = delete;
  SweepRows& operator=(const SweepRows&) = delete;

  /// Rows that were there: those of the runs from 0 on.
  [[nodiscard]] std::int64_t found() const noexcept { return found_; }
  /// Calls `take` with each row that was there.
  void read(const std::function<void(const std::string&)>& take) const;

  /// Hands the line to the system: what a crash of carom leaves is whole lines. Throws OutputError.
  void append(const std::string& line);

  /// All rows are there. Writes the table. Throws OutputError.
  void finish();

 private:
  [[nodiscard]] std::int64_t keep_whole_lines();

  std::string rows_, table_;
  std::unique_ptr<const PartFile> part_;
  std::int64_t found_ = 0;
  int file_ = -1;
};

/// Rows of JSON as a table: `lines` calls its argument with each row, and is called twice. A column for each number or text;
/// what a row does not have is empty; the standard error of observed.NAME is observed.NAME.error.
void write_rows_csv(const std::function<void(const std::function<void(const std::string&)>&)>& lines,
                    const std::function<void(const std::string&)>& write);

/// "set.wall.0.radius", "observed.pressure.Z", ...: the path and the value of each leaf of a row, in order.
void for_each_leaf(const Json& row, const std::function<void(const std::string& name, const Json& value)>& leaf);

}  // namespace carom::app
