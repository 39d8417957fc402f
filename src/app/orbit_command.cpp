#include "orbit_command.hpp"

#include <cmath>

#include <fmt/core.h>

#include "carom/observe/periodic_orbit.hpp"
#include "carom/write/number_text.hpp"
#include "write/json_text.hpp"

namespace carom::app {

namespace {

/// In double the digits beyond are left out.
class Shown {
 public:
  explicit Shown(bool in_double) : in_double_(in_double) {}

  [[nodiscard]] Number operator()(const Number& x) const { return in_double_ ? Number(x.value) : x; }
  [[nodiscard]] std::string text(const Number& x) const {
    std::string s;
    append_number(s, (*this)(x));
    return s;
  }
  template <class Numbers>
  [[nodiscard]] Json list(const Numbers& numbers) const {
    Json j = Json::array();
    for (const Number& x : numbers) j.push_back((*this)(x));
    return j;
  }
  template <class Numbers>
  [[nodiscard]] std::string vector(const Numbers& numbers, const char* open = "[", const char* close = "]") const {
    std::string s;
    for (const Number& x : numbers) s += (s.empty() ? open : ", ") + text(x);
    return s + close;
  }

 private:
  bool in_double_;
};

/// KEY=VALUE for --set: the scene on its orbit.
std::vector<std::string> settings(const PeriodicOrbit& orbit, const Shown& shown) {
  std::vector<std::string> list;
  for (const BallState& b : orbit.start) {
    list.push_back(fmt::format("ball.{}.position={}", b.index, shown.vector(b.position)));
    list.push_back(fmt::format("ball.{}.velocity={}", b.index, shown.vector(b.velocity)));
  }
  return list;
}

/// Who is hit: as in an event log.
std::string partner_of(const OrbitPoint& p, const Simulation& simulation) {
  return p.kind == EventKind::ball_ball ? "ball " + std::to_string(p.partner) : "wall " + simulation.wall_label(p.partner);
}

Json object(const PeriodicOrbit& o, const Scene& scene, const Simulation& simulation, const Shown& shown) {
  Json start = Json::array(), points = Json::array(), multipliers = Json::array();
  for (std::size_t b = 0; b < o.start.size(); ++b)
    start.push_back({{"index", o.start[b].index}, {"name", o.start[b].name}, {"position", shown.list(o.start[b].position)},
                     {"velocity", shown.list(o.start[b].velocity)}, {"shift", o.shift[b]}});
  for (const OrbitPoint& p : o.points) {
    Json j{{"time", shown(p.time)}, {"ball", p.ball}, {"partner", partner_of(p, simulation)}, {"feature", p.feature},
           {"position", shown.list(p.position)}};
    if (p.kind == EventKind::ball_ball) j.erase("feature");
    points.push_back(std::move(j));
  }
  for (const Multiplier& m : o.multipliers) multipliers.push_back({{"real", shown(m.real)}, {"imaginary", shown(m.imaginary)}});
  const Json length = std::isfinite(o.length.value) ? Json(shown(o.length)) : Json(nullptr);
  return {{"title", scene.title}, {"collisions", o.points.size()}, {"prime_collisions", o.prime}, {"period", shown(o.period)},
          {"length", length}, {"residual", o.residual.value}, {"kind", word(o.kind)}, {"trace", shown(o.trace)},
          {"multipliers", multipliers}, {"start", start}, {"points", points}, {"set", settings(o, shown)},
          {"iterations", o.iterations}, {"arithmetic", o.arithmetic}};
}

std::string multiplier_text(const Multiplier& m, const Shown& shown) {
  if (m.imaginary.value == 0) return shown.text(m.real);
  const std::string imaginary = shown.text(m.imaginary);
  return shown.text(m.real) + (imaginary.starts_with('-') ? " - " + imaginary.substr(1) : " + " + imaginary) + " i";
}

void print(std::ostream& out, const PeriodicOrbit& o, const Scene& scene, const Simulation& simulation, const Shown& shown) {
  if (!scene.title.empty()) out << scene.title << "\n\n";
  const auto row = [&out](const char* label, const std::string& value) { out << fmt::format("  {:<12}{}\n", label, value); };
  const auto n = static_cast<std::int64_t>(o.points.size());
  row("collisions", o.prime == n ? std::to_string(n) : fmt::format("{}: {} times an orbit of {}", n, n / o.prime, o.prime));
  row("period", shown.text(o.period));
  if (std::isfinite(o.length.value)) row("length", shown.text(o.length));
  row("closes to", fmt::format("{:.2g}", o.residual.value));
  row("kind", std::string(word(o.kind)));
  row("trace", shown.text(o.trace));
  for (std::size_t i = 0; i < o.multipliers.size(); ++i)
    row(i == 0 ? "multipliers" : "", multiplier_text(o.multipliers[i], shown));
  for (std::size_t b = 0; b < o.shift.size(); ++b) {
    std::string shift;
    bool any = false;
    for (const std::int64_t k : o.shift[b]) {
      shift += (shift.empty() ? "(" : ", ") + std::to_string(k);
      any = any || k != 0;
    }
    if (any) row("goes on by", fmt::format("{}) periods of the space, ball {}", shift, o.start[b].index));
  }
  out << '\n';
  for (const OrbitPoint& p : o.points)
    out << fmt::format("  {}  ball {} at {}, time {}\n", partner_of(p, simulation), p.ball, shown.vector(p.position, "(", ")"),
                       shown.text(p.time));
  out << '\n';
  for (const std::string& set : settings(o, shown)) out << "  --set '" << set << "'\n";
}

}  // namespace

CLI::App* add_orbit_command(CLI::App& program, OrbitOptions& options) {
  CLI::App* command = program.add_subcommand("orbit", "Refines an approximate periodic orbit, and says how stable it is");
  add_scene_arguments(*command, options.scene);
  command->add_option("--period", options.period, "Collisions after which the start comes back")->type_name("N")->required();
  command->add_option("--precision", options.precision, "Of the result: double, or decimal digits, as 50")->type_name("P");
  command->add_flag("--json", options.json, "Prints one JSON object");
  command->footer(
      "Example:\n  carom orbit pinball.toml --period 3 --precision 50\n\n"
      "The start of the scene is the guess: the orbit has its energy and its sequence of walls. The settings at the end put\n"
      "the scene on the orbit. Exit status 3: there is no such orbit near it.");
  return command;
}

ExitStatus orbit(const OrbitOptions& options, const Console& console) {
  const Precision precision = parse_precision(options.precision);
  const Scene scene = read_scene(options.scene);
  const Simulation simulation(scene);
  try {
    const PeriodicOrbit found = refine_orbit(scene, options.period, precision);
    const Shown shown(precision.kind != Precision::Kind::decimal);
    if (options.json) {
      console.out << json_text(object(found, scene, simulation, shown));
    } else {
      print(console.out, found, scene, simulation, shown);
    }
  } catch (const OrbitError& error) {
    console.err << "carom: " << error.what() << ".\n";
    return ExitStatus::stopped;
  }
  return ExitStatus::done;
}

}  // namespace carom::app
