#include "check_command.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>

#include <fmt/core.h>

#include "carom/observe/horizon.hpp"
#include "carom/observe/parting.hpp"
#include "carom/scene/growing.hpp"
#include "carom/sim/simulation.hpp"
#include "carom/write/number_text.hpp"
#include "carom/write/summary_json.hpp"
#include "interrupt.hpp"
#include "write/json_text.hpp"

namespace carom::app {

namespace {

/// A running fingerprint of a log: every bit of every collision, in order (FNV-1a over 64-bit words).
class LogPrint {
 public:
  void add(const Collision& c) {
    word(static_cast<std::uint64_t>(c.epoch));
    number(c.offset);
    word(static_cast<std::uint64_t>(c.kind));
    word(static_cast<std::uint64_t>(c.feature));
    party(c.ball);
    party(c.partner);
    number(c.impulse);
    ++events_;
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }
  [[nodiscard]] std::int64_t events() const { return events_; }

 private:
  void word(std::uint64_t w) { value_ = (value_ ^ w) * 0x100000001b3u; }
  void number(double x) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    word(bits);
  }
  void party(const Collision::Party& p) {
    word(p.number);
    for (std::size_t k = 0; k < 3; ++k) {
      number(p.position[k]);
      word(static_cast<std::uint64_t>(p.image[k]));
      number(p.velocity_after[k]);
    }
  }

  std::uint64_t value_ = 0xcbf29ce484222325u;
  std::int64_t events_ = 0;
};

struct Findings {
  Summary summary;
  Audit audit;  ///< the deepest of all, and the sum of the overlaps
  std::int64_t audits = 0;
  std::string reference;  ///< composition of the second run
  bool same_log = false;
  std::optional<double> echo;  ///< largest distance from the start [length]; none where time has no mirror
  std::string no_echo;         ///< why none
  std::optional<Horizon> horizon;
  std::string no_horizon;  ///< why none
  bool rules_compared = false;
  std::optional<HorizonMark> rules_differ;  ///< first collision after which the rules for simultaneous contacts differ
  bool interrupted = false;
};

class Check {
 public:
  Check(const CheckOptions& options, const Scene& scene, const std::atomic<bool>& interrupt)
      : options_(options), scene_(scene), interrupt_(interrupt) {}

  Findings operator()() {
    Simulation simulation(scene_);
    const std::vector<BallState> start = simulation.balls();
    const LogPrint log = run_and_audit(simulation);
    found_.summary = simulation.summary();
    if (!interrupted()) compare_log(log);
    if (!interrupted()) run_back(simulation, start);
    if (!interrupted()) look_for_horizon();
    // Balls come to rest, and grow, with contacts one by one.
    if (!interrupted() && scene_.collision.regularise != Regularise::rest && !balls_grow(scene_)) compare_rules();
    found_.interrupted = interrupted();
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool interrupted() const { return interrupt_.load(); }

  void audit(const Simulation& simulation) {
    const Audit a = simulation.audit();
    ++found_.audits;
    const std::int64_t sum = found_.audit.overlaps + a.overlaps;
    if (a.deepest > found_.audit.deepest) found_.audit = a;
    found_.audit.overlaps = sum;
  }

  /// Audits at even numbers of collisions: a first run counts them, cheaply, where the scene does not say how many there
  /// are.
  LogPrint run_and_audit(Simulation& simulation) {
    std::int64_t total = scene_.run.events.value_or(0);
    if (!scene_.run.events || scene_.run.until) {
      Simulation counting(scene_);
      counting.advance(scene_.run.until, scene_.run.events, {}, &interrupt_);
      total = counting.counts().collisions();
    }
    const std::int64_t step = std::max<std::int64_t>(1, total / std::max<std::int64_t>(1, options_.audits));
    LogPrint log;
    audit(simulation);
    while (!interrupted()) {
      const std::int64_t left = scene_.run.events ? *scene_.run.events - simulation.counts().collisions()
                                                  : std::numeric_limits<std::int64_t>::max();
      const Stop stop = simulation.advance(
          scene_.run.until, std::min(step, left), [&](const Collision& c) { log.add(c); }, &interrupt_);
      const bool last = stop != Stop::events || left <= step;
      // A merged ball may overlap others until, at the same instant, they merge too: look when all is done.
      if (scene_.collision.law != LawKind::merge || last) audit(simulation);
      if (last) break;
    }
    return log;
  }

  void compare_log(const LogPrint& log) {
    Simulation other = Simulation::reference(scene_);
    found_.reference = other.composition().text();
    LogPrint again;
    other.advance(
        scene_.run.until, scene_.run.events, [&](const Collision& c) { again.add(c); }, &interrupt_);
    found_.same_log = again.value() == log.value() && again.events() == log.events();
  }

  void run_back(Simulation& simulation, const std::vector<BallState>& start) {
    found_.no_echo = why_no_echo();
    if (!found_.no_echo.empty()) return;
    const double begin = scene_.run.start;
    const double end = simulation.time();
    simulation.reverse();
    simulation.advance(Number(end + (end - begin)), std::nullopt, {}, &interrupt_);
    double largest = 0;
    for (const BallState& before : start) {
      const BallState after = simulation.ball(before.index);
      double square = 0;
      for (std::size_t k = 0; k < before.unwrapped_position.size(); ++k)
        square += std::pow(after.unwrapped_position[k] - before.unwrapped_position[k], 2);
      largest = std::max(largest, std::sqrt(square));
    }
    found_.echo = largest;
  }

  /// Where contacts are simultaneous the laws of impact leave the outcome open: does the rule matter here?
  void compare_rules() {
    if (found_.summary.events.ties == 0 || scene_.collision.law != LawKind::restitution) return;
    Scene other = scene_;
    other.collision.simultaneous = scene_.collision.simultaneous == Simultaneous::sequential ? Simultaneous::symmetric
                                                                                             : Simultaneous::sequential;
    found_.rules_compared = true;
    found_.rules_differ = first_parting(scene_, other, &interrupt_);
  }

  void look_for_horizon() {
    found_.no_horizon = why_no_horizon();
    if (!found_.no_horizon.empty()) return;
    HorizonOptions options;
    options.collisions = options_.horizon;
    found_.horizon = find_horizon(scene_, options, &interrupt_);
  }

  [[nodiscard]] std::string why_no_horizon() const {
    if (options_.horizon <= 0) return "not asked for";
    if (balls_grow(scene_)) return "balls grow in double only, so there is no run in high precision";
    const Coordinates& a = scene_.motion.acceleration;
    const bool pulled = std::any_of(a.begin(), a.end(), [](const Number& x) { return x != 0; });
    if (pulled && scene_.collision.regularise == Regularise::rest)
      return "balls come to rest (collision.regularise = \"rest\") in double only, so there is no run in high precision";
    return "";
  }

  [[nodiscard]] std::string why_no_echo() const {
    if (scene_.collision.law != LawKind::restitution) return "the law joins balls for good";
    if (found_.summary.energy.dissipated != 0) return "impacts dissipate";
    if (balls_grow(scene_)) return "balls grow";
    for (const WallSpec& w : scene_.walls) {
      if (w.oscillation) return "a wall swings";
      for (const Number& v : w.velocity)
        if (v != 0) return "a wall moves";
    }
    if (found_.summary.stopped) return "the run stopped early";
    return "";
  }

  const CheckOptions& options_;
  const Scene& scene_;
  const std::atomic<bool>& interrupt_;
  Findings found_;
};

Json as_json(const std::optional<HorizonMark>& mark) {
  return mark ? Json{{"event", mark->event}, {"time", mark->time}} : Json(nullptr);
}

Json as_json(const Horizon& h) {
  const auto or_null = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  return {{"event", h.partner ? Json(h.partner->event) : Json(nullptr)},
          {"time", h.partner ? Json(h.partner->time) : Json(nullptr)},
          {"digits_per_collision", or_null(h.digits_per_collision)},
          {"digits_lost", or_null(h.digits_lost)},
          {"compared", h.compared},
          {"precision", h.digits},
          {"order", as_json(h.order)},
          {"length", h.length},
          {"percent", as_json(h.percent)},
          {"radius", as_json(h.radius)},
          {"position_error", h.largest_error},
          {"input", as_json(h.input)},
          {"input_error", h.input_error}};
}

Json as_json(const Findings& f) {
  Json echo = f.echo ? Json(*f.echo) : Json(nullptr);
  return {{"title", f.summary.title},
          {"events", f.summary.events.collisions()},
          {"time", f.summary.time},
          {"energy", f.summary.energy.relative_error},
          {"momentum", f.summary.momentum.relative_error ? Json(*f.summary.momentum.relative_error) : Json(nullptr)},
          {"audit",
           {{"audits", f.audits},
            {"overlaps", f.audit.overlaps},
            {"deepest", f.audit.deepest},
            {"deepest_relative", f.audit.deepest_relative}}},
          {"clamped", f.summary.exactness.clamped},
          {"composition", f.summary.composition},
          {"reference", f.reference},
          {"same_log", f.same_log},
          {"echo_error", echo},
          {"simultaneous",
           {{"ties", f.summary.events.ties},
            {"compared", f.rules_compared},
            {"rules_differ", f.rules_differ ? as_json(f.rules_differ) : Json(nullptr)}}},
          {"horizon", f.horizon ? as_json(*f.horizon) : Json(nullptr)},
          {"no_horizon", f.no_horizon.empty() ? Json(nullptr) : Json(f.no_horizon)}};
}

std::string at(const HorizonMark& m) { return fmt::format("collision {}, time {}", m.event, number_text(m.time)); }

void print(std::ostream& out, const Horizon& h, const std::function<void(const char*, const std::string&)>& row) {
  const std::string compared = fmt::format("the first {} collisions beside {} digits from the same doubles", h.compared, h.digits);
  row("horizon", h.partner ? "a ball meets somebody else at " + at(*h.partner) : "every ball meets whom it should in " + compared);
  if (h.partner) row("", compared);
  if (h.order) row("", "another order first at " + at(*h.order));
  const std::string size = fmt::format("{:.3g}", h.length);
  if (h.percent) row("", fmt::format("positions wrong by 1 % of {} at {}", size, at(*h.percent)));
  if (h.radius) row("", fmt::format("positions wrong by {} at {}", size, at(*h.radius)));
  if (!h.percent) row("", fmt::format("positions wrong by {:.2g} at most", h.largest_error));
  if (h.digits_lost)
    row("", fmt::format("a small error grows by {:.1f} digits, {:.2g} a collision", *h.digits_lost, *h.digits_per_collision));
  row("", h.input ? fmt::format("rounding the scene's numbers alone: wrong by 1 % of {} at {}", size, at(*h.input))
                  : fmt::format("rounding the scene's numbers alone: wrong by {:.2g} at most", h.input_error));
  out << std::flush;
}

void print(std::ostream& out, const Findings& f) {
  const auto row = [&out](const char* label, const std::string& value) {
    out << fmt::format("  {:<16}{}\n", label, value);
  };
  row("run", fmt::format("{} collisions to time {}", f.summary.events.collisions(), number_text(f.summary.time)));
  row("energy error", fmt::format("{:.2g} of the largest energy in play", f.summary.energy.relative_error));
  if (f.summary.momentum.relative_error)
    row("momentum error", fmt::format("{:.2g} of the sum of all momenta", *f.summary.momentum.relative_error));
  row("audit", fmt::format("{} overlaps in {} full audits; the deepest {:.2g}, {:.2g} of the radii", f.audit.overlaps,
                           f.audits, f.audit.deepest, f.audit.deepest_relative));
  row("clamped", fmt::format("{} events found in the past", f.summary.exactness.clamped));
  row("same log",
      fmt::format("{}: {} against {}", f.same_log ? "yes, bit for bit" : "NO", f.summary.composition, f.reference));
  if (f.horizon) print(out, *f.horizon, row);
  if (!f.no_horizon.empty()) row("horizon", "none: " + f.no_horizon);
  if (f.rules_compared)
    row("simultaneous",
        f.rules_differ ? fmt::format("{} ties; here physics is not unique: the rules sequential and symmetric part after {}",
                                     f.summary.events.ties, at(*f.rules_differ))
                       : fmt::format("{} ties; the rules sequential and symmetric agree", f.summary.events.ties));
  row("echo error", f.echo ? fmt::format("{:.2g} from the start after running back", *f.echo) : "none: " + f.no_echo);
  out << "\n  A large echo error is no error of the run: it is how far chaos has amplified the rounding on the way there "
         "and back.\n";
}

}  // namespace

CLI::App* add_check_command(CLI::App& program, CheckOptions& options) {
  CLI::App* command = program.add_subcommand("check", "Says how far the run of a scene can be believed");
  add_scene_arguments(*command, options.scene);
  command->add_option("--until", options.scene.until, "Ends at this time, events at it included")->type_name("T");
  command->add_option("--events", options.scene.events, "Ends after so many collisions")->type_name("N");
  command->add_option("--audits", options.audits, "Full overlap audits along the run (default 100)")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 40));
  command->add_option("--horizon", options.horizon, "Collisions compared with high precision at most; 0: none (default 20000)")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1} << 40));
  command->add_flag("--json", options.json, "Prints one JSON object");
  command->footer(
      "Conservation, a full audit for overlaps, the same log from another queue and search, the horizon: the first collision\n"
      "that a run in high precision has otherwise, and the echo: all velocities turned round at the end, run back, distance\n"
      "from the start.\n\n"
      "Example:\n  carom check scene.toml --events 10000\n\n"
      "Exit status: 3 if overlaps are found or the logs differ.");
  return command;
}

ExitStatus check(const CheckOptions& options, const Console& console) {
  const Scene scene = read_scene(options.scene);
  Interrupt interrupt;
  const Findings f = Check(options, scene, interrupt.flag())();
  if (f.interrupted) {
    console.err << "carom: check was interrupted; it has no result.\n";
    return ended_by(interrupt.signal());
  }
  if (options.json) {
    console.out << json_text(as_json(f));
  } else {
    print(console.out, f);
  }
  if (f.summary.stopped) {
    console.err << "carom: the run stopped: " << f.summary.stopped->reason << "\n";
    return ExitStatus::stopped;
  }
  if (f.audit.overlaps > 0) console.err << "carom: balls overlap by more than rounding: this is a bug in carom.\n";
  if (!f.same_log) console.err << "carom: two engines disagree on the events: this is a bug in carom.\n";
  return f.audit.overlaps > 0 || !f.same_log ? ExitStatus::stopped : ExitStatus::done;
}

}  // namespace carom::app
