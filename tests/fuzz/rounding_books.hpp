#pragma once
// How far rounding may take energy and momentum from their balance: added up impact by impact.

#include <array>
#include <cstdint>
#include <vector>

#include "carom/sim/simulation.hpp"

namespace carom::testing {

/// Follows a run by its log. With u = 2^-53, each time that a state is written
///   each component of a velocity is rounded, which moves m v by u m |v| and m v^2 / 2 by u m v^2: after the impact, and
///   before it where an acceleration has changed it on the way;
///   each component of a position is rounded, in its flight and when whole periods are taken out, which moves m g x by
///   u m |g| for each rounding and unit of its size: that of the place, of the way since the last event, and of the period.
/// Law "stick" adds up the mass of a body, "merge" masses and centres of mass, with a rounding each; law "symmetric" may
/// write a velocity four times (together.hpp, most_refinements). A look rounds as well, but leaves nothing behind.
/// Everything else is evaluated in twice the precision: an impact in fewer than 64 operations with errors of at most 15 u^2
/// [core/double_double.hpp], the sums over n balls at either end of the run with 3 u^2 a term and 5 u^2 for its product.
class RoundingBooks {
 public:
  RoundingBooks(const Scene& scene, const Simulation& simulation);

  void record(const Collision& c);

  /// Largest error of the energy balance that rounding explains, for a look at `simulation` now.
  [[nodiscard]] double energy(const Simulation& simulation, const EnergyBalance& balance);
  /// Of the total momentum, as a vector; without acceleration.
  [[nodiscard]] double momentum(const Simulation& simulation) const;

 private:
  struct Ball {
    double radius = 0.0;
    double mass = 0.0;                 ///< 0: infinite, or merged away: not in the sums
    double time = 0.0;                 ///< of its last event
    double speed = 0.0;                ///< after it
    double fastest = 0.0;              ///< since the last look
    std::vector<std::uint32_t> group;  ///< law "stick": all that move as one, itself included
  };

  /// Potential, over the mass, that a rounding of each component of a position moves, in units of u.
  [[nodiscard]] double of_position(const std::array<double, 3>& x, double way) const;
  [[nodiscard]] double way_since(const Ball& ball, double now, double speed_now) const;
  void write(const Collision& c, const Collision::Party& party, const Collision::Party& kept);
  void unite(const Collision& c);

  LawKind law_;
  bool rests_ = false, accelerated_ = false;
  double velocity_roundings_, position_roundings_;
  std::array<double, 3> pull_{}, period_{};
  double pull_size_ = 0.0;
  std::vector<Ball> balls_;
  std::int64_t others_ = 0;         ///< changes of motion that no record tells of, at the last look
  double momentum_at_start_ = 0.0;  ///< sum of m |v|
  double energy_ = 0.0, momentum_ = 0.0;
};

}  // namespace carom::testing
