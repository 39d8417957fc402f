#pragma once
// How much time balls spent at which speed, as a table.

#include <string>
#include <vector>

#include "carom/observe/speed_histogram.hpp"
#include "carom/write/output_file.hpp"

namespace carom {

/// Columns: from, to (speeds), share (of the time of all balls that move freely), density (share over the width), maxwell
/// (the density of a Maxwell distribution of the same mean kinetic energy and masses). Comments as in EventsCsv.
class SpeedHistogramCsv {
 public:
  /// Throws OutputError.
  SpeedHistogramCsv(std::string path, const Simulation& simulation, const std::string& title);

  void write(const std::vector<SpeedBin>& table);

  /// Ends the table. Throws OutputError if anything of it could not be written.
  void finish(Stop stopped_by);

 private:
  OutputFile file_;
};

}  // namespace carom
