#include "carom/write/frame_reader.hpp"

#include <algorithm>
#include <optional>

#include "carom/write/trajectory.hpp"
#include "reading.hpp"

namespace carom {

namespace {

bool same_bodies(const std::vector<BallState>& a, const std::vector<BallState>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const BallState& x, const BallState& y) {
    return x.index == y.index && x.mass.value == y.mass.value && x.radius.value == y.radius.value;
  });
}

}  // namespace

std::unique_ptr<FrameReader> read_frames(const std::string& path) {
  if (path.ends_with(".sph")) return read_sph_frames(path);
  const std::optional<TrajectoryFormat> format = trajectory_format(path);
  if (!format)
    throw InputError(Problem{"", 0, "\"" + path + "\" is no name for a trajectory", "its ending says the format",
                             "Give a .h5 (H5MD), .xyz (extended XYZ), .csv or .sph file"});
  require_built(path);
  switch (*format) {
    case TrajectoryFormat::csv:
      return read_csv_frames(path);
    case TrajectoryFormat::extended_xyz:
      return read_xyz_frames(path);
    case TrajectoryFormat::h5md:
#ifdef CAROM_HDF5
      return read_h5md_frames(path);
#else
      break;
#endif
  }
  return nullptr;
}

Survey survey(const std::string& path) {
  const std::unique_ptr<FrameReader> reader = read_frames(path);
  Survey s;
  std::uint32_t balls = 0;
  bool varying = false;
  std::vector<BallState> first;
  for (TrajectoryFrame frame; reader->next(frame); ++s.frames) {
    if (s.frames == 0) first = frame.balls;
    varying = varying || !same_bodies(first, frame.balls);
    for (const BallState& ball : frame.balls) balls = std::max(balls, ball.index + 1);
  }
  s.head = reader->head();
  s.head.balls = balls;
  s.head.varying = varying;
  s.stopped_by = reader->stopped_by();
  s.cut_off = reader->has_end_mark() && s.stopped_by.empty();
  return s;
}

}  // namespace carom
