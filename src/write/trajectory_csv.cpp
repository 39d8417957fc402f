#include "carom/write/trajectory_csv.hpp"

#include <utility>

#include <fmt/core.h>

#include "carom/write/number_text.hpp"
#include "csv_comments.hpp"

namespace carom {

TrajectoryCsv::TrajectoryCsv(std::string path, const Simulation& simulation, const std::string& title)
    : file_(std::move(path)) {
  write_head_comments(file_, "trajectory", simulation, title);
  std::string& line = file_.line();
  line += "time,ball";
  for (const char* prefix : {"", "i", "v"}) append_columns(line, prefix, simulation.dimension());
  file_.end_line();
}

void TrajectoryCsv::write_frame(const Simulation& simulation) {
  const Number time = simulation.time();
  std::string& line = file_.line();
  const auto append = [&line](const auto& components) {
    for (const auto& x : components) {
      line += ',';
      append_number(line, x);
    }
  };
  for (const BallState& ball : simulation.balls()) {
    append_number(line, time);
    line += ',';
    append_number(line, std::int64_t{ball.index});
    append(ball.position);
    append(ball.image);
    append(ball.velocity);
    file_.end_line();
  }
  ++frames_;
}

void TrajectoryCsv::finish(Stop stopped_by) {
  file_.line() += fmt::format("# end: {}, {} frames", word(stopped_by), frames_);
  file_.end_line();
  file_.close();
}

}  // namespace carom
