#pragma once
// What a time step costs: a stepper beside the exact run of the same scene.

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "carom/observe/course.hpp"
#include "carom/observe/enclosures.hpp"
#include "carom/observe/meeting.hpp"
#include "carom/sim/stepper.hpp"

namespace carom {

struct ComparisonSettings {
  double dt = 0.0;         ///< [time] of a step of the stepper, > 0
  std::int64_t steps = 1;  ///< to make, >= 1; the course must reach to the end of the last one
  double delay = 0.0;      ///< [time] from the begin of a contact to the moment at which the stepper reports it. DEFAULT: 0
  const std::atomic<bool>* interrupt = nullptr;  ///< ends it before the next step
  std::function<void(double share)> slice{};     ///< of the steps made, a few times a second or more often
  std::function<void(double time, double error)> position_error{};  ///< about a thousand times, at the ends of steps
};

/// Averages from one moment to another, of a run and of the exact one. What has no duration is NaN.
struct Averages {
  double collision_rate = 0.0;     ///< [1/time] of two balls and with walls
  double ball_impulse_rate = 0.0;  ///< [momentum/time] sizes of the impulses between balls
  double wall_impulse_rate = 0.0;  ///< [momentum/time] the same on walls: the pressure times the area of all walls
  double kinetic_energy = 0.0;     ///< [energy] of the balls of finite mass, mean over the ends of steps
};

/// The two runs have *parted* at the first end of a step at which a ball is further from its place in the exact run than
/// its radius (a point ball: than a hundredth of Course::extent()). Ends of steps are looked at one by one, or, of more
/// than 10^7 places of balls, evenly chosen ones. Only up to there meetings and places are those of the same run. What is
/// compared beyond is what does not depend on the path: conserved quantities, and averages.
struct Comparison {
  double start = 0.0;  ///< [time]
  double time = 0.0;   ///< at the end of the last step
  std::int64_t steps = 0;
  std::int64_t collisions = 0;   ///< contacts with an impulse, all of them
  Tally tally;                   ///< up to where they parted, else to the end; two steps and `delay` of allowance
  std::int64_t escaped = 0;      ///< balls beyond a wall at the end, see Enclosures
  double deepest_overlap = 0.0;  ///< [length] of all contacts reported
  double position_error = 0.0;   ///< [length] largest distance of a ball from its place in the exact run, at the end

  /// |E - E_exact| over the largest kinetic energy of the exact run, E kinetic and potential at the same moment: dissipation
  /// that the exact run has too is no error. If the exact run keeps its energy, or they never parted: at the end. Else the
  /// mean over the times looked at until they parted: at one moment a collision may be under way in one run and done in
  /// the other. NaN if there was none after the start.
  double energy_error = 0.0;
  /// The same of the momentum, |P - P_exact| over the largest sum of m|v| of the exact run.
  double momentum_error = 0.0;

  std::optional<std::int64_t>
      diverged_at_collision;          ///< exact collisions until they parted, the number of the last; none: never
  std::optional<double> diverged_at;  ///< [time] when they were found parted
  double averaged_from = 0.0;         ///< [time] where they parted; the start, if never
  Averages here, exact;               ///< from there to the end

  double seconds = 0.0;      ///< [s] wall time of the steps alone
  bool interrupted = false;  ///< then the rest means nothing

  /// [s/time] wall time of a unit of the scene's time.
  [[nodiscard]] double seconds_per_time() const noexcept { return seconds / (time - start); }
};

/// `stepper` is at the start of the scene that `course` is of.
[[nodiscard]] Comparison compare(const Course& course, const Enclosures& enclosures, Stepper& stepper,
                                 const ComparisonSettings& settings);

}  // namespace carom
