#include "figures.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include <fmt/core.h>

#include "carom/core/error.hpp"
#include "carom/write/frame_reader.hpp"
#include "carom/write/number_text.hpp"
#include "plain_table.hpp"

namespace carom::app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_points = 5000;
constexpr std::size_t bins = 100;

using Rows = std::vector<std::vector<double>>;

/// A text of gnuplot, whose quotes are doubled.
std::string text(const std::string& s) {
  std::string quoted = "'";
  for (const char c : s) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

std::string readable(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// The block of data $name, thinned.
std::string data(const std::string& name, const Rows& rows) {
  const std::size_t step = rows.size() / most_points + 1;
  std::string s = "$" + name + " << EOD\n";
  for (std::size_t i = 0; i < rows.size(); i += step) {
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      if (k > 0) s += ' ';
      s += std::isfinite(rows[i][k]) ? number_text(rows[i][k]) : "?";
    }
    s += '\n';
  }
  return s + "EOD\n";
}

std::string settings(const std::string& title, const std::string& x, const std::string& y) {
  return fmt::format(
      "set datafile missing '?'\nset title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\nset grid lc rgb "
      "'#dddddd'\nset key noenhanced\nset linetype 1 lc rgb '#0072b2' lw 1.5\nset linetype 2 lc rgb '#d55e00' lw 1.5\nset "
      "linetype 3 lc rgb '#009e73' lw 1.5\nset linetype 4 lc rgb '#cc79a7' lw 1.5\n",
      text(title), text(x), text(y));
}

Figure energy(const PlainTable& ledger) {
  const auto column = [&](const char* name) { return ledger.find(name).value_or(0) + 1; };
  std::string s = data("ledger", ledger.rows) + settings(ledger.title, "time", "energy");
  s += "set offsets 0, 0, graph 0.08, graph 0.08\nset multiplot layout 2,1\n";
  s += fmt::format("plot $ledger using 1:{} with lines title 'energy', '' using 1:{} with lines title 'dissipated', "
                   "'' using 1:{} with lines title 'injected'\n",
                   column("energy"), column("dissipated"), column("injected"));
  s += "unset title\nset ylabel 'imbalance [ulp]'\n";
  s += fmt::format("plot $ledger using 1:{} with steps notitle\nunset multiplot\n", column("imbalance_ulp"));
  return {"energy", s};
}

/// How many collisions there are in each of equal spans of time.
std::optional<Figure> collisions(const std::string& path) {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  const PlainTable head = read_table(path, [&](const std::vector<double>& row) {
    first = std::min(first, row.front());
    last = std::max(last, row.front());
  });
  if (!(last > first)) return std::nullopt;
  const double width = (last - first) / bins;
  Rows rows(bins);
  for (std::size_t b = 0; b < bins; ++b) rows[b] = {first + (static_cast<double>(b) + 0.5) * width, 0.0};
  static_cast<void>(read_table(path, [&](const std::vector<double>& row) {
    const double bin = (row.front() - first) / width;
    rows[std::min(bins - 1, static_cast<std::size_t>(bin))][1] += 1 / width;
  }));
  return Figure{"collisions", data("rate", rows) + settings(head.title, "time", "collisions per unit of time") +
                                  "set yrange [0:*]\nplot $rate using 1:2 with histeps notitle\n"};
}

std::string speeds_script(const std::string& title, const Rows& rows, bool maxwell) {
  std::string s = data("speeds", rows) + settings(title, "speed", "density");
  s += "set yrange [0:*]\nset style fill solid 0.3\nplot $speeds using 1:2 with boxes title 'measured'";
  return s + (maxwell ? ", '' using 1:3 with lines title 'Maxwell'\n" : "\n");
}

Figure speeds(const PlainTable& table) {
  const auto column = [&](const char* name) { return table.find(name).value_or(0); };
  Rows rows;
  for (const auto& row : table.rows)
    rows.push_back({0.5 * (row[column("from")] + row[column("to")]), row[column("density")], row[column("maxwell")]});
  return {"speeds", speeds_script(table.title, rows, true)};
}

/// Maxwell's density of speeds in D dimensions at the temperature k_B T / m.
double maxwell(double v, int dimension, double temperature) {
  const double w = std::exp(-v * v / (2 * temperature));
  if (dimension == 1) return std::sqrt(2 / (std::numbers::pi * temperature)) * w;
  if (dimension == 2) return v / temperature * w;
  return std::sqrt(2 / std::numbers::pi) * v * v / std::pow(temperature, 1.5) * w;
}

/// Of all frames. The curve is drawn where all balls have one mass.
std::optional<Figure> speeds_of_frames(const std::string& path) {
  std::vector<double> of;
  double squares = 0.0;
  std::optional<double> mass;
  bool one_mass = true;
  const std::unique_ptr<FrameReader> reader = read_frames(path);
  for (TrajectoryFrame frame; reader->next(frame);)
    for (const BallState& ball : frame.balls) {
      double square = 0.0;
      for (const double v : ball.velocity) square += v * v;
      of.push_back(std::sqrt(square));
      squares += square;
      one_mass = one_mass && ball.mass.value == mass.value_or(ball.mass);
      mass = ball.mass;
    }
  if (of.empty() || squares == 0.0 || !reader->head().velocities) return std::nullopt;
  const double fastest = *std::max_element(of.begin(), of.end());
  constexpr std::size_t classes = 50;
  const double width = fastest / classes, each = 1 / (static_cast<double>(of.size()) * width);
  const int dimension = reader->head().dimension;
  const double temperature = squares / (static_cast<double>(of.size()) * dimension);
  Rows rows(classes);
  for (std::size_t b = 0; b < classes; ++b) {
    const double v = (static_cast<double>(b) + 0.5) * width;
    rows[b] = {v, 0.0, maxwell(v, dimension, temperature)};
  }
  for (const double v : of) rows[std::min(classes - 1, static_cast<std::size_t>(v / width))][1] += each;
  return Figure{"speeds", speeds_script(reader->head().title, rows, one_mass)};
}

/// Every column over the first one; a column `error` is the error of the one before it.
std::optional<Figure> any_table(const std::string& name, const PlainTable& table) {
  if (table.columns.size() < 2 || table.rows.empty()) return std::nullopt;
  const bool points = name.find("map") != std::string::npos || name.find("poincare") != std::string::npos ||
                      name.find("sequence") != std::string::npos;
  std::string plots;
  for (std::size_t k = 1; k < table.columns.size(); ++k) {
    if (table.columns[k] == "error") continue;
    const bool numbers = std::any_of(table.rows.begin(), table.rows.end(), [k](const auto& row) { return std::isfinite(row[k]); });
    if (!numbers) continue;
    const bool error = k + 1 < table.columns.size() && table.columns[k + 1] == "error";
    const std::string style = points ? "points pt 7 ps 0.3" : error ? "yerrorlines" : "lines";
    plots += (plots.empty() ? "plot " : ", ") +
             (error ? fmt::format("$table using 1:{}:{}", k + 1, k + 2) : fmt::format("$table using 1:{}", k + 1)) + " with " + style +
             " title " + text(readable(table.columns[k]));
    if (points) break;
  }
  if (plots.empty()) return std::nullopt;
  return Figure{name, data("table", table.rows) + settings(table.title, readable(table.columns[0]), readable(name)) + plots + "\n"};
}

class Search {
 public:
  explicit Search(const std::string& folder) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
      if (entry.is_regular_file()) files_[entry.path().filename().string()] = entry.path().string();
    if (error)
      throw InputError(Problem{"", 0, "cannot read the folder \"" + folder + "\"", error.message(), "Give the folder of carom run --out"});
  }

  Figures operator()() {
    for (const auto& [name, path] : files_)
      if (name.ends_with(".csv")) table(name, path);
    for (const auto& [name, path] : files_)
      if (!has("speeds") && (name.ends_with(".h5") || name.ends_with(".xyz"))) add(speeds_of_frames(path));
    if (!has("energy")) found_.missing.emplace_back("energy: no ledger. Set output.ledger = \"ledger.csv\" and run.sample_every");
    if (!has("collisions")) found_.missing.emplace_back("collisions: no event log. Set output.events = \"events.csv\"");
    if (!has("speeds")) found_.missing.emplace_back("speeds: no frames. Set observe.speed_histogram = true, or output.trajectory");
    return std::move(found_);
  }

 private:
  void table(const std::string& name, const std::string& path) {
    const std::string kind = read_table(path, [](const std::vector<double>&) {}).kind;
    if (kind == "event log") return add(collisions(path));
    if (kind == "trajectory") return has("speeds") || files_.contains("speed_histogram.csv") ? void() : add(speeds_of_frames(path));
    if (kind.empty()) return;
    const PlainTable table = read_table(path);
    if (kind == "ledger") return add(energy(table));
    if (kind == "speed histogram") return add(speeds(table));
    add(any_table(fs::path(name).stem().string(), table));
  }

  [[nodiscard]] bool has(const std::string& name) const {
    return std::any_of(found_.list.begin(), found_.list.end(), [&](const Figure& f) { return f.name == name; });
  }
  void add(std::optional<Figure> figure) {
    if (figure && !has(figure->name)) found_.list.push_back(std::move(*figure));
  }

  std::map<std::string, std::string> files_;  // by name
  Figures found_;
};

}  // namespace

Figures figures_in(const std::string& folder) { return Search(folder)(); }

}  // namespace carom::app
