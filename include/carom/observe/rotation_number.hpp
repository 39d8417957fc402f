#pragma once
// How far round the boundary a ball gets from one collision to the next.

#include <cmath>
#include <limits>
#include <memory>

#include "carom/observe/block_rows.hpp"
#include "carom/observe/boundary.hpp"
#include "carom/observe/observer.hpp"

namespace carom {

/// rotation_number [-], 0..1: the mean, over collisions and balls, of the part of the boundary passed anticlockwise from one
/// collision to the next. In a convex table every orbit has one [Birkhoff1927]; p/q for a periodic orbit that closes after q
/// collisions and p turns; (pi - 2 alpha) / (2 pi) in a circle that is hit at the angle alpha.
class RotationNumber {
 public:
  RotationNumber(std::shared_ptr<const Boundary> boundary, const Subject& subject)
      : boundary_(std::move(boundary)), last_(subject.mass.size(), std::numeric_limits<double>::quiet_NaN()) {}

  void collision(const Collision& c, double, const Subject& subject) {
    const std::optional<Bounce> b = boundary_->bounce(c, subject);
    if (!b) return;
    double turn = (b->arclength - last_[b->ball]) / boundary_->length();
    last_[b->ball] = b->arclength;
    if (std::isnan(turn)) return;
    if (turn < 0) turn += 1;
    const std::span<double> sums = sums_.row(steps_++);
    sums[0] += turn;
    sums[1] += 1;
  }
  void end(double) {}
  [[nodiscard]] Estimates estimates() const {
    return {sums_.estimate("rotation_number", [](BlockRows::Row row) { return row[0] / row[1]; })};
  }

 private:
  std::shared_ptr<const Boundary> boundary_;
  std::vector<double> last_;  // by ball: arclength; NaN: none
  BlockRows sums_{2};         // turns, steps
  std::size_t steps_ = 0;
};

}  // namespace carom
