#pragma once
// The files that a scene asks for.

#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "carom/observe/row_outlet.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"
#include "carom/write/events_csv.hpp"
#include "carom/write/ledger_csv.hpp"
#include "carom/write/speed_histogram_csv.hpp"
#include "carom/write/table_csv.hpp"
#include "carom/write/trajectory.hpp"

namespace carom::app {

class RunOutputs {
 public:
  /// Opens the files of [output], and those of what [observe] measures as tables, in `folder` (made if it is not there) or,
  /// if that is empty, where the program was started. Throws OutputError; InputError if a file would overwrite the scene, or
  /// if this build cannot write it.
  RunOutputs(const Scene& scene, const std::string& folder, const Simulation& simulation, const Provenance& provenance);

  [[nodiscard]] bool any() const { return !written_.empty(); }
  [[nodiscard]] EventsCsv* events() { return events_ ? &*events_ : nullptr; }
  [[nodiscard]] SpeedHistogramCsv* speeds() { return speeds_ ? &*speeds_ : nullptr; }

  /// Those of `observed_tables`, then those of `final_tables`, in their order.
  [[nodiscard]] std::list<TableCsv>& tables() { return tables_; }

  /// Those of `streamed_tables`, with the names of their columns written.
  struct Stream {
    Stream(const StreamedTable& table, const Simulation& simulation, const std::string& title)
        : name(table.name), file(table.file, simulation, title, name) {
      file.names(table.columns);
    }
    std::string name;
    TableCsv file;
  };
  [[nodiscard]] std::list<Stream>& streams() { return streams_; }

  [[nodiscard]] bool wants_frames() const { return trajectory_ || ledger_; }
  /// The balls as they are now.
  void frame(const Simulation& simulation);

  /// A write has failed: there is no use in going on.
  [[nodiscard]] bool failed() const;

  /// Ends every file; what could not be written, a line each. Empty: all is there.
  [[nodiscard]] std::string finish(const Summary& summary);

  /// The files that are whole, after `finish`.
  [[nodiscard]] const std::vector<std::string>& written() const { return written_; }

 private:
  std::optional<EventsCsv> events_;
  std::unique_ptr<Trajectory> trajectory_;
  std::optional<LedgerCsv> ledger_;
  std::optional<SpeedHistogramCsv> speeds_;
  std::list<TableCsv> tables_;
  std::list<Stream> streams_;
  std::vector<std::string> written_;
};

}  // namespace carom::app
