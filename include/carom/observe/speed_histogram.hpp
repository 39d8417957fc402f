#pragma once
// How much of their time balls spend at which speed.

#include <array>
#include <vector>

#include "carom/observe/block_sums.hpp"
#include "carom/observe/observer.hpp"

namespace carom {

/// One bin.
struct SpeedBin {
  double from = 0.0, to = 0.0;  ///< [length/time]
  double share = 0.0;           ///< of the time of all balls, exact for the flights measured
  double maxwell = 0.0;         ///< the share of a Maxwell distribution of the same mean kinetic energy and masses
};

/// Over all balls that move freely, weighted by time: every flight counts with its duration, and within an accelerated
/// flight every speed with the time spent there.
///   speed_histogram.mean [length/time], speed_histogram.mean_square
///   speed_histogram.maxwell_mean, speed_histogram.maxwell_fourth: mean and fourth moment of u = sqrt(m) |v|, each over its
///   value in a Maxwell distribution of the same mean square (any mixture of masses):
///   <u> / (c <u^2>^(1/2)), c = sqrt(2/d) Gamma((d + 1)/2) / Gamma(d/2), and <u^4> d / ((d + 2) <u^2>^2). 1 in equilibrium;
///   N balls of fixed energy have a fourth moment lower by the factor D_f / (D_f + 2).
/// There are 128 bins, which become twice as wide whenever a speed lies beyond them.
class SpeedHistogram {
 public:
  explicit SpeedHistogram(const Subject& subject);

  void flight(const Flight& f);
  void collision(const Collision&, double, const Subject&) {}
  void end(double t) { moments_.end(t); }
  [[nodiscard]] Estimates estimates() const;

  /// From 0 to the last bin that is not empty.
  [[nodiscard]] std::vector<SpeedBin> table() const;

 private:
  static constexpr std::size_t bins = 128;

  struct Species {
    double mass, count;
  };

  void make_room(double speed);
  [[nodiscard]] double maxwell_below(double speed, double temperature) const;

  int dimension_;
  std::vector<Species> species_;
  double width_;  // of a bin; 0: no ball has moved yet
  std::array<double, bins> time_{};
  BlockSums<6> moments_;  // time, v, v^2, u, u^2, u^4
};

}  // namespace carom
