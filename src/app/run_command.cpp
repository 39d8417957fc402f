#include "run_command.hpp"

#include <cmath>
#include <span>

#include <fmt/core.h>

#include "carom/core/error.hpp"
#include "carom/core/precision.hpp"
#include "carom/observe/observers.hpp"
#include "carom/observe/samplers.hpp"
#include "carom/observe/survival.hpp"
#include "carom/sim/simulation.hpp"
#include "carom/write/checkpoint_file.hpp"
#include "carom/write/summary_json.hpp"
#include "carom/write/summary_table.hpp"
#include "checkpoints.hpp"
#include "interrupt.hpp"
#include "live.hpp"
#include "peak_memory.hpp"
#include "progress.hpp"
#include "run_outputs.hpp"
#include "run_record.hpp"
#include "run_to_the_end.hpp"

namespace carom::app {

namespace {

constexpr std::int64_t shown_balls = 20;  // the table for people lists the balls of scenes up to this size

/// Runs, and fills the files as it goes. A write that fails ends the run.
RunReport carry_out(Simulation& simulation, const Scene& scene, Observers& observers, Samplers& samplers,
                    const Survival& survival, RunOutputs& outputs, Checkpoints& checkpoints, Interrupt& interrupt, std::ostream* screen, Live* live) {
  RunReport report;
  Progress progress(screen, scene.run);
  Watchers watchers;
  watchers.interrupt = &interrupt.flag();
  watchers.slice = [&] {
    progress.show(simulation);
    checkpoints.look(simulation);
  };
  if (samplers.any()) watchers.samplers = &samplers;
  watchers.collision = observers.sink();
  for (RunOutputs::Stream& stream : outputs.streams())
    observers.stream(stream.name, [&file = stream.file, &interrupt](std::span<const double> row) {
      file.row(row);
      if (file.failed()) interrupt.flag() = true;
    });
  if (EventsCsv* log = outputs.events())
    watchers.collision = [log, &interrupt, &observers](const Collision& collision) {
      observers.collision(collision);
      log->write(collision);
      if (log->failed()) interrupt.flag() = true;
    };
  if (outputs.wants_frames())
    watchers.frame = [&outputs, &simulation, &interrupt] {
      outputs.frame(simulation);
      if (outputs.failed()) interrupt.flag() = true;
    };
  watchers.frames_at = scene.output.trajectory_frames;
  if (live != nullptr) live->watch(watchers);
  run_to_the_end(simulation, scene.run, watchers);
  report.seconds = progress.seconds();
  observers.end(simulation);
  report.observed = observers.estimates();
  for (Estimate& e : samplers.estimates()) report.observed.push_back(std::move(e));
  for (Estimate& e : survival.estimates(simulation)) report.observed.push_back(std::move(e));
  auto file = outputs.tables().begin();
  for (const Table& table : samplers.tables()) (file++)->write(table);
  for (const Table& table : observers.tables()) (file++)->write(table);
  for (const Table& table : survival.tables(simulation)) (file++)->write(table);
  if (SpeedHistogramCsv* speeds = outputs.speeds()) speeds->write(*observers.speed_table());
  report.summary = simulation.summary();
  return report;
}

void print(const RunOptions& options, RunReport& report, const Simulation& simulation, const Console& console) {
  if (options.final || (!options.json && report.summary.balls <= shown_balls)) report.final = simulation.balls();
  if (options.json) {
    console.out << summary_json(report);
  } else if (!options.quiet) {
    console.out << summary_table(report, console.colour);
  }
  console.out.flush();
  if (!console.out) throw OutputError("cannot write the result to standard output. Is the disk full, or its reader gone?");
}

std::string remedy(const Summary& summary, const Simulation& simulation) {
  if (summary.stopped_by == Stop::non_finite) return "Are sizes, masses or speeds too far apart?";
  for (const std::uint32_t ball : summary.stopped->balls)
    if (std::isinf(simulation.ball(ball).mass)) return "Give it a finite mass, or end the run before with --until.";
  return "Or end the run before, with --until.";
}

void explain_stop(const Summary& summary, const Simulation& simulation, const Console& console) {
  const StopDetail& stopped = *summary.stopped;
  std::string balls;
  for (const std::uint32_t b : stopped.balls) balls += (balls.empty() ? "" : ", ") + std::to_string(b);
  console.err << fmt::format("carom: stopped at time {} ({} {}): {}. {}\n", stopped.time.value,
                             stopped.balls.size() == 1 ? "ball" : "balls", balls, stopped.reason,
                             remedy(summary, simulation));
}

}  // namespace

CLI::App* add_run_command(CLI::App& program, RunOptions& options) {
  CLI::App* command = program.add_subcommand("run", "Runs a scene to its end and prints what came out");
  add_scene_arguments(*command, options.scene);
  command->add_option("--until", options.scene.until, "Ends at this time, events at it included")->type_name("T");
  command->add_option("--events", options.scene.events, "Ends after so many collisions")->type_name("N");
  command->add_option("--precision", options.precision, "Arithmetic: double, long-double, or decimal digits, as 50")->type_name("P");
  command->add_option("--resume", options.resume, "Goes on from a checkpoint")->type_name("FILE");
  command->add_option("--checkpoint", options.checkpoint, "Saves the state at the end, and on Ctrl-C, in this file")
      ->type_name("FILE");
  command->add_option("--out", options.out, "Folder for the files of [output], made if it is not there")->type_name("DIR");
  command
      ->add_option_function<int>(
          "--live", [&options](int port) { options.live = port; },
          "Serves a page on 127.0.0.1 to watch the run by, until Ctrl-C. PORT 0: any that is free")
      ->type_name("PORT")
      ->expected(0, 1)
      ->default_str("8018")
      ->check(CLI::Range(0, 65535));
  command->add_flag("--json", options.json, "Prints one JSON object");
  command->add_flag("--final", options.final, "Adds the state of every ball at the end");
  command->add_flag("--quiet", options.quiet, "No progress and no table");
  command->footer(
      "Example:\n  carom run scene.toml --until 10 --set collision.restitution=0.9 --out results --json\n\n"
      "Exit status: 0 done; 2 wrong scene or command line, nothing written; 3 stopped or not all written;\n"
      "130 on Ctrl-C and 143 on termination, with output complete to that event.");
  return command;
}

ExitStatus run(const RunOptions& options, const Console& console) {
  const Precision precision = parse_precision(options.precision);
  const Scene scene = read_scene(options.scene);
  Simulation simulation(scene, precision);
  if (!options.resume.empty()) read_checkpoint(options.resume, simulation);
  Observers observers(scene, simulation);
  Samplers samplers(scene, simulation);
  const Survival survival(scene, simulation);
  const RunRecord record = record_of(options.scene);
  RunOutputs outputs(scene, options.out, simulation, {record.text, record.set, {}});
  if (!options.out.empty() && !outputs.any() && scene.output.checkpoint.empty() && options.checkpoint.empty() && !options.quiet)
    console.err << "carom: nothing is written to \"" << options.out << "\": the scene has no files under [output].\n";

  Checkpoints checkpoints(scene, options.checkpoint, options.out, simulation);
  Interrupt interrupt;
  std::optional<Live> live;
  if (options.live) {
    live.emplace(*options.live, scene, simulation, record);
    console.err << fmt::format("carom: watch it at http://127.0.0.1:{}/ (Ctrl-C ends it)\n", live->port()) << std::flush;
  }
  const bool watched = console.err_is_terminal && !options.quiet;
  RunReport report =
      carry_out(simulation, scene, observers, samplers, survival, outputs, checkpoints, interrupt, watched ? &console.err : nullptr,
                live ? &*live : nullptr);
  std::string unwritten = outputs.finish(report.summary);
  const std::string unsaved = checkpoints.finish(simulation);
  unwritten += (unwritten.empty() || unsaved.empty() ? "" : "\n") + unsaved;
  report.peak_memory_mb = peak_memory_mb();
  if (unwritten.empty()) report.files = outputs.written();
  print(options, report, simulation, console);
  if (!options.out.empty() && outputs.any()) write_run_record(options.out, record);
  if (live) live->finish(report, interrupt.flag());

  if (!unwritten.empty()) throw OutputError(unwritten);
  if (report.summary.stopped) {
    explain_stop(report.summary, simulation, console);
    return ExitStatus::stopped;
  }
  return report.summary.stopped_by == Stop::interrupted ? ended_by(interrupt.signal()) : ExitStatus::done;
}

}  // namespace carom::app
