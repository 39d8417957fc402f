#pragma once
// How long balls remember their velocities.

#include "carom/observe/snapshot.hpp"
#include "carom/observe/lag_curve.hpp"
#include "carom/observe/origins.hpp"

namespace carom {

/// C(t) = <v(s) . v(s + t)> over the balls of finite mass and over origins s; C(0) = d kT/m in equilibrium.
///   velocity_autocorrelation.initial: C(0).
///   velocity_autocorrelation.diffusion [length^2/time]: the integral of C from 0 to the last lag, over d (Green and Kubo),
///   by the trapezium rule. What C holds beyond the last lag is missing.
class VelocityAutocorrelation {
 public:
  /// Samples come every `step` [time].
  VelocityAutocorrelation(int dimension, std::size_t lags, std::size_t origins, double step)
      : dimension_(dimension), origins_(lags, origins), curve_(lags, step) {}

  void sample(const Snapshot& balls);
  [[nodiscard]] Estimates estimates() const;
  [[nodiscard]] Table table() const { return curve_.table("velocity_autocorrelation", "vacf"); }

 private:
  int dimension_;
  Origins origins_;
  LagCurve curve_;
};

}  // namespace carom
