#pragma once
// The pressure of a gas from the collisions inside it.

#include "carom/observe/block_sums.hpp"
#include "carom/observe/observer.hpp"

namespace carom {

/// For N balls of finite mass in free flight in a periodic cell or in a box, and nothing else in it.
///   kT = 2 K / D_f                                          D_f = d (N - 1) periodic, d N in a box
///   Z  = 1 + sum r J / (d N kT t)                           the virial theorem [ErpenbeckWood1977]
///   P  = N kT Z / V
/// K is the kinetic energy (periodic: about the centre of mass), averaged over the time t; the sum is over collisions, r
/// the distance of the centres at contact and J the impulse. In a box a face is a partner too, at the distance of the
/// ball's radius; P is then, in the long run, the force on the faces over their area. With this D_f, Z of elastic balls has
/// no bias from the fixed energy and momentum: it is the canonical value for N balls.
///   Z_rate: r J is replaced by r times its mean for a Maxwell distribution cut to fixed energy, of which only kT, the
///   masses and D_f enter: with mu the reduced mass,
///   <J> = (1 + e)/2 sqrt(2 pi mu kT) c,  c = sqrt(2/D_f) Gamma((D_f + 1)/2) / Gamma(D_f/2).
/// Z - Z_rate therefore tests whether velocities at collisions are those of equilibrium. Not in one dimension, where equal
/// balls never change their velocities but only pass them on.
class VirialPressure {
 public:
  explicit VirialPressure(const Subject& subject);

  void collision(const Collision& c, double t, const Subject& subject);
  void end(double t);

  /// pressure.Z, pressure.virial, pressure.kT and, above one dimension, pressure.Z_rate.
  [[nodiscard]] Estimates estimates() const;

  /// D_f of a subject; 0: it has no temperature.
  [[nodiscard]] static double degrees_of_freedom(const Subject& subject);

 private:
  void pass(double t);

  int dimension_;
  double count_, volume_, freedom_;
  double speed_factor_;  // c sqrt(2 pi)
  double kinetic_;       // now
  double last_ = 0.0;
  BlockSums<4> sums_;  // time; kinetic energy x time; sum r J; the same from the rate
};

}  // namespace carom
