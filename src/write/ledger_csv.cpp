#include "carom/write/ledger_csv.hpp"

#include <utility>

#include <fmt/core.h>

#include "carom/write/number_text.hpp"
#include "csv_comments.hpp"

namespace carom {

LedgerCsv::LedgerCsv(std::string path, const TrajectoryHead& head) : file_(std::move(path)) {
  write_head_comments(file_, "ledger", head.title, head.dimension, head.epoch_length);
  file_.line() += "time,collisions,energy,dissipated,injected,imbalance,imbalance_ulp";
  append_columns(file_.line(), "p", head.dimension);
  file_.end_line();
}

void LedgerCsv::write(const TrajectoryFrame& frame) {
  const FrameBooks& b = frame.books.value();
  std::string& line = file_.line();
  append_number(line, frame.time);
  line += ',';
  append_number(line, b.collisions);
  for (const double x : {b.energy, b.dissipated, b.injected, b.imbalance, b.imbalance_ulp}) {
    line += ',';
    append_number(line, x);
  }
  for (const Number& p : b.momentum) {
    line += ',';
    append_number(line, p);
  }
  file_.end_line();
  ++frames_;
}

void LedgerCsv::finish(Stop stopped_by) {
  file_.line() += fmt::format("# end: {}, {} frames", word(stopped_by), frames_);
  file_.end_line();
  file_.close();
}

}  // namespace carom
