#pragma once
// What a ball conserves inside a circle or an ellipse: the curve that its path is tangent to.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "carom/observe/observer.hpp"
#include "carom/scene/scene.hpp"

namespace carom {

/// Of a ball after each of its collisions with the table
///   circles about one centre c:  L = (x - c) x v / |v| [length], the signed radius of the circular caustic;
///   the same in a magnetic field: the distance of the centre of gyration from c [length];
///   ellipse, for a point: L1 L2 / |v|^2 [length^2], L1 and L2 the angular momenta about the foci: b^2 - lambda of the
///   confocal caustic x^2 / (a^2 - lambda) + y^2 / (b^2 - lambda) = 1 [Tabachnikov2005, ch. 4].
/// caustic.invariant: its mean, [i] for ball i where there are several. caustic.spread: the largest less the smallest value of
/// one ball; rounding where it is conserved.
class Caustic {
 public:
  Caustic(const Scene& scene, const Subject& subject);

  /// Why the scene has none; empty: it has one.
  [[nodiscard]] static std::string refusal(const Scene& scene, const Subject& subject);

  void collision(const Collision& c, double t, const Subject& subject);
  void end(double) {}
  [[nodiscard]] Estimates estimates() const;

 private:
  struct Seen {
    double sum = 0.0, count = 0.0, least = 0.0, most = 0.0;
  };

  [[nodiscard]] double invariant(const Collision::Party& ball) const;

  std::array<double, 2> first_{}, second_{};  // [length] the foci, or the centre twice
  bool ellipse_ = false;
  double magnetic_ = 0.0;
  std::vector<Seen> seen_;  // by ball
};

}  // namespace carom
