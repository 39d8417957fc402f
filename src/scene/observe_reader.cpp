#include "observe_reader.hpp"

#include <optional>
#include <string_view>
#include <utility>

namespace carom::scene_text {

namespace {

void read_settings(TableReader& t, RadialDistributionSpec& r) {
  t.number("every", r.every);
  t.number("r_max", r.r_max);
  t.integer("bins", r.bins);
}
void read_settings(TableReader& t, LagsSpec& l) {
  t.number("every", l.every);
  t.integer("lags", l.lags);
  t.integer("origins", l.origins);
}

void read_settings(TableReader& t, LyapunovSpec& l) {
  t.integer("exponents", l.exponents);
  t.number("every", l.every);
  t.number("finite_time", l.finite_time);
}
void read_settings(TableReader& t, TableFileSpec& f) { t.text("file", f.file); }
void read_settings(TableReader& t, PoincareSpec& p) {
  t.coordinates("point", p.point);
  t.coordinates("normal", p.normal);
  t.text("file", p.file);
}
void read_settings(TableReader& t, SurvivalSpec& s) {
  t.number("from", s.from);
  t.number("to", s.to);
  t.integer("bins", s.bins);
  t.text("file", s.file);
  t.text("departures", s.departures);
}
void read_settings(TableReader& t, PhaseSpaceSpec& p) { t.integer("bins", p.bins); }

// `key = true` asks with all defaults, a table with others.
template <class Spec>
void read_asked(TableReader& t, std::string_view key, std::optional<Spec>& to) {
  const toml::node* node = t.source().get(key);
  if (node != nullptr && node->is_table()) {
    TableReader inner = *t.table(key);
    read_settings(inner, to.emplace());
    inner.finish();
  } else {
    bool asked = false;
    t.flag(key, asked);
    if (asked) to.emplace();
  }
}

}  // namespace

ObserveSpec read_observe(TableReader t) {
  ObserveSpec o;
  o.where = t.where();
  if (std::optional<TableReader> after = t.table("after")) {
    after->integer("events", o.after_events);
    after->number("time", o.after_time);
    after->finish();
  }
  t.flag("pressure", o.pressure);
  t.flag("collision_rate", o.collision_rate);
  t.flag("mean_free_path", o.mean_free_path);
  t.flag("speed_histogram", o.speed_histogram);
  read_asked(t, "radial_distribution", o.radial_distribution);
  read_asked(t, "mean_squared_displacement", o.mean_squared_displacement);
  read_asked(t, "velocity_autocorrelation", o.velocity_autocorrelation);
  read_asked(t, "angle_autocorrelation", o.angle_autocorrelation);
  read_asked(t, "diffusion", o.diffusion);
  read_asked(t, "lyapunov", o.lyapunov);
  read_asked(t, "boundary_map", o.boundary_map);
  read_asked(t, "poincare", o.poincare);
  read_asked(t, "survival", o.survival);
  read_asked(t, "phase_space_portion", o.phase_space_portion);
  read_asked(t, "wall_sequence", o.wall_sequence);
  t.flag("rotation_number", o.rotation_number);
  t.flag("caustic", o.caustic);
  t.finish();
  return o;
}

}  // namespace carom::scene_text
