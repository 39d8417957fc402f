#pragma once
// The books of a run as a table: what happened to energy and momentum, frame by frame.

#include <cstdint>
#include <string>

#include "carom/write/frame.hpp"
#include "carom/write/output_file.hpp"

namespace carom {

/// Columns: time, collisions, energy (kinetic + potential), dissipated, injected, imbalance (energy + dissipated - initial -
/// injected: an error of rounding), imbalance_ulp (in units in the last place of the initial energy), momentum (px, ..).
/// Comments as in EventsCsv.
class LedgerCsv {
 public:
  /// Throws OutputError.
  LedgerCsv(std::string path, const TrajectoryHead& head);

  /// A frame with its books.
  void write(const TrajectoryFrame& frame);

  [[nodiscard]] bool failed() const noexcept { return file_.failed(); }

  /// Ends the table. Throws OutputError if anything of it could not be written.
  void finish(Stop stopped_by);

 private:
  OutputFile file_;
  std::int64_t frames_ = 0;
};

}  // namespace carom
