#include "view_command.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <system_error>

#include <fmt/core.h>

#include "carom/core/error.hpp"
#include "carom/observe/course.hpp"
#include "carom/observe/observers.hpp"
#include "carom/observe/survival.hpp"
#include "carom/observe/samplers.hpp"
#include "carom/sim/simulation.hpp"
#include "carom/write/replay_log.hpp"
#include "carom/write/run_report.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "run_record.hpp"
#include "run_to_the_end.hpp"
#include "view_page.hpp"
#include "view_picture.hpp"
#include "view_scene.hpp"
#include "view_steps.hpp"
#include "view_tables.hpp"
#include "write/replay_scene.hpp"
#include "write/summary_object.hpp"

namespace carom::app {

namespace fs = std::filesystem;

namespace {

struct Viewed {
  Scene scene;
  RunRecord record;
  std::string folder;  ///< that was named; empty: it was a file
};

/// A scene file; or a folder, with the record of a run or a scene.toml.
Viewed viewed(SceneArguments arguments) {
  std::error_code ignored;
  Viewed v;
  if (fs::is_directory(arguments.file, ignored)) {
    v.folder = arguments.file;
    if (auto record = read_run_record(v.folder)) {
      const RunRecord over = record_of({"", arguments.set, arguments.until, arguments.events});
      record->set.insert(record->set.end(), over.set.begin(), over.set.end());
      return {read_scene(*record), *record, v.folder};
    }
    arguments.file = (fs::path(v.folder) / "scene.toml").string();
    if (!fs::exists(arguments.file, ignored))
      throw InputError(Problem{"", 0, "there is neither a run.json nor a scene.toml in the folder \"" + v.folder + '"',
                               "a page is made from the scene of a run", "Name the scene file itself"});
  }
  v.scene = read_scene(arguments);
  v.record = record_of(arguments);
  return v;
}

/// break_shot.html for break_shot.toml and for break_shot/scene.toml.
std::string page_of(const std::string& scene) {
  const fs::path path = fs::absolute(scene).lexically_normal();
  std::string name = path.stem().string();
  if (name == "scene" && path.parent_path().has_filename()) name = path.parent_path().filename().string();
  return name + ".html";
}

/// A run on its way to a page.
class Viewing {
 public:
  Viewing(const ViewOptions& options, const Viewed& what, std::optional<PlannedRow> steps, const std::string& path)
      : options_(options),
        scene_(what.scene),
        steps_(std::move(steps)),
        simulation_(scene_),
        observers_(scene_, simulation_),
        samplers_(scene_, simulation_),
        survival_(scene_, simulation_),
        page_(path, *page_parts(), scene_.dimension),
        log_(scene_, simulation_, [this](std::string chunk) { take(std::move(chunk)); }) {
    if (steps_) course_.emplace(scene_, simulation_);
    head_ = scene_of_page(scene_, simulation_, log_, what.record);
    start_ = replay_start(scene_, simulation_);
    page_.json("scene", head_);
    page_.bytes("start", start_);
  }

  void run(std::ostream* screen) {
    Progress progress(screen, scene_.run);
    Watchers watchers;
    watchers.interrupt = &interrupt_.flag();
    watchers.slice = [&] { progress.show(simulation_); };
    watchers.collision = [this](const Collision& c) { add(c); };
    if (samplers_.any()) watchers.samplers = &samplers_;
    run_to_the_end(simulation_, scene_.run, watchers);
    log_.flush();
    report_.seconds = progress.seconds();
    observers_.end(simulation_);
    report_.observed = observers_.estimates();
    for (Estimate& e : samplers_.estimates()) report_.observed.push_back(std::move(e));
    for (Estimate& e : survival_.estimates(simulation_)) report_.observed.push_back(std::move(e));
    report_.summary = simulation_.summary();
    if (steps_ && !interrupted()) {
      const ViewSteps film = make_view_steps(scene_, *steps_, *course_, simulation_.time(), event_of_, interrupt_.flag());
      page_.json("steps-head", film.head);
      page_.bytes("steps", film.places);
    }
  }

  void finish(Json tables) {
    if (const auto speeds = observers_.speed_table()) tables.push_back(table_of(*speeds));
    for (const Table& table : samplers_.tables()) tables.push_back(table_of(table));
    for (const Table& table : observers_.tables()) tables.push_back(table_of(table));
    for (const Table& table : survival_.tables(simulation_)) tables.push_back(table_of(table));
    page_.json(
        "result",
        {{"summary", summary_object(report_)}, {"cut", cut_ ? Json(options_.most) : Json(nullptr)}, {"tables", tables}});
    page_.finish();
  }

  [[nodiscard]] std::string picture() const { return picture_of(head_, start_, first_chunk_, report_.summary.time); }

  [[nodiscard]] bool cut() const noexcept { return cut_; }
  [[nodiscard]] const Summary& summary() const noexcept { return report_.summary; }
  [[nodiscard]] int signal() const { return interrupt_.signal(); }
  [[nodiscard]] std::int64_t events() const noexcept { return log_.events(); }

 private:
  [[nodiscard]] bool interrupted() const { return interrupt_.flag().load(); }

  void take(std::string chunk) {
    page_.chunk(chunk);
    if (first_chunk_.empty()) first_chunk_ = std::move(chunk);
  }

  void add(const Collision& c) {
    observers_.collision(c);
    log_.add(c);
    if (course_) {
      course_->add(c);
      event_of_.push_back(log_.events() - 1);
    }
    cut_ = simulation_.counts().collisions() >= options_.most && simulation_.counts().collisions() < wanted();
    if (cut_ || page_.failed()) interrupt_.flag() = true;
  }
  [[nodiscard]] std::int64_t wanted() const { return scene_.run.events.value_or(std::numeric_limits<std::int64_t>::max()); }

  const ViewOptions& options_;
  const Scene& scene_;
  std::optional<PlannedRow> steps_;
  Simulation simulation_;
  Observers observers_;
  Samplers samplers_;
  Survival survival_;
  ViewPage page_;
  ReplayLog log_;
  std::optional<Course> course_;
  std::vector<std::int64_t> event_of_;  // number in the log of each meeting of the course
  Json head_;
  std::string start_, first_chunk_;
  Interrupt interrupt_;
  RunReport report_;
  bool cut_ = false;
};

void write_picture(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.line() += text;
  file.close();
}

std::string size_text(const std::string& path) {
  std::error_code ignored;
  const double bytes = static_cast<double>(fs::file_size(path, ignored));
  return bytes < 1e6 ? fmt::format("{:.0f} kB", bytes / 1e3) : fmt::format("{:.1f} MB", bytes / 1e6);
}

ExitStatus conclude(const Viewing& viewing, const ViewOptions& options, const Console& console) {
  if (viewing.cut())
    console.err << fmt::format("carom: the page holds the first {} collisions, to time {}. More with --most.\n",
                               options.most, viewing.summary().time.value);
  if (viewing.summary().stopped) {
    console.err << fmt::format("carom: the run stopped at time {}: {}. The page shows it up to there.\n",
                               viewing.summary().stopped->time.value, viewing.summary().stopped->reason);
    return ExitStatus::stopped;
  }
  return viewing.signal() != 0 ? ended_by(viewing.signal()) : ExitStatus::done;
}

}  // namespace

CLI::App* add_view_command(CLI::App& program, ViewOptions& options) {
  CLI::App* command = program.add_subcommand("view", "Writes one HTML page that replays the run of a scene exactly");
  add_scene_arguments(*command, options.scene);
  command->get_option("SCENE")->description(
      "Scene file (TOML); or a folder, of carom run --out or with a scene.toml, whose tables (*.csv) are shown too");
  command->add_option("--until", options.scene.until, "Ends at this time, events at it included")->type_name("T");
  command->add_option("--events", options.scene.events, "Ends after so many collisions")->type_name("N");
  command->add_option("--out", options.out, "The page. DEFAULT: NAME.html here")->type_name("FILE");
  command
      ->add_option("--compare", options.compare,
                   "Beside it a run by time steps: DT, or DT,METHOD as for carom compare. DEFAULT METHOD: discrete")
      ->type_name("DT[,METHOD]");
  command->add_option("--picture", options.picture, "Writes a still picture too")->type_name("FILE.svg");
  command->add_option("--most", options.most, "Collisions that the page holds at most")
      ->type_name("N")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->footer(
      "The page needs no network and no other file: open it in a browser, or mail it. Some 170 bytes a collision in "
      "2-D.\n\n"
      "Example:\n  carom view scene.toml --out page.html\n  carom view scene.toml --compare 0.01,discrete\n\n"
      "Exit status: 3 if the run stopped before its end; the page shows it up to there.");
  return command;
}

ExitStatus view(const ViewOptions& options, const Console& console) {
  if (page_parts() == nullptr)
    throw InputError(Problem{"", 0, "carom view is not part of this carom", "node and npm were not there when it was built",
                             "Install the Debian packages nodejs and npm, and build carom again"});
  const Viewed what = viewed(options.scene);
  std::optional<PlannedRow> steps;
  if (!options.compare.empty()) steps = plan_view_steps(options.compare, what.scene);
  Json tables = what.folder.empty() ? Json::array() : tables_in(what.folder);
  const std::string path = options.out.empty() ? page_of(what.record.file) : options.out;
  std::error_code ignored;
  if (fs::equivalent(path, what.record.file, ignored))
    throw InputError(
        Problem{what.record.file, 0, "--out is the scene file itself", "it would be overwritten", "Choose another name"});

  Viewing viewing(options, what, std::move(steps), path);
  viewing.run(console.err_is_terminal ? &console.err : nullptr);
  viewing.finish(std::move(tables));
  if (!options.picture.empty()) write_picture(options.picture, viewing.picture());
  console.out << fmt::format("Wrote {} ({}, {} events). Open it in a browser.\n", path, size_text(path), viewing.events());
  return conclude(viewing, options, console);
}

}  // namespace carom::app
