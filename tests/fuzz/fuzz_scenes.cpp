// fuzz_scenes --count N --seed S: runs the random scenes numbered S, S + 1, ..., S + N - 1 and checks what must hold in
// every run. A failure prints the number and the scene as TOML; exit status 1 if there was one. --print writes the scenes
// only.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>

#include <fmt/core.h>

#include "any_scene.hpp"
#include "judge_scene.hpp"

namespace {

using carom::testing::any_scene;
using carom::testing::judge_scene;

constexpr int most_failures = 10;

/// Seconds of processor that this program has taken: a busy machine makes no scene hang.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A scene takes about a millisecond, one with 10^7 reflections at an instant some seconds. After `patience` it is
/// interrupted; if it does not listen, the program ends.
class Watchdog {
 public:
  static constexpr double patience = 30.0;

  Watchdog() : thread_([this] { watch(); }) {}
  ~Watchdog() {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }

  void starts(std::uint64_t number) {
    const std::lock_guard lock(mutex_);
    number_ = number;
    since_ = processor_seconds();
    interrupt_ = false;
  }
  [[nodiscard]] const std::atomic<bool>& interrupt() const { return interrupt_; }

 private:
  void watch() {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, std::chrono::seconds(1), [this] { return over_; })) {
      const double taken = processor_seconds() - since_;
      if (taken > patience) interrupt_ = true;
      if (taken > 2 * patience) {
        fmt::print(stderr, "scene {} hangs and cannot be interrupted:\n{}\n", number_, any_scene(number_));
        std::_Exit(1);
      }
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::uint64_t number_ = 0;
  double since_ = processor_seconds();
  std::atomic<bool> interrupt_{false};
  std::thread thread_;
};

struct Arguments {
  std::uint64_t count = 1000, seed = 0;
  bool print = false;
};

Arguments arguments(int argc, char** argv) {
  Arguments out;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--print") {
      out.print = true;
    } else if ((word == "--count" || word == "--seed") && i + 1 < argc) {
      (word == "--count" ? out.count : out.seed) = std::stoull(argv[++i]);
    } else {
      throw std::invalid_argument(word);
    }
  }
  return out;
}

int fuzz(const Arguments& wanted) {
  Watchdog watchdog;
  int failures = 0;
  std::uint64_t refused = 0;
  std::int64_t collisions = 0;
  double energy_error = 0, momentum_error = 0;
  const double start = processor_seconds();
  std::uint64_t done = 0;
  for (; done < wanted.count && failures < most_failures; ++done) {
    const std::uint64_t number = wanted.seed + done;
    const std::string text = any_scene(number);
    if (wanted.print) {
      fmt::print("# scene {}\n{}\n", number, text);
      continue;
    }
    watchdog.starts(number);
    const carom::testing::Verdict verdict = judge_scene(text, watchdog.interrupt());
    refused += verdict.refused;
    collisions += verdict.collisions;
    energy_error = std::max(energy_error, verdict.energy_error);
    momentum_error = std::max(momentum_error, verdict.momentum_error);
    if (verdict.complaint.empty()) continue;
    ++failures;
    fmt::print("# scene {}: {}\n{}\n", number, verdict.complaint, text);
  }
  if (wanted.print) return 0;
  const double seconds = processor_seconds() - start;
  fmt::print(
      "{} scenes, {} refused, {} collisions, largest errors of energy {:.3g} and momentum {:.3g} of their bounds, {} "
      "failures, "
      "{:.3f} ms of processor a scene\n",
      done, refused, collisions, energy_error, momentum_error, failures,
      1e3 * seconds / static_cast<double>(std::max<std::uint64_t>(done, 1)));
  return failures == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return fuzz(arguments(argc, argv));
  } catch (const std::exception& error) {
    fmt::print(stderr, "fuzz_scenes: {}\nusage: fuzz_scenes [--count N] [--seed S] [--print]\n", error.what());
    return 2;
  }
}
