#pragma once
// How many collisions a second the engine resolves here.

#include <cstdint>
#include <optional>
#include <string>

#include "carom/scene/scene.hpp"

namespace carom::app {

/// One measurement: a scene, or a gas of elastic balls, warmed up, then watched in windows.
struct BenchCase {
  std::optional<Scene> scene;  ///< none: the gas that follows
  int dimension = 3;
  std::int64_t balls = 1000;
  double packing = 0.49;       ///< [-]
  double warm_up = 10;         ///< collisions of each ball before the first window
  int windows = 7;
  double seconds = 3.5;        ///< of processor time in all windows
  std::uint64_t seed = 1;
  EngineSpec engine{};
  std::string checkpoint;      ///< file to save the state in after the windows, and to resume from; empty: neither
};

struct BenchResult {
  std::string composition;
  std::int64_t balls = 0;
  double start_seconds = 0.0;           ///< processor time until the gas stands and its first events are queued
  std::int64_t warm_up_collisions = 0;
  double median = 0.0, lowest = 0.0, highest = 0.0;  ///< collisions a second of processor time, over the windows
  std::optional<double> predictions;    ///< pairs computed a collision; none: the engine does not count them
  std::optional<double> bytes_per_ball; ///< growth of the peak of the resident memory over what was there before

  struct Saved {
    double bytes_per_ball = 0.0;  ///< of the file
    double save_seconds = 0.0;    ///< of processor time: waiting for the disk is not in it
    double resume_seconds = 0.0;  ///< of processor time, until the first events are queued again
  };
  std::optional<Saved> saved;
};

/// The balls have diameter 1 and thermal speed 1. Throws InputError.
[[nodiscard]] BenchResult bench(const BenchCase& c);

}  // namespace carom::app
