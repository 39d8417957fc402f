#include "carom/write/trajectory.hpp"

#include <utility>

#include <fmt/core.h>

#include "carom/core/error.hpp"
#include "carom/write/extended_xyz.hpp"
#include "carom/write/h5md.hpp"
#include "carom/write/trajectory_csv.hpp"

namespace carom {

std::optional<TrajectoryFormat> trajectory_format(const std::string& path) {
  if (path.ends_with(".csv")) return TrajectoryFormat::csv;
  if (path.ends_with(".xyz")) return TrajectoryFormat::extended_xyz;
  if (path.ends_with(".h5")) return TrajectoryFormat::h5md;
  return std::nullopt;
}

bool is_built(TrajectoryFormat format) {
#ifdef CAROM_HDF5
  static_cast<void>(format);
  return true;
#else
  return format != TrajectoryFormat::h5md;
#endif
}

void require_built(const std::string& path) {
  const std::optional<TrajectoryFormat> format = trajectory_format(path);
  if (!format)
    throw InputError(Problem{"", 0, fmt::format("\"{}\" is no name for a trajectory", path), "its ending says the format",
                             "End it in .h5 (H5MD), .xyz (extended XYZ) or .csv"});
  if (!is_built(*format))
    throw InputError(Problem{"", 0, fmt::format("\"{}\" needs HDF5", path), "this carom was built without it",
                             "Name a .xyz or .csv file, or build carom where libhdf5-dev is installed"});
}

std::unique_ptr<Trajectory> begin_trajectory(const std::string& path, const TrajectoryHead& head,
                                             [[maybe_unused]] const Provenance& provenance) {
  require_built(path);
  switch (*trajectory_format(path)) {
    case TrajectoryFormat::csv:
      return std::make_unique<TrajectoryCsv>(path, head);
    case TrajectoryFormat::extended_xyz:
      return std::make_unique<ExtendedXyz>(path, head);
    case TrajectoryFormat::h5md:
#ifdef CAROM_HDF5
      return std::make_unique<H5md>(path, head, provenance);
#else
      break;
#endif
  }
  return nullptr;
}

}  // namespace carom
