#pragma once
// Frames read back from a file, one at a time.

#include <memory>
#include <string>

#include "carom/write/frame.hpp"

namespace carom {

/// A trajectory or snapshot being read. Memory does not grow with the frames.
class FrameReader {
 public:
  FrameReader() = default;
  virtual ~FrameReader() = default;
  FrameReader(const FrameReader&) = delete;
  FrameReader& operator=(const FrameReader&) = delete;

  /// What the file says of all its frames. `balls` and `varying` are known to `survey` only.
  [[nodiscard]] virtual const TrajectoryHead& head() const = 0;

  /// The next frame, balls by number; false: there is none. Throws InputError with the line that is wrong.
  virtual bool next(TrajectoryFrame& frame) = 0;

  /// After the last frame: how the run ended; empty: the format, or a file that was cut off, does not say.
  [[nodiscard]] virtual std::string stopped_by() const { return {}; }

  /// Whether a whole file says how it ended.
  [[nodiscard]] virtual bool has_end_mark() const { return false; }
};

/// By the name's ending:
///   .csv   a trajectory of carom;
///   .h5    H5MD, the first group of particles;
///   .xyz   extended XYZ. Taken, under the names of OVITO, ASE and QUIP: Lattice of a box along the axes, Origin, pbc, Time;
///          species, pos, velo, radius, mass, id, map_shift. Without `dimension`, which carom writes, it is 3-D;
///   .sph   a snapshot of Smallenburg's EDMD [Smallenburg2022]: a periodic box from 0, spheres of mass 1, no velocities. Its
///          frames have no times; they are numbered.
/// Throws InputError.
[[nodiscard]] std::unique_ptr<FrameReader> read_frames(const std::string& path);

/// What is known once a whole file was read.
struct Survey {
  TrajectoryHead head;
  std::int64_t frames = 0;
  std::string stopped_by;
  bool cut_off = false;  ///< the file should say how it ended, and does not
};

/// Reads all of it.
[[nodiscard]] Survey survey(const std::string& path);

}  // namespace carom
