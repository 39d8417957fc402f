#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "carom/write/comparison_report.hpp"
#include "carom/write/number_text.hpp"

namespace carom {

namespace {

using Line = std::vector<std::string>;

std::string size(double x) { return std::isnan(x) ? "-" : fmt::format("{:.2g}", x); }

/// What it is of the exact value; "-" where there is none.
std::string ratio(double here, double exact) {
  return exact > 0 && std::isfinite(here) ? fmt::format("{:.3g}", here / exact) : "-";
}

/// Columns under their heads: the first to the left, the others to the right.
std::string aligned(const std::vector<Line>& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const Line& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], line[k].size());
  std::string text;
  for (const Line& line : lines) {
    text += fmt::format("  {:<{}}", line[0], widths[0]);
    for (std::size_t k = 1; k < line.size(); ++k) text += fmt::format("  {:>{}}", line[k], widths[k]);
    text += '\n';
  }
  return text;
}

std::string parted(const Comparison& c) {
  return c.diverged_at_collision ? fmt::format("collision {}", *c.diverged_at_collision) : "-";
}

std::string what_happened(const std::vector<ComparisonRow>& rows) {
  std::vector<Line> lines{
      {"", "dt", "collisions", "missed", "spurious", "swapped", "escaped", "deepest overlap", "parted at"}};
  for (const ComparisonRow& row : rows) {
    const Comparison& c = row.result;
    lines.push_back({row.name(), number_text(row.dt), std::to_string(c.collisions), std::to_string(c.tally.missed),
                     std::to_string(c.tally.spurious), std::to_string(c.tally.swapped), std::to_string(c.escaped),
                     size(c.deepest_overlap), parted(c)});
  }
  return aligned(lines);
}

std::string how_far_off(const std::vector<ComparisonRow>& rows) {
  std::vector<Line> lines{
      {"", "dt", "position error", "energy error", "momentum error", "rate ratio", "energy ratio", "pressure ratio"}};
  for (const ComparisonRow& row : rows) {
    const Comparison& c = row.result;
    lines.push_back({row.name(), number_text(row.dt), size(c.position_error), size(c.energy_error), size(c.momentum_error),
                     ratio(c.here.collision_rate, c.exact.collision_rate),
                     ratio(c.here.kinetic_energy, c.exact.kinetic_energy),
                     ratio(c.here.wall_impulse_rate, c.exact.wall_impulse_rate)});
  }
  return aligned(lines) + "  ratios: averages over those of the exact run, from where they parted, or the start\n";
}

std::string what_it_took(const ComparisonReport& report) {
  std::string text = fmt::format("  took   exact: {:.3g} s\n", report.exact.seconds);
  for (const ComparisonRow& row : report.rows)
    text += fmt::format("  took   {}, dt {}: {:.3g} s for {} steps, {:.3g} s per unit of time\n", row.name(),
                        number_text(row.dt), row.result.seconds, row.result.steps, row.result.seconds_per_time());
  return text;
}

}  // namespace

std::string comparison_table(const ComparisonReport& report, Colour colour) {
  const Summary& s = report.exact.summary;
  std::string text;
  if (!s.title.empty()) text += (colour == Colour::on ? "\x1b[1m" + s.title + "\x1b[0m" : s.title) + "\n\n";
  const std::int64_t n = s.events.collisions();
  text += fmt::format("  exact  {} collision{} to time {}, energy error {}\n", n, n == 1 ? "" : "s", number_text(s.time),
                      size(s.energy.relative_error));
  if (!report.rows.empty()) text += '\n' + what_happened(report.rows) + '\n' + how_far_off(report.rows) + '\n';
  return text + what_it_took(report);
}

}  // namespace carom
