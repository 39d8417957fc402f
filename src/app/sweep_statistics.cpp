#include "sweep_statistics.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/core.h>

#include "sweep_rows.hpp"

namespace carom::app {

namespace {

/// Numbers of more digits than a double are strings.
std::optional<double> number(const Json& value) {
  if (value.is_number()) return value.get<double>();
  if (!value.is_string()) return std::nullopt;
  const std::string& text = value.get_ref<const std::string&>();
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return x;
}

bool is_measured(const std::string& name) {
  return name != "run" && name != "combination" && !name.starts_with("set.") && !name.ends_with(".error") &&
         !(name.starts_with("final.") && name.ends_with(".index"));
}

std::string with_error(const RunMean& m) {
  if (m.count() == 0) return "-";
  return std::isnan(m.error()) ? fmt::format("{:.9g}", m.mean()) : fmt::format("{:.9g} +- {:.2g}", m.mean(), m.error());
}

}  // namespace

void RunMean::add(double x) noexcept {
  ++count_;
  const double from_old = x - mean_;
  mean_ += from_old / static_cast<double>(count_);
  squares_ += from_old * (x - mean_);
}

double RunMean::error() const noexcept {
  if (count_ < 2) return std::numeric_limits<double>::quiet_NaN();
  const auto n = static_cast<double>(count_);
  return std::sqrt(squares_ / (n * (n - 1)));
}

SweepStatistics::SweepStatistics(const SweepPlan& plan) : plan_(plan) {
  const std::int64_t combinations = plan.ensemble().combinations();
  groups_.resize(combinations <= most_groups ? static_cast<std::size_t>(combinations) : 1);
}

void SweepStatistics::add(const std::string& line) {
  const Json row = Json::parse(line);
  SweepGroup& group = groups_[grouped() ? row.at("combination").get<std::size_t>() : 0];
  const std::string& outcome = row.at("outcome").get_ref<const std::string&>();
  (outcome == "done" ? group.done : outcome == "stopped" ? group.stopped : group.refused) += 1;
  if (outcome != "done") return;
  for_each_leaf(row, [&](const std::string& name, const Json& value) {
    if (!is_measured(name)) return;
    const std::optional<double> x = number(value);
    if (!x) return;
    const auto [at, is_new] = number_of_.emplace(name, names_.size());
    if (is_new) names_.push_back(name);
    if (group.values.size() <= at->second) group.values.resize(at->second + 1);
    group.values[at->second].add(*x);
  });
}

SweepGroup SweepStatistics::total() const {
  SweepGroup all;
  for (const SweepGroup& g : groups_) {
    all.done += g.done;
    all.stopped += g.stopped;
    all.refused += g.refused;
  }
  return all;
}

Json SweepStatistics::object() const {
  const SweepGroup all = total();
  Json list = Json::array();
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const SweepGroup& g = groups_[i];
    Json set = Json::object(), values = Json::object();
    if (grouped())
      for (const Override& o : plan_.ensemble().listed(static_cast<std::int64_t>(i))) {
        const Json value = Json::parse(o.value, nullptr, false);
        set[o.key] = value.is_discarded() ? Json(o.value) : value;
      }
    for (std::size_t k = 0; k < g.values.size(); ++k)
      if (g.values[k].count() > 0) values[names_[k]] = {{"value", g.values[k].mean()}, {"error", g.values[k].error()}};
    list.push_back({{"set", set}, {"runs", g.runs()}, {"done", g.done}, {"values", values}});
  }
  return {{"title", plan_.title()}, {"runs", all.runs()}, {"of", plan_.ensemble().runs()}, {"done", all.done},
          {"stopped", all.stopped}, {"refused", all.refused}, {"seed", plan_.ensemble().spec().seed},
          {"precision", plan_.precision().text()}, {"groups", list}};
}

std::vector<std::size_t> SweepStatistics::shown() const {
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < names_.size(); ++k)
    if (names_[k].starts_with("observed.")) list.push_back(k);
  if (!list.empty() && grouped()) return list;
  for (const char* name : {"time", "events.ball_ball", "events.ball_wall", "energy.relative_error"})
    if (const auto at = number_of_.find(name); at != number_of_.end()) list.push_back(at->second);
  return list;
}

std::string SweepStatistics::long_table() const {
  std::string text;
  const SweepGroup& g = groups_.front();
  std::size_t width = 0;
  for (const std::size_t k : shown()) width = std::max(width, names_[k].size());
  for (const std::size_t k : shown())
    if (k < g.values.size()) text += fmt::format("    {:<{}}  {}\n", names_[k], width, with_error(g.values[k]));
  return text;
}

std::string SweepStatistics::wide_table() const {
  constexpr std::size_t most_lines = 40;
  std::vector<std::vector<std::string>> cells(1);
  for (const Override& o : plan_.ensemble().listed(0)) cells[0].push_back(o.key);
  cells[0].push_back("runs");
  for (const std::size_t k : shown()) {
    const bool observed = names_[k].starts_with("observed.");
    cells[0].push_back(observed ? names_[k].substr(std::string("observed.").size()) : names_[k]);
  }
  for (std::size_t i = 0; i < std::min(groups_.size(), most_lines); ++i) {
    std::vector<std::string>& line = cells.emplace_back();
    for (const Override& o : plan_.ensemble().listed(static_cast<std::int64_t>(i))) line.push_back(o.value);
    const SweepGroup& g = groups_[i];
    line.push_back(std::to_string(g.done) + (g.done == g.runs() ? "" : fmt::format(" of {}", g.runs())));
    for (const std::size_t k : shown()) line.push_back(k < g.values.size() ? with_error(g.values[k]) : "-");
  }
  std::vector<std::size_t> widths(cells[0].size(), 0);
  for (const auto& line : cells)
    for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], line[c].size());
  std::string text;
  for (const auto& line : cells) {
    for (std::size_t c = 0; c < line.size(); ++c) text += fmt::format("  {:>{}}", line[c], widths[c]);
    text += '\n';
  }
  if (groups_.size() > most_lines) text += fmt::format("  ... {} combinations more: --json or --out has them\n", groups_.size() - most_lines);
  return text;
}

std::string SweepStatistics::table() const {
  const SweepGroup all = total();
  std::string text = plan_.title().empty() ? "" : plan_.title() + "\n\n";
  text += fmt::format("  runs  {} of {}: {} done, {} stopped, {} refused\n", all.runs(), plan_.ensemble().runs(), all.done,
                      all.stopped, all.refused);
  if (all.done == 0) return text;
  return text + (grouped() ? "\n" + wide_table() : "  means over runs\n" + long_table());
}

}  // namespace carom::app
