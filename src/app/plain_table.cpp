#include "plain_table.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "write/reading.hpp"

namespace carom::app {

std::optional<std::size_t> PlainTable::find(const std::string& name) const {
  const auto at = std::find(columns.begin(), columns.end(), name);
  if (at == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(at - columns.begin());
}

PlainTable read_table(const std::string& path, const std::function<void(const std::vector<double>&)>& take) {
  PlainTable table;
  LineReader lines(path);
  std::vector<double> row;
  for (std::string line; lines.next(line);) {
    const std::string_view text = line;
    if (text.starts_with("# carom ") && table.kind.empty()) table.kind = text.substr(8);
    if (text.starts_with("# title: ")) table.title = text.substr(9);
    if (text.empty() || text.starts_with('#')) continue;
    const auto cells = cells_of(text);
    if (table.columns.empty()) {
      table.columns.assign(cells.begin(), cells.end());
      continue;
    }
    row.assign(cells.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = 0; k < cells.size(); ++k)
      std::from_chars(cells[k].data(), cells[k].data() + cells[k].size(), row[k]);
    row.resize(table.columns.size(), std::numeric_limits<double>::quiet_NaN());
    if (take) {
      take(row);
    } else {
      table.rows.push_back(row);
    }
  }
  return table;
}

}  // namespace carom::app
