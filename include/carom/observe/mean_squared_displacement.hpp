#pragma once
// How far balls get in a time, and how they diffuse.

#include <cstdint>

#include "carom/observe/snapshot.hpp"
#include "carom/observe/lag_curve.hpp"
#include "carom/observe/origins.hpp"

namespace carom {

/// <|x(s + t) - x(s)|^2> over the balls of finite mass and over origins s, from unwrapped positions.
///   mean_squared_displacement.diffusion [length^2/time]: the slope over the second half of the lags, by least squares, over
///   2 d. It is the diffusion coefficient if balls diffuse at those lags; for N balls in a periodic cell it depends on N.
/// The same under the name of that coefficient: diffusion.coefficient, and the table "diffusion".
class MeanSquaredDisplacement {
 public:
  enum class Named : std::uint8_t { mean_squared_displacement, diffusion };

  /// Samples come every `step` [time].
  MeanSquaredDisplacement(int dimension, std::size_t lags, std::size_t origins, double step,
                          Named as = Named::mean_squared_displacement)
      : dimension_(dimension), as_(as), origins_(lags, origins), curve_(lags, step) {}

  void sample(const Snapshot& balls);
  [[nodiscard]] Estimates estimates() const;
  [[nodiscard]] Table table() const {
    return curve_.table(as_ == Named::diffusion ? "diffusion" : "mean_squared_displacement", "msd");
  }

 private:
  int dimension_;
  Named as_;
  Origins origins_;
  LagCurve curve_;
};

}  // namespace carom
