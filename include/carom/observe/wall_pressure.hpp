#pragma once
// The pressure on the faces of a box.

#include <array>
#include <string>

#include "carom/observe/block_sums.hpp"
#include "carom/observe/observer.hpp"

namespace carom {

/// pressure.wall: momentum that the balls give to all faces, over time and the area of all faces; pressure.face.x-, ...:
/// the same for one face. The area of a face is that of the box (its length in 2-D; 1 in 1-D, where a pressure is a force).
class WallPressure {
 public:
  explicit WallPressure(const Subject& subject);

  void collision(const Collision& c, double t, const Subject& subject);
  void end(double t);
  [[nodiscard]] Estimates estimates() const;

 private:
  static constexpr std::size_t most_faces = 6;

  void pass(double t);

  std::size_t faces_;
  std::array<double, most_faces> area_{};
  double last_ = 0.0;
  BlockSums<1 + most_faces> sums_;  // time; impulse on each face: x-, x+, y-, ...
};

}  // namespace carom
