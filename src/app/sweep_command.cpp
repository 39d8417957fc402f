#include "sweep_command.hpp"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "carom/core/error.hpp"
#include "carom/write/output_file.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "sweep_desk.hpp"
#include "sweep_plan.hpp"
#include "sweep_ranks.hpp"
#include "sweep_rows.hpp"
#include "sweep_statistics.hpp"

namespace carom::app {

namespace {

/// Where each row goes: into the means, the folder, and to who wants to read them.
class Collector {
 public:
  Collector(const SweepOptions& options, const SweepPlan& plan, const Console& console)
      : options_(options), plan_(plan), console_(console), statistics_(plan),
        progress_(console.err_is_terminal && !options.quiet ? &console.err : nullptr, no_run_) {
    if (options.out.empty()) return;
    rows_.emplace(options.out, plan, options.resume);
    if (rows_->found() > plan.ensemble().runs())
      throw InputError(Problem{"", 0, fmt::format("\"{}\" holds {} rows, and this sweep has {}", options.out, rows_->found(),
                                                  plan.ensemble().runs()),
                               "a sweep that is resumed has as many runs or more", "Raise --count"});
    rows_->read([this](const std::string& line) { show(line); });
  }

  [[nodiscard]] std::int64_t found() const { return rows_ ? rows_->found() : 0; }

  void take(const std::string& line) {
    if (rows_) rows_->append(line);
    show(line);
    const SweepGroup all = statistics_.total();
    progress_.show(fmt::format("{} runs", all.runs()), static_cast<double>(all.runs()) / static_cast<double>(plan_.ensemble().runs()));
  }

  /// After the last row.
  void end(bool whole) {
    if (rows_ && whole) rows_->finish();
    if (options_.rows && !options_.json)
      write_rows_csv([this](const auto& take) { std::for_each(lines_.begin(), lines_.end(), take); },
                     [this](const std::string& line) { console_.out << line << '\n'; });
    if (options_.rows || (options_.quiet && !options_.json)) return;
    if (options_.json) {
      Json j = statistics_.object();
      j["seconds"] = progress_.seconds();
      console_.out << json_text(j);
    } else {
      const double seconds = progress_.seconds();
      console_.out << statistics_.table() << fmt::format("  took  {:.3g} s\n", seconds);
    }
  }

 private:
  void show(const std::string& line) {
    statistics_.add(line);
    if (!options_.rows) return;
    if (options_.json) {
      console_.out << line << '\n';
    } else {
      lines_.push_back(line);
    }
  }

  const SweepOptions& options_;
  const SweepPlan& plan_;
  const Console& console_;
  SweepStatistics statistics_;
  std::optional<SweepRows> rows_;
  std::vector<std::string> lines_;  // where they are wanted as a table
  RunSpec no_run_;
  Progress progress_;
};

/// mpirun starts one process a processor.
int threads_of(const SweepOptions& options, bool one_of_many) {
  if (options.threads > 0) return options.threads;
  return one_of_many ? 1 : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// All others wait for what rank 0 says; what goes wrong before, it says alone.
ExitStatus sweep_here(const SweepOptions& options, const Console& console, const Ranks* ranks) {
  bool led = false;
  try {
    if (options.resume && options.out.empty())
      throw InputError(Problem{"", 0, "--resume without --out", "it goes on with the rows in a folder", "Name it: --out DIR"});
    const SweepPlan plan(options);
    if (plan.names_files() && !options.quiet)
      console.err << "carom: the scene's files under [output] are not written in a sweep; carom run writes those of one run.\n";
    Interrupt interrupt;
    Collector collector(options, plan, console);
    SweepDesk desk(collector.found(), plan.ensemble().runs(), [&](const std::string& line) { collector.take(line); },
                   interrupt.flag());
    led = true;
    if (ranks != nullptr) {
      lead(plan, desk, threads_of(options, true), interrupt.flag(), *ranks);
    } else {
      work(plan, desk, threads_of(options, false), interrupt.flag());
    }
    const bool whole = desk.delivered() == plan.ensemble().runs();
    collector.end(whole);
    return whole ? ExitStatus::done : ended_by(interrupt.signal());
  } catch (...) {
    if (ranks != nullptr && !led) dismiss(*ranks);
    throw;
  }
}

ExitStatus sweep_for_another(const SweepOptions& options, const Console& console, const Ranks& ranks) {
  Interrupt interrupt;
  try {
    follow(options, threads_of(options, true), interrupt.flag(), ranks);
  } catch (const std::exception& error) {
    console.err << "carom: process " << ranks.rank() << " of the sweep: " << error.what() << std::endl;
    ranks.abort();
  }
  return ExitStatus::done;
}

}  // namespace

CLI::App* add_sweep_command(CLI::App& program, SweepOptions& options) {
  CLI::App* command = program.add_subcommand("sweep", "Runs a scene many times, with what its runs differ in");
  add_scene_arguments(*command, options.scene);
  command->add_option("--until", options.scene.until, "Each run ends at this time")->type_name("T");
  command->add_option("--events", options.scene.events, "Each run ends after so many collisions")->type_name("N");
  command
      ->add_option("--vary", options.vary,
                   "KEY=[a,b,c] or KEY=FROM:TO:STEPS takes values, KEY=FROM:TO draws one a run, ball.0=random draws place "
                   "and direction; may be repeated")
      ->type_name("KEY=VALUES")
      ->type_size(1)
      ->allow_extra_args(false);
  command->add_option("--count", options.count, "Runs at each combination of values")->type_name("N");
  command->add_option("--seed", options.seed, "Of what is drawn")->type_name("N");
  command->add_flag("--zip", options.zip, "The k-th values of all keys together, in place of each with each");
  command->add_option("--threads", options.threads, "Runs at a time; one with decimal digits (mpirun takes more). DEFAULT: one a processor")->type_name("N")->check(CLI::Range(1, 4096));
  command->add_option("--precision", options.precision, "Arithmetic: double, long-double, or decimal digits, as 50")->type_name("P");
  command->add_option("--out", options.out, "Folder for runs.jsonl and runs.csv, a row a run")->type_name("DIR");
  command->add_flag("--resume", options.resume, "Goes on with the rows in the folder");
  command->add_flag("--final", options.final, "Rows with the state of every ball at the end");
  command->add_flag("--rows", options.rows, "Prints the rows as CSV, or with --json as JSON lines");
  command->add_flag("--json", options.json, "Prints one JSON object");
  command->add_flag("--quiet", options.quiet, "No progress and no table");
  command->footer(
      "Examples:\n  carom sweep scene.toml --vary collision.restitution=0.5:1:11 --vary gas.0.seed=random --count 20 --out results\n"
      "  carom sweep scene.toml --vary ball.0=random --count 1000 --events 100 --json\n\n"
      "Rows and means do not depend on the number of threads. A row's values, given to carom run by --set, make the same run.\n"
      "Exit status: 0 done, runs that stopped or were refused among them; 2 wrong scene or command line, nothing written;\n"
      "3 rows could not be written; 130 on Ctrl-C and 143 on termination, with whole rows, to go on from with --resume.");
  return command;
}

ExitStatus sweep(const SweepOptions& options, const Console& console) {
  const std::unique_ptr<Ranks> ranks = Ranks::begin();
  if (ranks && ranks->rank() > 0) return sweep_for_another(options, console, *ranks);
  return sweep_here(options, console, ranks.get());
}

}  // namespace carom::app
