#include "carom/write/comparison_csv.hpp"

#include <cmath>
#include <utility>

#include "carom/write/number_text.hpp"

namespace carom {

namespace {

void append_cell(std::string& line, double x) {
  line += ',';
  if (!std::isnan(x)) append_number(line, x);
}
void append_cell(std::string& line, std::int64_t x) {
  line += ',';
  append_number(line, x);
}
template <class T>
void append_cell(std::string& line, const std::optional<T>& x) {
  if (x) {
    append_cell(line, *x);
  } else {
    line += ',';
  }
}

void append_averages(std::string& line, const Averages& a) {
  for (const double x : {a.collision_rate, a.ball_impulse_rate, a.wall_impulse_rate, a.kinetic_energy})
    append_cell(line, x);
}

}  // namespace

ComparisonCsv::ComparisonCsv(std::string path) : file_(std::move(path)) {
  file_.line() +=
      "method,engine,dt,collisions,missed,spurious,escaped,swapped,deepest_overlap,energy_error,momentum_error,"
      "position_error,diverged_at_collision,seconds,steps,time,seconds_per_time,missed_pairs,diverged_at_time,averaged_"
      "from,"
      "collision_rate,ball_impulse_rate,wall_impulse_rate,kinetic_energy,exact_collision_rate,exact_ball_impulse_rate,"
      "exact_wall_impulse_rate,exact_kinetic_energy";
  file_.end_line();
}

void ComparisonCsv::write(const ComparisonRow& row) {
  const Comparison& c = row.result;
  std::string& line = file_.line();
  line += row.method + ',' + row.engine;
  append_cell(line, row.dt);
  for (const std::int64_t n : {c.collisions, c.tally.missed, c.tally.spurious, c.escaped, c.tally.swapped})
    append_cell(line, n);
  for (const double x : {c.deepest_overlap, c.energy_error, c.momentum_error, c.position_error}) append_cell(line, x);
  append_cell(line, c.diverged_at_collision);
  append_cell(line, c.seconds);
  append_cell(line, c.steps);
  append_cell(line, c.time);
  append_cell(line, c.seconds_per_time());
  append_cell(line, c.tally.missed_pairs);
  append_cell(line, c.diverged_at);
  append_cell(line, c.averaged_from);
  append_averages(line, c.here);
  append_averages(line, c.exact);
  file_.end_line();
  file_.flush();  // a row may take long, and be looked at
}

PositionErrorCsv::PositionErrorCsv(std::string path) : file_(std::move(path)) {
  file_.line() += "method,engine,dt,time,error";
  file_.end_line();
}

void PositionErrorCsv::write(const ComparisonRow& row, double time, double error) {
  std::string& line = file_.line();
  line += row.method + ',' + row.engine;
  append_cell(line, row.dt);
  append_cell(line, time);
  append_cell(line, error);
  file_.end_line();
}

}  // namespace carom
