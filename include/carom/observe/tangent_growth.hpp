#pragma once
// How fast a rounding error grows along a run: the linearised motion, carried through every flight and collision.

#include <array>
#include <cstdint>
#include <vector>

#include "carom/sim/simulation.hpp"

namespace carom {

/// Small displacements of all positions, carried along by the tangent map of flights and impacts [Dellago1996;
/// papers/tangent_map.md, eq. 3, 6, 7]. Law "restitution" only. Few balls: one displacement along each coordinate of each
/// ball that moves, so the largest growth is found to within a factor sqrt(N D); many: `most_vectors` random ones.
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
  using Vector = std::array<double, 3>;
  struct Displacement {
    Vector x{}, v{};  // at the ball's last collision
  };
  struct Moment {
    std::int64_t epoch = 0;
    double offset = 0.0;
  };
  struct BallFacts {
    double radius = 0.0, mass = 1.0;
    bool finite = true;   // mass
    bool falls = false;   // under the uniform acceleration
    Moment since;
  };

  [[nodiscard]] double elapsed(const Moment& from, const Moment& to) const;
  [[nodiscard]] double curvature_radius(const Collision& c) const;
  void fly(std::uint32_t ball, const Moment& now);
  void impact(const Collision& c, std::size_t vector);
  void rescale();
  [[nodiscard]] Displacement& at(std::size_t vector, std::uint32_t ball) { return displacements_[vector * balls_.size() + ball]; }

  int dimension_;
  double epoch_length_;
  Vector acceleration_{};
  std::vector<BallFacts> balls_;
  std::vector<Displacement> displacements_;  // by vector, by ball
  std::size_t vectors_ = 0;
  Moment now_;
  double scaled_out_ = 0.0;  // decimal digits taken out so far
};

}  // namespace carom
