#include "carom/write/summary_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "energy_error.hpp"

namespace carom {

namespace {

std::string number(double x) { return fmt::format("{:.9g}", x); }
std::string size(double x) { return fmt::format("{:.2g}", x); }

std::string vector_text(const std::vector<Number>& components) {
  if (components.size() == 1) return number(components.front());
  std::string text;
  for (const double x : components) text += (text.empty() ? "(" : ", ") + number(x);
  return text + ")";
}

std::string plural(std::int64_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

enum class Tone { plain, warning };

class Table {
 public:
  explicit Table(Colour colour) : colour_(colour) {}

  void title(const std::string& text) { text_ += painted("\x1b[1m", text) + "\n\n"; }
  void row(const char* label, const std::string& value, Tone tone = Tone::plain) {
    text_ += painted("\x1b[2m", fmt::format("  {:<18}", label)) +
             (tone == Tone::warning ? painted("\x1b[31m", value) : value) + '\n';
  }
  void line(const std::string& text) { text_ += text + "\n"; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  [[nodiscard]] std::string painted(const char* paint, const std::string& text) const {
    return colour_ == Colour::on ? paint + text + "\x1b[0m" : text;
  }

  Colour colour_;
  std::string text_;
};

void add_run(Table& table, const Summary& s) {
  table.row("stopped by", fmt::format("{}, at time {}", word(s.stopped_by), number(s.time)),
            s.stopped ? Tone::warning : Tone::plain);
  if (s.stopped) {
    std::string balls;
    for (const std::uint32_t b : s.stopped->balls) balls += (balls.empty() ? "" : ", ") + std::to_string(b);
    table.row("", s.stopped->reason);
    table.row("", fmt::format("ball {} at time {}", balls, number(s.stopped->time)));
  }
  table.row("collisions", fmt::format("{}: {} of two balls, {} with walls; {}", s.events.collisions(), s.events.ball_ball,
                                      s.events.ball_wall, plural(s.events.ties, "tie", "ties")));
  if (s.events.other > 0) table.row("other events", std::to_string(s.events.other));
}

void add_energy(Table& table, const EnergyBalance& e) {
  table.row("energy", number(e.initial) + " -> " + number(e.final));
  if (e.dissipated != 0 || e.injected != 0)
    table.row("", fmt::format("{} dissipated, {} injected", number(e.dissipated), number(e.injected)));
  const double ulp = energy_error_ulp(e);
  const std::string ulps = std::isnan(ulp) ? "" : fmt::format(", {} ulp of the initial energy", size(ulp));
  table.row("energy error", fmt::format("{}{}; relative {}", size(energy_error(e)), ulps, size(e.relative_error)));
}

void add_balance(Table& table, const char* label, const VectorBalance& b, const char* what_changes_it) {
  if (b.initial.empty()) return;
  table.row(label, vector_text(b.initial) + " -> " + vector_text(b.final));
  table.row("", b.relative_error ? "relative error " + size(*b.relative_error)
                                 : fmt::format("not conserved here ({})", what_changes_it));
}

void add_exactness(Table& table, const ExactnessSummary& e) {
  table.row("largest gap error", fmt::format("{}, {} of the radii", size(e.max_gap_error), size(e.max_gap_error_relative)));
  table.row("counted", fmt::format("{} clamped, {} unresolved, {} singular", e.clamped, e.unresolved, e.singular),
            e.clamped > 0 || e.unresolved > 0 ? Tone::warning : Tone::plain);
}

void add_growth(Table& table, const GrowthSummary& g) {
  if (g.packing_fraction) table.row("packing fraction", number(*g.packing_fraction));
  if (g.reduced_pressure) table.row("reduced pressure", number(*g.reduced_pressure) + " over the last block of collisions");
}

void add_observed(Table& table, const Estimates& observed) {
  if (observed.empty()) return;
  std::size_t width = 0;
  for (const Estimate& e : observed) width = std::max(width, e.name.size());
  table.line("\n  observed (with one standard error)");
  for (const Estimate& e : observed)
    table.line(fmt::format("    {:<{}}  {}{}", e.name, width, std::isnan(e.value) ? "not measured" : number(e.value),
                           std::isnan(e.error) ? "" : " +- " + size(e.error)));
  table.line("");
}

void add_cost(Table& table, const RunReport& r) {
  table.row("took", fmt::format("{:.3g} s, {:.3g} collisions/s, {:.3g} MB; all else is in the scene's units", r.seconds,
                                r.collisions_per_second(), r.peak_memory_mb));
  table.row("run as", fmt::format("{} in {}-D, {}, {} precision", plural(r.summary.balls, "ball", "balls"),
                                  r.summary.dimension, r.summary.composition, r.summary.precision));
}

void add_files(Table& table, const std::vector<std::string>& files) {
  for (const std::string& file : files) table.row(&file == &files.front() ? "wrote" : "", file);
}

void add_final(Table& table, const std::vector<BallState>& balls, int dimension) {
  std::vector<std::vector<std::string>> cells(1, {"ball", "name"});
  const bool named = std::any_of(balls.begin(), balls.end(), [](const BallState& b) { return !b.name.empty(); });
  for (const char* prefix : {"", "v"})
    for (int k = 0; k < dimension; ++k) cells.front().push_back(std::string(prefix) + "xyz"[k]);
  for (const BallState& b : balls) {
    std::vector<std::string>& row = cells.emplace_back(std::vector<std::string>{std::to_string(b.index), b.name});
    for (const double x : b.position) row.push_back(number(x));
    for (const double v : b.velocity) row.push_back(number(v));
  }
  std::vector<std::size_t> widths(cells.front().size(), 0);
  for (const auto& row : cells)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  table.line("");
  for (const auto& row : cells) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k)
      if (k != 1 || named) line += fmt::format("  {:>{}}", row[k], widths[k]);
    table.line(line);
  }
}

}  // namespace

std::string summary_table(const RunReport& report, Colour colour) {
  const Summary& s = report.summary;
  Table table(colour);
  if (!s.title.empty()) table.title(s.title);
  add_run(table, s);
  add_energy(table, s.energy);
  add_balance(table, "momentum", s.momentum, "walls, forces or balls of infinite mass change it");
  add_balance(table, "angular momentum", s.angular_momentum,
              "walls, forces, balls of infinite mass or a periodic space change it");
  add_exactness(table, s.exactness);
  if (s.growth) add_growth(table, *s.growth);
  add_observed(table, report.observed);
  add_cost(table, report);
  add_files(table, report.files);
  if (report.final) add_final(table, *report.final, s.dimension);
  return table.text();
}

}  // namespace carom
