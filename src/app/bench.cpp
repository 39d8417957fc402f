#include "bench.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "carom/sim/simulation.hpp"
#include "carom/write/checkpoint_file.hpp"
#include "peak_memory.hpp"

namespace carom::app {

namespace {

/// Processor time of this process [s]: one thread works, and what else runs on the machine does not count.
double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// What an earlier measurement has freed goes back to the system, so that it is not taken for this one's.
void give_back_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

Scene gas(const BenchCase& c) {
  Scene scene;
  scene.dimension = c.dimension;
  GasSpec spec;
  spec.count = c.balls;
  spec.radius = Number(0.5);
  spec.packing_fraction = Number(c.packing);
  spec.seed = c.seed;
  scene.gases = {spec};
  scene.engine = c.engine;
  scene.run.events = 0;
  return scene;
}

/// Collisions a second in one window.
double watch(Simulation& simulation, std::int64_t collisions) {
  const double begin = processor_seconds();
  const std::int64_t before = simulation.counts().collisions();
  simulation.advance(std::nullopt, collisions);
  const double seconds = processor_seconds() - begin;
  return static_cast<double>(simulation.counts().collisions() - before) / std::max(seconds, 1e-9);
}

/// How many collisions last `seconds`: by doubling their number until they last a tenth of that.
std::int64_t collisions_for(Simulation& simulation, double seconds) {
  for (std::int64_t n = 1024;; n *= 2) {
    const double rate = watch(simulation, n);
    const double lasted = static_cast<double>(n) / rate;
    if (lasted > seconds / 10) return std::max<std::int64_t>(1, std::llround(rate * seconds));
  }
}

/// Saves the state, and resumes from it.
BenchResult::Saved save(Simulation& simulation, const std::string& file) {
  BenchResult::Saved saved;
  double begin = processor_seconds();
  write_checkpoint(file, simulation);
  saved.save_seconds = processor_seconds() - begin;
  saved.bytes_per_ball = static_cast<double>(std::filesystem::file_size(file)) / simulation.ball_count();
  begin = processor_seconds();
  read_checkpoint(file, simulation);
  saved.resume_seconds = processor_seconds() - begin;
  return saved;
}

}  // namespace

BenchResult bench(const BenchCase& c) {
  BenchResult result;
  give_back_memory();
  const bool fresh = forget_peak_memory();
  const double before_mb = peak_memory_mb();
  const double begin = processor_seconds();
  Simulation simulation(c.scene ? *c.scene : gas(c));
  simulation.advance(std::nullopt, 1);
  result.start_seconds = processor_seconds() - begin;
  result.composition = simulation.composition().text();
  result.balls = simulation.ball_count();
  result.warm_up_collisions = std::llround(c.warm_up * static_cast<double>(result.balls) / 2);
  simulation.advance(std::nullopt, result.warm_up_collisions);

  const std::int64_t collisions = collisions_for(simulation, c.seconds / c.windows);
  const std::int64_t from = simulation.counts().collisions();
  const std::optional<std::int64_t> predicted = simulation.predictions();
  std::vector<double> rates;
  for (int w = 0; w < c.windows; ++w) rates.push_back(watch(simulation, collisions));
  std::sort(rates.begin(), rates.end());
  result.lowest = rates.front();
  result.highest = rates.back();
  const std::size_t half = rates.size() / 2;
  result.median = rates.size() % 2 == 1 ? rates[half] : (rates[half - 1] + rates[half]) / 2;
  if (predicted)
    result.predictions = static_cast<double>(*simulation.predictions() - *predicted) /
                         static_cast<double>(simulation.counts().collisions() - from);
  if (!c.checkpoint.empty()) result.saved = save(simulation, c.checkpoint);
  if (fresh) result.bytes_per_ball = (peak_memory_mb() - before_mb) * 1048576 / static_cast<double>(result.balls);
  return result;
}

}  // namespace carom::app
