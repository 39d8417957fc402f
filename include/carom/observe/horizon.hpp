#pragma once
// How far a run in double precision can be believed: beside it, the same run in higher precision from the same doubles.

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "carom/scene/scene.hpp"

namespace carom {

/// A collision of the double run: its number, from 1, and its time.
struct HorizonMark {
  std::int64_t event = 0;
  double time = 0.0;  ///< [time]
};

struct Horizon {
  std::int64_t compared = 0;          ///< collisions of both runs that were compared
  int digits = 0;                     ///< of the higher precision
  std::optional<HorizonMark> partner;  ///< first collision of the double run that its ball has with somebody else in the truth
  std::optional<HorizonMark> order;    ///< first collision that comes at another place in the order; its partner may be right
  std::optional<HorizonMark> percent;  ///< a colliding ball is a hundredth of `length` off the truth
  std::optional<HorizonMark> radius;   ///< by all of it
  double length = 0.0;                 ///< [length] smallest radius there is; without any: smallest edge of a space or wall
  double largest_error = 0.0;          ///< [length] of the position of a colliding ball, up to `partner`
  double first_error = 0.0;            ///< [length] the largest at the first collision
  std::optional<double> digits_per_collision;  ///< growth of a small displacement [TangentGrowth] over the collisions compared
  std::optional<double> digits_lost;           ///< the same in all
  std::optional<HorizonMark> input;    ///< as `percent`, between the exact numbers of the scene and their doubles
  double input_error = 0.0;            ///< [length] largest position error that rounding the input makes, as largest_error
};

struct HorizonOptions {
  int digits = 50;                  ///< of the higher precision. DEFAULT: 50
  std::int64_t collisions = 20'000;  ///< at most so many are compared. DEFAULT: 20 000
};

/// Compares until two runs have another partner, they end, or `options.collisions`. A flag raised in `interrupt` ends it early.
/// Positions are compared at the collisions, at equal times, and there only.
[[nodiscard]] Horizon find_horizon(const Scene& scene, const HorizonOptions& options,
                                   const std::atomic<bool>* interrupt = nullptr);

}  // namespace carom
