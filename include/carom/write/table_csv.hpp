#pragma once
// A table of what was measured, as a file.

#include <span>
#include <string>
#include <vector>

#include "carom/observe/table.hpp"
#include "carom/sim/simulation.hpp"
#include "carom/write/output_file.hpp"

namespace carom {

/// A line with the names of the columns, then the rows; what could not be measured is empty. Comments as in EventsCsv.
class TableCsv {
 public:
  /// `name` is that of the quantity. Throws OutputError.
  TableCsv(std::string path, const Simulation& simulation, const std::string& title, const std::string& name);

  void write(const Table& table);

  /// The same, piece by piece.
  void names(const std::vector<std::string>& columns);
  void row(std::span<const double> row);

  /// A write has failed: there is no use in going on.
  [[nodiscard]] bool failed() const { return file_.failed(); }

  /// Ends the table. Throws OutputError if anything of it could not be written.
  void finish(Stop stopped_by);

 private:
  OutputFile file_;
};

}  // namespace carom
