#include "sweep_rows.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "carom/core/error.hpp"
#include "carom/write/number_text.hpp"
#include "carom/write/output_file.hpp"
#include "output_folder.hpp"
#include "write/part_file.hpp"

namespace carom::app {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// What differs between two prints; empty: nothing.
std::string difference(const Json& before, const Json& now) {
  for (const auto& [key, value] : now.items())
    if (!before.contains(key) || before[key] != value) return key;
  return "";
}

void check_print(const fs::path& file, const Json& now) {
  const Json before = Json::parse(text_of(file), nullptr, false);
  const std::string key = before.is_object() ? difference(before, now) : "all of it";
  if (key.empty()) return;
  const std::string what = key == "text" ? "the text of the scene" : key == "carom" ? "the version of carom" : key;
  throw InputError(Problem{"", 0, "the sweep in \"" + file.parent_path().string() + "\" is another", what + " differs",
                           "Name another folder with --out, or leave out --resume"});
}

void write_print(const fs::path& file, const Json& print) {
  OutputFile out(file.string());
  out.line() += json_text(print);
  out.close();
}

void walk(const std::string& path, const Json& value, const std::function<void(const std::string&, const Json&)>& leaf) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) {
      const bool is_estimate = key == "value" && value.size() == 2 && value.contains("error");
      walk(is_estimate ? path : path.empty() ? key : path + "." + key, inner, leaf);
    }
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) walk(path + "." + std::to_string(i), value[i], leaf);
  } else {
    leaf(path, value);
  }
}

std::string cell(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_number_float()) return number_text(value.get<double>());
  if (!value.is_string()) return value.dump();
  const std::string text = value.get<std::string>();
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

void for_each_leaf(const Json& row, const std::function<void(const std::string&, const Json&)>& leaf) { walk("", row, leaf); }

void write_rows_csv(const std::function<void(const std::function<void(const std::string&)>&)>& lines,
                    const std::function<void(const std::string&)>& write) {
  std::vector<std::string> columns;
  std::set<std::string> known;
  const auto for_each = [&](const auto& leaf) {
    lines([&](const std::string& line) { for_each_leaf(Json::parse(line), leaf); });
  };
  for_each([&](const std::string& name, const Json&) {
    if (known.insert(name).second) columns.push_back(name);
  });
  std::string header;
  for (const std::string& c : columns) header += (header.empty() ? "" : ",") + c;
  write(header);
  lines([&](const std::string& line) {
    std::map<std::string, std::string> cells;
    for_each_leaf(Json::parse(line), [&](const std::string& name, const Json& value) { cells[name] = cell(value); });
    std::string row;
    for (const std::string& c : columns) row += (&c == &columns.front() ? "" : ",") + cells[c];
    write(row);
  });
}

SweepRows::SweepRows(const std::string& folder, const SweepPlan& plan, bool resume)
    : rows_((fs::path(folder) / "runs.jsonl").string()), table_((fs::path(folder) / "runs.csv").string()) {
  make_folder(folder);
  const fs::path print = fs::path(folder) / "sweep.json";
  part_ = std::make_unique<const PartFile>(rows_);
  std::error_code ignored;
  const bool unfinished = fs::exists(part_->path(), ignored), finished = fs::exists(rows_, ignored);
  if (unfinished && !resume)
    throw InputError(Problem{"", 0, "\"" + folder + "\" holds a sweep that has not come to its end", "its rows would be lost",
                             "Go on with it: --resume. Or name another folder, or delete " + part_->path()});
  if (resume && (unfinished || finished)) {
    check_print(print, plan.print());
    if (!unfinished) fs::rename(rows_, part_->path());
    found_ = keep_whole_lines();
  } else {
    part_->begun();
    write_print(print, plan.print());
  }
  fs::remove(table_, ignored);
  file_ = ::open(part_->path().c_str(), O_WRONLY | O_CREAT | O_APPEND | (found_ == 0 ? O_TRUNC : 0), 0666);
  if (file_ < 0) throw OutputError(unwritten(rows_, errno));
}

SweepRows::~SweepRows() {
  if (file_ >= 0) ::close(file_);
}

/// A crash may have cut the last line. Lines must be those of runs 0, 1, ...: they are counted up to the first that is not.
std::int64_t SweepRows::keep_whole_lines() {
  std::ifstream in(part_->path(), std::ios::binary);
  std::int64_t lines = 0;
  std::uintmax_t bytes = 0;
  for (std::string line; std::getline(in, line) && !in.eof(); bytes += line.size() + 1) {
    const Json row = Json::parse(line, nullptr, false);
    if (!row.is_object() || row.value("run", std::int64_t{-1}) != lines) break;
    ++lines;
  }
  fs::resize_file(part_->path(), bytes);
  return lines;
}

void SweepRows::read(const std::function<void(const std::string&)>& take) const {
  std::ifstream in(part_->path(), std::ios::binary);
  std::string line;
  for (std::int64_t k = 0; k < found_ && std::getline(in, line); ++k) take(line);
}

void SweepRows::append(const std::string& line) {
  const std::string text = line + '\n';
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t written = ::write(file_, text.data() + at, text.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw OutputError(unwritten(rows_, errno, part_->path()));
    at += static_cast<std::size_t>(written);
  }
}

void SweepRows::finish() {
  const auto rows = [this](const std::function<void(const std::string&)>& take) {
    std::ifstream in(part_->path(), std::ios::binary);
    for (std::string line; std::getline(in, line);) take(line);
  };
  OutputFile table(table_);
  write_rows_csv(rows, [&](const std::string& line) {
    table.line() += line;
    table.end_line();
  });
  table.close();
  const int closed = ::close(std::exchange(file_, -1));
  if (const int error = closed != 0 ? errno : part_->keep(); error != 0) throw OutputError(unwritten(rows_, error, part_->path()));
}

}  // namespace carom::app
