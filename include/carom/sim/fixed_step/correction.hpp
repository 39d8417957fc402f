#pragma once
// Taking overlaps back by moving the balls apart, shared by inverse mass.

#include <algorithm>

#include "carom/sim/fixed_step.hpp"
#include "carom/sim/fixed_step/step_state.hpp"

namespace carom {

/// The part of an overlap [length unit] that one pass takes back; `smaller`: radius of the smaller ball.
[[nodiscard]] inline double taken_back(const SolverOptions& options, double overlap, double smaller) {
  switch (options.correction) {
    case PositionCorrection::full:
      return overlap;
    case PositionCorrection::baumgarte:
      return options.fraction * std::max(0.0, overlap - options.slop * smaller);
    default:
      return 0;
  }
}

/// Balls i and j, a distance |r| apart along r, move apart along it; the centre of mass stays, and so do coincident balls.
/// False if nothing is taken back.
template <int D>
inline bool push_apart(StepState<D>& s, const SolverOptions& options, std::uint32_t i, std::uint32_t j,
                       const Vec<double, D>& r, double distance) {
  const double take = taken_back(options, s.radius[i] + s.radius[j] - distance, std::min(s.radius[i], s.radius[j]));
  if (!(take > 0) || !(distance > 0)) return false;
  const Vec<double, D> shift = r * (take / (distance * (s.inverse_mass[i] + s.inverse_mass[j])));
  s.x[i] -= shift * s.inverse_mass[i];
  s.x[j] += shift * s.inverse_mass[j];
  return true;
}

/// Ball i moves out of a wall along its unit normal. False if nothing is taken back.
template <int D>
inline bool push_out(StepState<D>& s, const SolverOptions& options, std::uint32_t i, double overlap,
                     const Vec<double, D>& normal) {
  const double take = taken_back(options, overlap, s.radius[i]);
  if (!(take > 0) || s.immovable(i)) return false;
  s.x[i] += normal * take;
  return true;
}

}  // namespace carom
