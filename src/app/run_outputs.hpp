#pragma once
// The files that a scene asks for.

#include <list>
#include <optional>
#include <string>

#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"
#include "carom/write/events_csv.hpp"
#include "carom/write/speed_histogram_csv.hpp"
#include "carom/write/table_csv.hpp"
#include "carom/write/trajectory_csv.hpp"

namespace carom::app {

class RunOutputs {
 public:
  /// Opens the files of [output], and those of what [observe] measures as tables, in `folder` (made if it is not there) or,
  /// if that is empty, where the program was started. Throws OutputError; InputError if a file would overwrite the scene.
  RunOutputs(const Scene& scene, const std::string& folder, const Simulation& simulation);

  [[nodiscard]] bool any() const { return events_ || trajectory_ || speeds_ || !tables_.empty(); }
  [[nodiscard]] EventsCsv* events() { return events_ ? &*events_ : nullptr; }
  [[nodiscard]] TrajectoryCsv* trajectory() { return trajectory_ ? &*trajectory_ : nullptr; }
  [[nodiscard]] SpeedHistogramCsv* speeds() { return speeds_ ? &*speeds_ : nullptr; }

  /// Those of `observed_tables`, in their order.
  [[nodiscard]] std::list<TableCsv>& tables() { return tables_; }

  /// Ends every file; what could not be written, a line each. Empty: all is there.
  [[nodiscard]] std::string finish(Stop stopped_by);

 private:
  std::optional<EventsCsv> events_;
  std::optional<TrajectoryCsv> trajectory_;
  std::optional<SpeedHistogramCsv> speeds_;
  std::list<TableCsv> tables_;
};

}  // namespace carom::app
