#include "compare_command.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include <fmt/core.h>

#include "carom/core/error.hpp"
#include "carom/core/rational.hpp"
#include "carom/observe/comparison.hpp"
#include "carom/sim/simulation.hpp"
#include "carom/write/comparison_csv.hpp"
#include "carom/write/comparison_report.hpp"
#include "carom/write/events_csv.hpp"
#include "carom/write/number_text.hpp"
#include "compare_plan.hpp"
#include "interrupt.hpp"
#include "output_folder.hpp"
#include "peak_memory.hpp"
#include "progress.hpp"
#include "run_to_the_end.hpp"

namespace carom::app {

namespace {

constexpr std::int64_t most_collisions = 10'000'000;    // of the exact run: its course is kept in memory, 2 GB of it
constexpr std::int64_t most_steps = 1'000'000'000'000;  // of a stepper

/// The files of --out.
struct Files {
  EventsCsv events;
  ComparisonCsv rows;
  PositionErrorCsv position_error;

  Files(const std::filesystem::path& folder, const Simulation& simulation, const std::string& title)
      : events((folder / "events.csv").string(), simulation, title),
        rows((folder / "rows.csv").string()),
        position_error((folder / "position_error.csv").string()) {}

  void finish(Stop stopped_by) {
    events.finish(stopped_by);
    rows.finish();
    position_error.finish();
  }
};

void spare_the_scene(const std::filesystem::path& folder, const std::string& scene) {
  std::error_code ignored;
  for (const char* name : {"events.csv", "rows.csv", "position_error.csv"})
    if (std::filesystem::equivalent(folder / name, scene, ignored))
      throw InputError(
          Problem{scene, 0, std::string("--out would overwrite the scene file with ") + name, "", "Choose another folder"});
}

/// Steps of length dt whose ends reach `end`, at least one.
std::int64_t steps_to(const Number& end, const Number& start, const Number& dt) {
  const Rational q = (exact(end) - exact(start)) / exact(dt);
  if (q > most_steps) {
    throw InputError(Problem{"", 0, "--dt " + number_text(dt) + ": that is " + number_text(nearest_double(q)) + " steps",
                             "10^12 are as many as are taken", "Give a longer step or an earlier --until"});
  }
  const auto whole = static_cast<std::int64_t>(numerator(q) / denominator(q));
  return std::max<std::int64_t>(1, Rational(whole) < q ? whole + 1 : whole);
}

void judge_length(const Scene& scene, const std::vector<PlannedRow>& rows) {
  if (scene.run.until) {
    for (const PlannedRow& row : rows) static_cast<void>(steps_to(*scene.run.until, scene.run.start, row.dt));
  } else {
    Simulation probe(scene);
    probe.advance(std::nullopt, 1);
    if (probe.counts().collisions() == 0)
      throw InputError(Problem{scene.file, scene.run.where.line, "nothing collides, and no end is given",
                               "without one, the last collision is the end", "Give --until"});
  }
}

class Comparing {
 public:
  Comparing(const CompareOptions& options, const Scene& scene, const std::vector<PlannedRow>& plan, const Console& console)
      : scene_(scene),
        plan_(plan),
        screen_(console.err_is_terminal ? &console.err : nullptr),
        simulation_(scene),
        course_(scene, simulation_),
        enclosures_(scene, course_.subject(), places()) {
    if (options.out.empty()) return;
    spare_the_scene(options.out, scene.file);
    make_folder(options.out);
    files_.emplace(options.out, simulation_, scene.title);
  }

  /// The exact run, to its end and then far enough for the last steps; false: there is nothing to compare with.
  bool run_exact() {
    Progress progress(screen_, scene_.run);
    Watchers watchers;
    watchers.interrupt = &interrupt_.flag();
    watchers.slice = [&] { progress.show(simulation_); };
    watchers.collision = [&](const Collision& c) {
      course_.add(c);
      if (files_) files_->events.write(c);
      if (simulation_.counts().collisions() >= most_collisions || (files_ && files_->events.failed()))
        interrupt_.flag() = true;
    };
    stop_ = run_to_the_end(simulation_, scene_.run, watchers);
    report_.exact.seconds = progress.seconds();
    report_.exact.summary = simulation_.summary();
    report_.exact.peak_memory_mb = peak_memory_mb();
    end_ = stop_ == Stop::events || !scene_.run.until ? Number(simulation_.time()) : *scene_.run.until;
    const bool ended = stop_ != Stop::collapse && stop_ != Stop::non_finite && !interrupted();
    if (ended) run_beyond();
    report_.interrupted = interrupted();
    return ended && !interrupted();
  }

  void run_rows() {
    for (const PlannedRow& planned : plan_) {
      if (!interrupted()) run_row(planned);
    }
    report_.interrupted = interrupted();
  }

  void finish() {
    if (files_) files_->finish(stop_);
  }

  [[nodiscard]] const ComparisonReport& report() const { return report_; }
  [[nodiscard]] int signal() const { return interrupt_.signal(); }
  [[nodiscard]] bool too_long() const { return interrupted() && signal() == 0; }
  [[nodiscard]] const std::vector<std::string>& left_out() const { return left_out_; }

 private:
  [[nodiscard]] bool interrupted() const { return interrupt_.flag().load(); }

  [[nodiscard]] std::vector<Triple> places() const {
    std::vector<Triple> list;
    for (const BallState& b : simulation_.balls()) {
      list.emplace_back();
      std::copy(b.position.begin(), b.position.end(), list.back().begin());
    }
    return list;
  }

  /// The last step of a row may end beyond the end of the run.
  void run_beyond() {
    double last = end_, longest = 0;
    for (const PlannedRow& row : plan_) {
      const auto n = static_cast<double>(steps_to(end_, scene_.run.start, row.dt));
      last = std::max(last, scene_.run.start + n * row.dt);
      longest = std::max(longest, row.dt.value);
    }
    const std::int64_t left = most_collisions - simulation_.counts().collisions();
    const Stop stop = simulation_.advance(
        Number(last + 2 * longest), left, [this](const Collision& c) { course_.add(c); }, &interrupt_.flag());
    if (stop != Stop::until && stop != Stop::no_events_left) reached_ = simulation_.time();
  }

  void run_row(const PlannedRow& planned) {
    ComparisonRow row{planned.method, planned.engine, planned.dt, {}};
    ComparisonSettings settings;
    settings.dt = planned.dt;
    settings.steps = steps_to(end_, scene_.run.start, planned.dt);
    while (settings.steps > 0 && scene_.run.start + static_cast<double>(settings.steps) * planned.dt > reached_)
      settings.steps = std::min(settings.steps - 1, static_cast<std::int64_t>((reached_ - scene_.run.start) / planned.dt));
    if (settings.steps == 0) {
      left_out_.push_back(fmt::format("{}, dt {}: the exact run ends at {}, before the first step does", row.name(),
                                      number_text(planned.dt), number_text(reached_)));
      return;
    }
    Progress progress(screen_, scene_.run);
    const std::string what = fmt::format("{}, dt {}", row.name(), number_text(planned.dt));
    settings.delay = planned.delay;
    settings.interrupt = &interrupt_.flag();
    settings.slice = [&](double share) { progress.show(what, share); };
    if (files_)
      settings.position_error = [&](double time, double error) { files_->position_error.write(row, time, error); };
    const std::unique_ptr<Stepper> stepper = planned.make(scene_);
    row.result = carom::compare(course_, enclosures_, *stepper, settings);
    if (row.result.interrupted) return;
    if (files_) files_->rows.write(row);
    report_.rows.push_back(std::move(row));
  }

  const Scene& scene_;
  const std::vector<PlannedRow>& plan_;
  std::ostream* screen_;
  Simulation simulation_;
  Course course_;
  Enclosures enclosures_;
  std::optional<Files> files_;
  Interrupt interrupt_;
  Stop stop_ = Stop::until;
  Number end_;
  double reached_ = std::numeric_limits<double>::infinity();  // [time] the course is known up to here
  ComparisonReport report_;
  std::vector<std::string> left_out_;
};

/// Reads the scene and the plan; all that is wrong with either is thrown at once.
Scene read_all(const CompareOptions& options, std::vector<PlannedRow>& plan) {
  std::vector<Problem> problems;
  plan = plan_comparison(options.dt, options.methods, options.engines, problems);
  Scene scene;
  try {
    scene = read_scene(options.scene);
    if (problems.empty()) Simulation{scene};
  } catch (const InputError& error) {
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
  }
  if (problems.empty()) problems = judge_comparison(scene, plan);
  if (!problems.empty()) throw InputError(std::move(problems));
  judge_length(scene, plan);
  return scene;
}

void print(const CompareOptions& options, const ComparisonReport& report, const Console& console) {
  console.out << (options.json ? comparison_json(report) : comparison_table(report, console.colour));
  console.out.flush();
  if (!console.out) throw OutputError("cannot write the result to standard output.");
}

/// What there is to say of a comparison that is not whole.
ExitStatus conclude(const Comparing& comparing, const Console& console) {
  const Summary& exact = comparing.report().exact.summary;
  for (const std::string& row : comparing.left_out()) console.err << "carom: left out: " << row << ".\n";
  if (exact.stopped) {
    console.err << fmt::format(
        "carom: the exact run stopped at time {}: {}. There is nothing to compare with. End the run before with --until.\n",
        number_text(exact.stopped->time), exact.stopped->reason);
    return ExitStatus::stopped;
  }
  if (comparing.too_long()) {
    console.err << fmt::format(
        "carom: the exact run has more than {} collisions, too many to keep, and has got to time {}. End it with "
        "--until.\n",
        most_collisions, number_text(exact.time));
    return ExitStatus::stopped;
  }
  if (comparing.signal() == 0) return ExitStatus::done;
  console.err << "carom: interrupted; " << comparing.report().rows.size() << " rows are finished.\n";
  return ended_by(comparing.signal());
}

}  // namespace

CLI::App* add_compare_command(CLI::App& program, CompareOptions& options) {
  CLI::App* command = program.add_subcommand("compare", "Says what a time step costs: fixed steps beside the exact run");
  add_scene_arguments(*command, options.scene);
  command->add_option("--dt", options.dt, "Time steps, with commas between them")->type_name("LIST")->required();
  command
      ->add_option("--method", options.methods,
                   "discrete, swept, speculative, penalty (default: all), with options as discrete:iterations=8")
      ->type_name("LIST");
  command
      ->add_option("--engine", options.engines, "Game engines: box2d, chipmunk, bullet, with options as box2d:continuous")
      ->type_name("LIST");
  command->add_option("--until", options.scene.until, "Ends at this time (default: the scene's end, or the last collision)")
      ->type_name("T");
  command->add_option("--out", options.out, "Folder for rows.csv, position_error.csv and the exact events.csv")
      ->type_name("DIR");
  command->add_flag("--json", options.json, "Prints one JSON object");
  command->footer(
      "Missed: collisions of the exact run that did not come (tunnelling). Spurious: that came and are not in the exact "
      "run.\n"
      "Swapped: out of a ball's order. Escaped: balls beyond a wall at the end. Parted at: the collision after which some\n"
      "ball is further than its radius from where it should be; beyond it averages are compared, not meetings.\n\n"
      "Example:\n  carom compare scene.toml --dt 1e-2,1e-3 --method discrete,swept --engine box2d\n\n"
      "Exit status: 3 if the exact run collapses; 130 on Ctrl-C, with the rows finished so far.");
  return command;
}

ExitStatus compare(const CompareOptions& options, const Console& console) {
  std::vector<PlannedRow> plan;
  const Scene scene = read_all(options, plan);
  Comparing comparing(options, scene, plan, console);
  if (comparing.run_exact()) comparing.run_rows();
  print(options, comparing.report(), console);
  comparing.finish();
  return conclude(comparing, console);
}

}  // namespace carom::app
