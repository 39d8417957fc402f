#include "carom/write/trajectory_csv.hpp"

#include <array>
#include <utility>

#include <fmt/core.h>

#include "carom/write/number_text.hpp"
#include "csv_comments.hpp"
#include "space_word.hpp"

namespace carom {

namespace {

void write_space(OutputFile& file, const TrajectoryHead& head) {
  file.line() += fmt::format("# space: {}", space_word(head.space));
  file.end_line();
  if (head.space == SpaceKind::open) return;
  for (const auto& [label, corner] : {std::pair("lower", &head.lower), std::pair("upper", &head.upper)}) {
    file.line() += fmt::format("# {}:", label);
    for (std::size_t k = 0; k < static_cast<std::size_t>(head.dimension); ++k) {
      file.line() += ' ';
      append_number(file.line(), (*corner)[k]);
    }
    file.end_line();
  }
}

}  // namespace

TrajectoryCsv::TrajectoryCsv(std::string path, const TrajectoryHead& head)
    : file_(std::move(path)), velocities_(head.velocities), radii_(head.radii) {
  write_head_comments(file_, "trajectory", head.title, head.dimension, head.epoch_length);
  write_space(file_, head);
  std::string& line = file_.line();
  line += "time,ball";
  for (const char* prefix : {"", "i"}) append_columns(line, prefix, head.dimension);
  if (velocities_) append_columns(line, "v", head.dimension);
  line += radii_ ? ",radius,mass" : ",mass";
  file_.end_line();
}

void TrajectoryCsv::write(const TrajectoryFrame& frame) {
  std::string& line = file_.line();
  const auto append = [&line](const auto& components) {
    for (const auto& x : components) {
      line += ',';
      append_number(line, x);
    }
  };
  for (const BallState& ball : frame.balls) {
    append_number(line, frame.time);
    line += ',';
    append_number(line, std::int64_t{ball.index});
    append(ball.position);
    append(ball.image);
    if (velocities_) append(ball.velocity);
    if (radii_) append(std::array{ball.radius});
    append(std::array{ball.mass});
    file_.end_line();
  }
  ++frames_;
}

void TrajectoryCsv::finish(const Ending& ending) {
  file_.line() += fmt::format("# end: {}, {} frames", ending.stopped_by.empty() ? "unknown" : ending.stopped_by, frames_);
  file_.end_line();
  file_.close();
}

}  // namespace carom
