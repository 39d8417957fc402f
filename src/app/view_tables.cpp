#include "view_tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace carom::app {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

/// NaN for an empty cell; nothing if it is a word.
bool read_number(const std::string& cell, double& value) {
  if (cell.empty()) {
    value = std::nan("");
    return true;
  }
  char* end = nullptr;
  value = std::strtod(cell.c_str(), &end);
  return *end == '\0';
}

/// Null if the file is no table of numbers, or a longer one than a page shows.
Json read_table(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> labels;
  std::vector<std::vector<double>> columns;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> cells = cells_of(line);
    if (labels.empty()) {
      labels = cells;
      columns.resize(labels.size());
      continue;
    }
    if (cells.size() != labels.size() || columns.front().size() >= longest_table) return nullptr;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      double value = 0;
      if (!read_number(cells[k], value)) return nullptr;
      columns[k].push_back(value);
    }
  }
  if (labels.size() < 2 || columns.front().size() < 2) return nullptr;
  Json table{{"name", file.stem().string()}, {"columns", Json::array()}};
  for (std::size_t k = 0; k < labels.size(); ++k)
    table["columns"].push_back({{"label", labels[k]}, {"values", columns[k]}});
  return table;
}

}  // namespace

Json table_of(const std::vector<SpeedBin>& speeds) {
  std::vector<double> speed, density, maxwell;
  for (const SpeedBin& bin : speeds) {
    const double width = bin.to - bin.from;
    speed.push_back(bin.from + width / 2);
    density.push_back(bin.share / width);
    maxwell.push_back(bin.maxwell / width);
  }
  return {{"name", "observe.speed_histogram"},
          {"columns",
           {{{"label", "speed"}, {"values", speed}},
            {{"label", "density"}, {"values", density}},
            {{"label", "Maxwell"}, {"values", maxwell}}}}};
}

Json table_of(const Table& table) {
  Json j{{"name", table.name}, {"columns", Json::array()}};
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    std::vector<double> values;
    for (const std::vector<double>& row : table.rows) values.push_back(row[k]);
    j["columns"].push_back({{"label", table.columns[k]}, {"values", values}});
  }
  return j;
}

Json tables_in(const std::string& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".csv" && entry.path().stem() != "trajectory") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Json tables = Json::array();
  for (const fs::path& file : files)
    if (Json table = read_table(file); !table.is_null()) tables.push_back(std::move(table));
  return tables;
}

}  // namespace carom::app
