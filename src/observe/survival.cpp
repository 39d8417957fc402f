#include "carom/observe/survival.hpp"

#include <algorithm>
#include <cmath>

#include "judgement.hpp"

namespace carom {

namespace {

constexpr std::uint32_t groups = 20;

/// The slope of -ln N over from .. to, without the balls of one group (`groups`: with all). `gone` is sorted by time.
double escape_rate(const std::vector<Departure>& gone, double count, double from, double to, std::uint32_t without) {
  const auto taken = [&](const Departure& d) { return d.ball % groups != without; };
  double left = count;
  for (const Departure& d : gone) {
    if (!taken(d)) continue;
    if (d.time <= to) left -= 1;
    if (left == 0) to = d.time;  // nothing is left to take a logarithm of
  }
  const double middle = (from + to) / 2, span = to - from;
  double at = from, sum = 0;
  left = count;
  const auto pass = [&](double t) {
    sum += std::log(left) * ((t - middle) * (t - middle) - (at - middle) * (at - middle)) / 2;
    at = t;
  };
  for (const Departure& d : gone) {
    if (!taken(d)) continue;
    if (d.time >= to) break;
    if (d.time > from) pass(d.time);
    left -= 1;
  }
  pass(to);
  return -12 * sum / (span * span * span);
}

/// Delete one group, each in turn.
double jackknife_error(const std::vector<Departure>& gone, const std::vector<double>& counts, double from, double to) {
  double sum = 0, squares = 0;
  for (std::uint32_t g = 0; g < groups; ++g) {
    const double rate = escape_rate(gone, counts[groups] - counts[g], from, to, g);
    sum += rate;
    squares += rate * rate;
  }
  const double n = groups;
  return std::sqrt(std::max(0.0, (squares - sum * sum / n) * (n - 1) / n));
}

/// Balls that can leave at all, those that move: by group, and of all.
std::vector<double> movable(const Simulation& simulation) {
  std::vector<double> n(groups + 1, 0.0);
  const auto count = [&](std::uint32_t ball) {
    n[ball % groups] += 1;
    n[groups] += 1;
  };
  for (const Departure& d : simulation.departures()) count(d.ball);
  for (std::uint32_t i = 0; i < simulation.ball_count(); ++i)
    if (simulation.alive(i) && simulation.glimpse(i).mass < HUGE_VAL) count(i);
  return n;
}

}  // namespace

Survival::Survival(const Scene& scene, const Simulation& simulation)
    : asked_(scene.observe.survival), start_(scene.run.start), dimension_(simulation.dimension()) {
  if (!asked_) return;
  ObserveJudgement judgement(scene);
  if (std::none_of(scene.walls.begin(), scene.walls.end(), [](const WallSpec& w) { return w.opening; }))
    judgement.refuse("survival", "no wall is an opening", "Give a [[wall]] opening = true, or a [[table]] kind = \"pinball\"");
  judgement.throw_if_any();
}

double Survival::until(const Simulation& simulation) const {
  const double now = simulation.time();
  return asked_->to ? std::min(asked_->to->value, now) : now;
}

Estimates Survival::estimates(const Simulation& simulation) const {
  if (!asked_) return {};
  const double from = asked_->from ? asked_->from->value : start_, to = until(simulation);
  const std::vector<Departure> gone = simulation.departures();
  const double n = static_cast<double>(std::count_if(gone.begin(), gone.end(), [&](const Departure& d) { return d.time > from && d.time <= to; }));
  Estimate rate{"survival.escape_rate"};
  const Estimate departures{"survival.departures", n, std::sqrt(n)};
  if (n > 0) {
    const std::vector<double> counts = movable(simulation);
    rate.value = escape_rate(gone, counts[groups], from, to, groups);
    rate.error = jackknife_error(gone, counts, from, to);
  }
  return {rate, departures};
}

std::vector<Table> Survival::tables(const Simulation& simulation) const {
  if (!asked_) return {};
  const std::vector<Departure> all = simulation.departures();
  const double count = movable(simulation)[groups], end = simulation.time();
  Table curve{"survival", {"time", "balls", "share", "error"}, {}};
  std::size_t gone = 0;
  for (std::int64_t k = 0; k <= asked_->bins; ++k) {
    const double t = start_ + (end - start_) * static_cast<double>(k) / static_cast<double>(asked_->bins);
    while (gone < all.size() && all[gone].time <= t) ++gone;
    const double left = count - static_cast<double>(gone), share = left / count;
    curve.rows.push_back({t, left, share, std::sqrt(share * (1 - share) / count)});
  }
  Table departures{"departures", {"ball", "time"}, {}};
  for (const char* what : {"", "v"})
    for (int k = 0; k < dimension_; ++k) departures.columns.push_back(what + std::string(1, "xyz"[k]));
  departures.columns.insert(departures.columns.end(), {"wall", "feature"});
  for (const Departure& d : all) {
    std::vector<double>& row = departures.rows.emplace_back(std::vector<double>{static_cast<double>(d.ball), d.time});
    for (const auto* v : {&d.position, &d.velocity}) row.insert(row.end(), v->begin(), v->begin() + dimension_);
    row.push_back(d.wall);
    row.push_back(d.feature);
  }
  return {std::move(curve), std::move(departures)};
}

std::vector<std::pair<std::string, std::string>> survival_files(const ObserveSpec& observe) {
  if (!observe.survival) return {};
  const SurvivalSpec& s = *observe.survival;
  return {{"survival", s.file.empty() ? "survival.csv" : s.file}, {"departures", s.departures.empty() ? "departures.csv" : s.departures}};
}

}  // namespace carom
