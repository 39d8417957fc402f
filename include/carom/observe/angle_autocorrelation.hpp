#pragma once
// How long balls remember their directions.

#include "carom/observe/lag_curve.hpp"
#include "carom/observe/origins.hpp"
#include "carom/observe/snapshot.hpp"

namespace carom {

/// <cos(theta(s + t) - theta(s))> = <v(s).v(s + t) / |v(s)| |v(s + t)|> over the balls of finite mass that move and over
/// origins s; 1 at t = 0.
///   angle_autocorrelation.time [time]: its integral from 0 to the last lag, by the trapezium rule.
class AngleAutocorrelation {
 public:
  /// Samples come every `step` [time].
  AngleAutocorrelation(std::size_t lags, std::size_t origins, double step) : origins_(lags, origins), curve_(lags, step) {}

  void sample(const Snapshot& balls);
  [[nodiscard]] Estimates estimates() const;
  [[nodiscard]] Table table() const { return curve_.table("angle_autocorrelation", "cosine"); }

 private:
  Origins origins_;
  LagCurve curve_;
  std::vector<Triple> directions_;
};

}  // namespace carom
