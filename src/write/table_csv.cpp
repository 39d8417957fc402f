#include "carom/write/table_csv.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "carom/write/number_text.hpp"
#include "csv_comments.hpp"

namespace carom {

TableCsv::TableCsv(std::string path, const Simulation& simulation, const std::string& title, const std::string& name)
    : file_(std::move(path)) {
  std::string what = name;
  std::replace(what.begin(), what.end(), '_', ' ');
  write_head_comments(file_, what, simulation, title);
}

void TableCsv::write(const Table& table) {
  names(table.columns);
  for (const std::vector<double>& numbers : table.rows) row(numbers);
}

void TableCsv::names(const std::vector<std::string>& columns) {
  std::string& line = file_.line();
  for (std::size_t k = 0; k < columns.size(); ++k) line += (k > 0 ? "," : "") + columns[k];
  file_.end_line();
}

void TableCsv::row(std::span<const double> row) {
  std::string& line = file_.line();
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k > 0) line += ',';
    if (std::isfinite(row[k])) append_number(line, row[k]);
  }
  file_.end_line();
}

void TableCsv::finish(Stop stopped_by) {
  file_.line() += fmt::format("# end: {}", word(stopped_by));
  file_.end_line();
  file_.close();
}

}  // namespace carom
