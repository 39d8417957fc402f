#include "carom/write/comparison_report.hpp"
#include "summary_object.hpp"

namespace carom {

namespace {

template <class T>
Json or_null(const std::optional<T>& x) {
  return x ? Json(*x) : Json(nullptr);
}
Json or_null(const std::string& name) { return name.empty() ? Json(nullptr) : Json(name); }

Json averages(const Averages& a) {
  return {{"collision_rate", a.collision_rate},
          {"ball_impulse_rate", a.ball_impulse_rate},
          {"wall_impulse_rate", a.wall_impulse_rate},
          {"kinetic_energy", a.kinetic_energy}};
}

Json row_object(const ComparisonRow& row) {
  const Comparison& c = row.result;
  return {{"method", or_null(row.method)},
          {"engine", or_null(row.engine)},
          {"dt", row.dt},
          {"collisions", c.collisions},
          {"missed", c.tally.missed},
          {"spurious", c.tally.spurious},
          {"escaped", c.escaped},
          {"swapped", c.tally.swapped},
          {"deepest_overlap", c.deepest_overlap},
          {"energy_error", c.energy_error},
          {"momentum_error", c.momentum_error},
          {"position_error", c.position_error},
          {"diverged_at_collision", or_null(c.diverged_at_collision)},
          {"seconds", c.seconds},
          {"steps", c.steps},
          {"time", c.time},
          {"seconds_per_time", c.seconds_per_time()},
          {"missed_pairs", c.tally.missed_pairs},
          {"diverged_at_time", or_null(c.diverged_at)},
          {"averages",
           {{"from", c.averaged_from}, {"to", c.time}, {"stepper", averages(c.here)}, {"exact", averages(c.exact)}}}};
}

}  // namespace

std::string comparison_json(const ComparisonReport& report) {
  Json rows = Json::array();
  for (const ComparisonRow& row : report.rows) rows.push_back(row_object(row));
  return json_text(
      Json{{"exact", summary_object(report.exact)}, {"rows", std::move(rows)}, {"interrupted", report.interrupted}});
}

}  // namespace carom
