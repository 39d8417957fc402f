#include "carom/write/speed_histogram_csv.hpp"

#include <utility>

#include <fmt/core.h>

#include "carom/write/number_text.hpp"
#include "csv_comments.hpp"

namespace carom {

SpeedHistogramCsv::SpeedHistogramCsv(std::string path, const Simulation& simulation, const std::string& title)
    : file_(std::move(path)) {
  write_head_comments(file_, "speed histogram", simulation, title);
  file_.line() += "from,to,share,density,maxwell";
  file_.end_line();
}

void SpeedHistogramCsv::write(const std::vector<SpeedBin>& table) {
  std::string& line = file_.line();
  for (const SpeedBin& bin : table) {
    const double width = bin.to - bin.from;
    append_number(line, bin.from);
    for (const double x : {bin.to, bin.share, bin.share / width, bin.maxwell / width}) {
      line += ',';
      append_number(line, x);
    }
    file_.end_line();
  }
}

void SpeedHistogramCsv::finish(Stop stopped_by) {
  file_.line() += fmt::format("# end: {}", word(stopped_by));
  file_.end_line();
  file_.close();
}

}  // namespace carom
