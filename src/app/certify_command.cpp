#include "certify_command.hpp"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>

#include <fmt/core.h>

#include "carom/certify/certify.hpp"
#include "carom/core/error.hpp"
#include "carom/core/precision.hpp"
#include "carom/write/number_text.hpp"
#include "carom/write/output_file.hpp"
#include "interrupt.hpp"
#include "output_folder.hpp"
#include "progress.hpp"
#include "write/json_text.hpp"

namespace carom::app {

namespace {

using certify::AgainstDouble;
using certify::Bounds;
using certify::Mark;
using certify::Report;
using certify::Verdict;

const char* word(Verdict v) {
  switch (v) {
    case Verdict::proven: return "proven";
    case Verdict::undecided: return "undecided";
    case Verdict::refuted: return "refuted";
    case Verdict::interrupted: return "interrupted";
  }
  return "";
}

Json as_json(const Bounds& b) { return {{"lower", b.lower}, {"upper", b.upper}}; }
Json as_json(const std::vector<Bounds>& list) {
  Json all = Json::array();
  for (const Bounds& b : list) all.push_back(as_json(b));
  return all;
}
Json as_json(const std::optional<Mark>& m) { return m ? Json{{"event", m->event}, {"time", m->time}} : Json(nullptr); }

Json as_json(const Report& r, double seconds) {
  Json j{{"verdict", word(r.verdict)},
         {"events", r.events},
         {"end", as_json(r.end)},
         {"stopped_by", r.stopped_by},
         {"digits", r.digits},
         {"tries", r.tries},
         {"certain_digits", r.certain_digits},
         {"state_digits", r.state_digits},
         {"digits_per_event", r.digits_per_event},
         {"undecided", nullptr},
         {"against_double", nullptr},
         {"final", Json::array()},
         {"seconds", seconds}};
  if (r.at_event > 0) j["undecided"] = {{"event", r.at_event}, {"reason", r.what}, {"log10_width", r.log10_width}, {"tie", r.tie}};
  if (r.against_double) {
    const AgainstDouble& d = *r.against_double;
    j["against_double"] = {{"compared", d.compared}, {"length", d.length}, {"position_error", d.largest_error}, {"off", as_json(d.off)}, {"different", as_json(d.different)}};
  }
  for (const certify::BallBounds& b : r.final)
    j["final"].push_back({{"index", b.index}, {"position", as_json(b.position)}, {"velocity", as_json(b.velocity)}});
  return j;
}

std::string at(const Mark& m) { return fmt::format("collision {}, time {}", m.event, number_text(m.time)); }

/// A time for people: no more digits than anyone reads.
std::string brief(const Bounds& b) {
  constexpr std::size_t most = 40;
  std::size_t same = 0;
  while (same < b.lower.size() && same < b.upper.size() && b.lower[same] == b.upper[same]) ++same;
  return same == b.lower.size() || same > most ? b.lower.substr(0, std::min(same, most)) + (same > most ? "..." : "") : fmt::format("{} .. {}", b.lower, b.upper);
}

void print(std::ostream& out, const Report& r, double seconds, bool verified) {
  const auto row = [&out](const char* label, const std::string& value) { out << fmt::format("  {:<16}{}\n", label, value); };
  row(verified ? "verified" : "proven", fmt::format("{} events, in this order, and no other up to time {}", r.events, brief(r.end)));
  row("certain digits", fmt::format("{:.0f} of the last time, {:.0f} of positions and velocities", std::floor(r.certain_digits), std::floor(r.state_digits)));
  row("digits lost", fmt::format("{:.3g} an event", r.digits_per_event));
  row("computed in", fmt::format("{} digits, {} {}", r.digits, r.tries, r.tries == 1 ? "try" : "tries"));
  if (r.against_double) {
    const AgainstDouble& d = *r.against_double;
    row("double", d.different ? "a ball meets somebody else at " + at(*d.different)
                              : fmt::format("every ball meets whom it should in the first {} collisions", d.compared));
    row("", d.off ? fmt::format("positions wrong by 1 % of {:.3g} at {}", d.length, at(*d.off))
                  : fmt::format("positions wrong by {:.2g} at most", d.largest_error));
  }
  row("took", fmt::format("{:.3g} s", seconds));
  out << std::flush;
}

std::string complaint(const Report& r, bool verified) {
  const std::string where = fmt::format("event {}: {}", r.at_event, r.what);
  if (r.tie)
    return where + ": a tie, exactly: mechanics does not say which comes first. Remedy: move a ball by a little";
  if (r.verdict == Verdict::refuted)
    return where + (verified ? ": the certificate is wrong" : ": the log of the simulation is wrong: this is a bug in carom");
  return fmt::format("{}: undecided in {} digits, where it is known to 1e{:.0f}. Remedy: --max-digits", where, r.digits, r.log10_width);
}

ExitStatus finish(const Report& r, const CertifyOptions& options, const Console& console, double seconds, int signal) {
  const bool verified = !options.verify.empty();
  if (options.json) {
    console.out << json_text(as_json(r, seconds));
  } else {
    print(console.out, r, seconds, verified);
  }
  if (r.verdict == Verdict::interrupted) return ended_by(signal);
  if (r.verdict != Verdict::proven) {
    console.err << "carom: " << complaint(r, verified) << "\n";
    return ExitStatus::stopped;
  }
  const bool ended = r.stopped_by == "until" || r.stopped_by == "events" || r.stopped_by == "no_events_left";
  if (!ended) console.err << "carom: the run stopped: " << r.stopped_by << "\n";
  return ended ? ExitStatus::done : ExitStatus::stopped;
}

class CertificateFile {
 public:
  explicit CertificateFile(std::string path) : path_(std::move(path)) {}

  std::ostream& empty() {
    file_ = std::ofstream(path_, std::ios::binary | std::ios::trunc);
    require();
    return file_;
  }
  void close() {
    file_.close();
    require();
  }

 private:
  void require() const {
    if (!file_) throw OutputError("cannot write \"" + path_ + "\". Choose another --out.");
  }

  std::string path_;
  std::ofstream file_;
};

}  // namespace

CLI::App* add_certify_command(CLI::App& program, CertifyOptions& options) {
  CLI::App* command = program.add_subcommand("certify", "Proves the events of a scene, their order and their times");
  add_scene_arguments(*command, options.scene);
  command->get_option("SCENE")->required(false);
  command->add_option("--until", options.scene.until, "Ends at this time, events at it included")->type_name("T");
  command->add_option("--events", options.scene.events, "Ends after so many collisions")->type_name("N");
  command->add_option("--digits", options.digits, "Decimal digits of the first try (default 50)")
      ->type_name("D")
      ->check(CLI::Range(Precision::least_digits, Precision::most_digits));
  command->add_option("--max-digits", options.max_digits, "Of the last; each try has twice as many as the one before (default 12800)")
      ->type_name("D")
      ->check(CLI::Range(Precision::least_digits, Precision::most_digits));
  command->add_option("--out", options.out, "Folder for certified.csv, made if it is not there (default: the current one)")->type_name("DIR");
  command->add_option("--verify", options.verify, "Checks this certificate instead, without a simulation")->type_name("FILE");
  command->add_flag("--json", options.json, "Prints one JSON object");
  command->footer(
      "The simulator's log is replayed in interval arithmetic: every event happens when it says, and nothing else does.\n"
      "certified.csv holds the scene in exact numbers and each event with an interval that its time lies in.\n\n"
      "Example:\n  carom certify scene.toml --events 100\n  carom certify --verify certified.csv\n\n"
      "Exit status: 3 if not all of it could be proven.");
  return command;
}

ExitStatus certify(const CertifyOptions& options, const Console& console) {
  const certify::Options how{options.digits, options.max_digits};
  if (options.scene.file.empty() && options.verify.empty())
    throw InputError(Problem{"", 0, "certify needs a SCENE, or --verify FILE", "", "See carom certify --help"});
  std::optional<Scene> scene;
  if (!options.scene.file.empty()) scene = read_scene(options.scene);
  Interrupt interrupt;
  const RunSpec run = scene ? scene->run : RunSpec{};
  Progress progress(console.err_is_terminal ? &console.err : nullptr, run);
  certify::Watch watch;
  watch.interrupt = &interrupt.flag();
  watch.progress = [&](std::int64_t events, int digits) {
    const double share = run.events ? static_cast<double>(events) / static_cast<double>(*run.events) : 0.0;
    progress.show(fmt::format("{} events in {} digits", events, digits), share);
  };
  if (!options.verify.empty()) {
    std::ifstream file(options.verify, std::ios::binary);
    if (!file) throw InputError(Problem{options.verify, 0, "cannot read the certificate", "", "Give a file that carom certify wrote"});
    const Report report = certify::verify(file, how, watch, scene ? &*scene : nullptr);
    return finish(report, options, console, progress.seconds(), interrupt.signal());
  }
  if (!options.out.empty()) make_folder(options.out);
  CertificateFile file((std::filesystem::path(options.out) / "certified.csv").string());
  watch.certificate = [&file]() -> std::ostream& { return file.empty(); };
  const Report report = certify::prove(*scene, how, watch);
  file.close();
  return finish(report, options, console, progress.seconds(), interrupt.signal());
}

}  // namespace carom::app
