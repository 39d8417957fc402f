#include "carom/observe/survival.hpp"

#include <algorithm>
#include <cmath>

#include "judgement.hpp"

namespace carom {

namespace {

/// gamma and its error between from and to; `gone` is sorted by time, `count` balls were there at the start.
Estimate escape_rate(const std::vector<Departure>& gone, double count, double from, double to) {
  if (!gone.empty() && static_cast<double>(gone.size()) == count) to = std::min(to, gone.back().time);
  const double middle = (from + to) / 2, half = (to - from) / 2;
  double left = count, sum = 0, squares = 0;
  for (const Departure& d : gone) {
    if (d.time > from && d.time <= to) {
      const double u = (d.time - middle) / half, bell = (1 - u * u) * (1 - u * u), term = bell * bell / left;
      sum += term;
      squares += term * term;
    }
    left -= 1;
  }
  const double whole = half * 256 / 315;  // integral of the weights
  return {"survival.escape_rate", sum / whole, std::sqrt(squares) / whole};
}

/// Balls that can leave at all, those that move.
double movable(const Simulation& simulation) {
  double n = static_cast<double>(simulation.departures().size());
  for (std::uint32_t i = 0; i < simulation.ball_count(); ++i)
    if (simulation.alive(i) && simulation.glimpse(i).mass < HUGE_VAL) n += 1;
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
  const Estimate rate = n > 0 ? escape_rate(gone, movable(simulation), from, to) : Estimate{"survival.escape_rate"};
  return {rate, {"survival.departures", n, std::sqrt(n)}};
}

std::vector<Table> Survival::tables(const Simulation& simulation) const {
  if (!asked_) return {};
  const std::vector<Departure> all = simulation.departures();
  const double count = movable(simulation), end = simulation.time();
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
