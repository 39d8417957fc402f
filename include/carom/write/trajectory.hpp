#pragma once
// Frames on their way into a file, of whatever format.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "carom/sim/summary.hpp"
#include "carom/write/frame.hpp"

namespace carom {

/// Where a trajectory comes from.
struct Provenance {
  std::string scene;                  ///< text of the scene file
  std::vector<std::string> settings;  ///< KEY=VALUE that were set over it
  std::string converted_from;         ///< file; empty: it comes from a run
};

/// How it ends.
struct Ending {
  std::string stopped_by;         ///< a word of Stop; empty: not known
  std::optional<Summary> ledger;  ///< none: not known
};

/// A trajectory being written. Memory does not grow with the frames. Until `finish` the file is PATH.part, and remains so if
/// it could not be written in full.
class Trajectory {
 public:
  Trajectory() = default;
  virtual ~Trajectory() = default;
  Trajectory(const Trajectory&) = delete;
  Trajectory& operator=(const Trajectory&) = delete;

  /// Whether frames are to come with their books, as far as they are known.
  [[nodiscard]] virtual Books books() const { return Books::left_out; }

  virtual void write(const TrajectoryFrame& frame) = 0;

  /// A write has failed: what comes after is lost, and `finish` will say why.
  [[nodiscard]] virtual bool failed() const noexcept = 0;

  /// Ends the file. Throws OutputError if anything of it could not be written.
  virtual void finish(const Ending& ending) = 0;
};

enum class TrajectoryFormat : std::uint8_t { csv, extended_xyz, h5md };

/// By the name's ending: .csv, .xyz, .h5.
[[nodiscard]] std::optional<TrajectoryFormat> trajectory_format(const std::string& path);

/// Whether this build of carom writes and reads the format. H5MD needs HDF5.
[[nodiscard]] bool is_built(TrajectoryFormat format);

/// Throws InputError, naming what is missing, if a file of this name cannot be written by this build.
void require_built(const std::string& path);

/// Begins the file that the name's ending asks for. Throws OutputError; InputError as `require_built` does.
[[nodiscard]] std::unique_ptr<Trajectory> begin_trajectory(const std::string& path, const TrajectoryHead& head,
                                                           const Provenance& provenance);

}  // namespace carom
