#pragma once
// How fast a rounding error grows along a run: the linearised motion, carried through every flight and collision.

#include <cstdint>

#include "carom/observe/tangent_flow.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// Small displacements of all positions, carried along by the tangent map (TangentFlow). Law "restitution" only. Few balls:
/// one displacement along each coordinate of each ball that moves, so the largest growth is found to within a factor
/// sqrt(N D); many: `most_vectors` random ones.
class TangentGrowth {
 public:
  static constexpr std::size_t most_vectors = 16;

  /// At the start of a run of `scene`. The displacements do not depend on anything but the scene.
  TangentGrowth(const Scene& scene, const Simulation& start);

  /// To be told every collision, in order.
  void collision(const Collision& c);

  /// Decimal digits by which the largest displacement of a ball has grown since the start, at the last collision.
  [[nodiscard]] double digits() const;

 private:
  TangentGrowth(const Scene& scene, const Subject& subject);

  int dimension_;
  TangentFlow flow_;
  double scaled_out_ = 0.0;  // decimal digits taken out so far
};

}  // namespace carom
