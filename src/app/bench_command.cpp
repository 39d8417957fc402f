#include "bench_command.hpp"

#include <fmt/core.h>

#include "carom/core/error.hpp"
#include "carom/scene/read.hpp"
#include "scene/keywords.hpp"
#include "scene/words.hpp"
#include "write/json_text.hpp"

namespace carom::app {

namespace {

template <class E>
E choice(const char* option, const std::string& word, std::span<const scene_text::Word<E>> words) {
  for (const auto& w : words)
    if (word == w.text) return w.value;
  std::vector<std::string_view> known;
  for (const auto& w : words) known.push_back(w.text);
  throw InputError(Problem{"", 0, fmt::format("{} is {}", option, scene_text::in_quotes(word)), "there is no such one",
                           scene_text::suggestion(word, known)});
}

EngineSpec engine_of(const BenchOptions& options, EngineSpec engine) {
  if (!options.search.empty()) engine.search = choice<SearchKind>("--search", options.search, scene_text::search_kinds);
  if (!options.queue.empty()) engine.queue = choice<QueueKind>("--queue", options.queue, scene_text::queue_kinds);
  return engine;
}

std::vector<BenchCase> scenes(const BenchOptions& options) {
  std::vector<BenchCase> list;
  for (const std::string& file : options.scenes) {
    BenchCase& c = list.emplace_back(options.common);
    c.scene = read_scene_file(file);
    c.scene->engine = engine_of(options, c.scene->engine);
    c.dimension = c.scene->dimension;
  }
  return list;
}

/// The measurements asked for: scenes, or gases packing by packing and from few balls to many.
std::vector<BenchCase> cases(const BenchOptions& options) {
  if (!options.scenes.empty()) return scenes(options);
  std::vector<double> packing = options.packing;
  const int d = options.common.dimension;
  if (packing.empty()) packing = d == 3 ? std::vector{0.49, 0.3} : d == 2 ? std::vector{0.65, 0.3} : std::vector{0.3};
  std::vector<BenchCase> list;
  for (const double phi : packing)
    for (const std::int64_t n : options.balls) {
      BenchCase& c = list.emplace_back(options.common);
      c.balls = n;
      c.packing = phi;
      c.engine = engine_of(options, c.engine);
    }
  return list;
}

Json row_of(const BenchCase& c, const BenchResult& r) {
  const auto number = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  Json row = {{"dimension", c.dimension},
              {"scene", c.scene ? Json(c.scene->file) : Json(nullptr)},
              {"packing_fraction", c.scene ? Json(nullptr) : Json(c.packing)},
              {"balls", r.balls},
              {"composition", r.composition},
              {"collisions_per_second", r.median},
              {"lowest", r.lowest},
              {"highest", r.highest},
              {"nanoseconds_per_collision", 1e9 / r.median},
              {"predictions_per_collision", number(r.predictions)},
              {"bytes_per_ball", number(r.bytes_per_ball)},
              {"start_seconds", r.start_seconds},
              {"warm_up_collisions", r.warm_up_collisions},
              {"windows", c.windows}};
  if (r.saved)
    row["checkpoint"] = {{"bytes_per_ball", r.saved->bytes_per_ball},
                         {"save_seconds", r.saved->save_seconds},
                         {"resume_seconds", r.saved->resume_seconds}};
  return row;
}

void print(std::ostream& out, const BenchCase& c, const BenchResult& r) {
  const auto number = [](const char* format, const std::optional<double>& x) {
    return x ? fmt::format(fmt::runtime(format), *x) : std::string("-");
  };
  out << fmt::format("{:>2}-D {:>7} {:>10} {:>10.3g} {:>9.3g} {:>9.3g} {:>9.0f} {:>9} {:>10} {:>8.2f}  {}{}\n", c.dimension,
                     c.scene ? std::string("-") : fmt::format("{:.3g}", c.packing), r.balls, r.median, r.lowest, r.highest,
                     1e9 / r.median, number("{:.1f}", r.predictions),
                     number("{:.0f}", r.bytes_per_ball), r.start_seconds, r.composition,
                     c.scene ? ": " + c.scene->file : std::string());
  if (r.saved)
    out << fmt::format("     checkpoint: {:.1f} bytes a ball, saved in {:.2f} s, resumed in {:.2f} s\n", r.saved->bytes_per_ball,
                       r.saved->save_seconds, r.saved->resume_seconds);
  out.flush();
}

}  // namespace

CLI::App* add_bench_command(CLI::App& program, BenchOptions& options) {
  CLI::App* command = program.add_subcommand("bench", "Measures collisions per second on this machine");
  command->add_option("--balls", options.balls, "Numbers of balls, 1000,10000,100000 if not given")
      ->delimiter(',')
      ->check(CLI::Range(std::int64_t{2}, std::int64_t{100'000'000}))
      ->type_name("N,...");
  command->add_option("--packing", options.packing, "Packing fractions, 0.49,0.3 if not given (0.65,0.3 in 2-D)")
      ->delimiter(',')
      ->type_name("PHI,...");
  command->add_option("--scene", options.scenes, "Scenes to measure in the place of gases")->type_name("FILE ...");
  BenchCase& c = options.common;
  command->add_option("--dimension", c.dimension, "1, 2 or 3")->check(CLI::Range(1, 3))->capture_default_str();
  command->add_option("--warm-up", c.warm_up, "Collisions of each ball before measuring")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_option("--seconds", c.seconds, "Processor time of all windows of a row")
      ->check(CLI::Range(1e-3, 1e6))
      ->capture_default_str();
  command->add_option("--windows", c.windows, "Windows, of which the median counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--checkpoint", c.checkpoint, "Saves each state in this file, and resumes from it: its size, and how long that takes")
      ->type_name("FILE");
  command->add_option("--seed", c.seed, "Of the placement and the velocities")->capture_default_str();
  command->add_option("--search", options.search, "As [engine] search")->type_name("WORD");
  command->add_option("--queue", options.queue, "As [engine] queue")->type_name("WORD");
  command->add_flag("--json", options.json, "Prints one JSON object");
  command->footer(
      "Example:\n  carom bench --balls 1000,1000000 --packing 0.49 --json\n\n"
      "Each row is a scene, or a gas of elastic disks or spheres in a periodic cell, warmed up first. Seconds are processor\n"
      "time of the one thread that works; low and high are the slowest and the fastest window; bytes are the growth of the\n"
      "peak of the resident memory; start is the time until the first collision.");
  return command;
}

ExitStatus bench(const BenchOptions& options, const Console& console) {
  Json rows = Json::array();
  bool first = true;
  for (const BenchCase& c : cases(options)) {
    const BenchResult result = bench(c);
    if (options.json) {
      rows.push_back(row_of(c, result));
    } else {
      if (first)
        console.out << "     packing      balls     coll./s       low      high  ns/coll.  pairs/c.  bytes/ball  start s  "
                       "composition\n";
      print(console.out, c, result);
    }
    first = false;
  }
  if (options.json) console.out << json_text({{"rows", rows}});
  return ExitStatus::done;
}

}  // namespace carom::app
