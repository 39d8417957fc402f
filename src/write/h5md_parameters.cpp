#include "h5md_parameters.hpp"

#include <cstdlib>

namespace carom {

namespace {

using h5::Id;

std::string author() {
  for (const char* variable : {"USER", "LOGNAME"})
    if (const char* name = std::getenv(variable); name != nullptr && *name != '\0') return name;
  return "unknown";
}

void write_balance(const Id& ledger, const std::string& name, const VectorBalance& balance) {
  const auto put = [&](const char* when, const std::vector<Number>& components) {
    if (components.empty()) return;
    const std::vector<double> values(components.begin(), components.end());
    h5::put_attribute<double>(ledger, (name + when).c_str(), std::span(values));
  };
  put("_initial", balance.initial);
  put("_final", balance.final);
  if (balance.relative_error) h5::put_attribute(ledger, (name + "_relative_error").c_str(), balance.relative_error->value);
}

void write_ledger(const Id& ledger, const Summary& s) {
  const auto number = [&](const char* name, double value) { h5::put_attribute(ledger, name, value); };
  const auto count = [&](const char* name, std::int64_t value) { h5::put_attribute(ledger, name, value); };
  number("time", s.time);
  count("ball_ball", s.events.ball_ball);
  count("ball_wall", s.events.ball_wall);
  count("other", s.events.other);
  count("ties", s.events.ties);
  number("energy_initial", s.energy.initial);
  number("energy_final", s.energy.final);
  number("energy_dissipated", s.energy.dissipated);
  number("energy_injected", s.energy.injected);
  number("energy_relative_error", s.energy.relative_error);
  write_balance(ledger, "momentum", s.momentum);
  write_balance(ledger, "angular_momentum", s.angular_momentum);
  number("max_gap_error", s.exactness.max_gap_error);
  number("max_gap_error_relative", s.exactness.max_gap_error_relative);
  count("clamped", s.exactness.clamped);
  count("unresolved", s.exactness.unresolved);
  count("singular", s.exactness.singular);
}

}  // namespace

void write_h5md_group(const Id& file) {
  const Id h5md = h5::new_group(file, "h5md");
  constexpr std::array<std::int32_t, 2> version{1, 1};
  h5::put_attribute<std::int32_t>(h5md, "version", std::span(version));
  h5::put_text_attribute(h5::new_group(h5md, "author"), "name", author());
  const Id creator = h5::new_group(h5md, "creator");
  h5::put_text_attribute(creator, "name", std::string("carom"));
  h5::put_text_attribute(creator, "version", std::string(CAROM_VERSION));
}

void write_parameters(const Id& parameters, const TrajectoryHead& head, const Provenance& provenance) {
  h5::put_text(parameters, "title", head.title);
  if (!provenance.scene.empty()) h5::put_text(parameters, "scene", provenance.scene);
  std::string settings;
  for (const std::string& setting : provenance.settings) settings += setting + '\n';
  h5::put_text(parameters, "settings", settings);
  if (!provenance.converted_from.empty()) h5::put_text(parameters, "converted_from", provenance.converted_from);
  if (head.epoch_length != 0) h5::put_attribute(parameters, "epoch_length", head.epoch_length);
}

void write_ending(const Id& parameters, const Ending& ending) {
  if (!ending.stopped_by.empty()) h5::put_text_attribute(parameters, "stopped_by", ending.stopped_by);
  if (!ending.ledger) return;
  const Summary& s = *ending.ledger;
  h5::put_text_attribute(parameters, "composition", s.composition);
  h5::put_text_attribute(parameters, "precision", s.precision);
  h5::put_attribute(parameters, "seed", static_cast<std::int64_t>(s.seed));
  write_ledger(h5::new_group(parameters, "ledger"), s);
}

}  // namespace carom
