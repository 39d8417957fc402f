#pragma once
// The boundary map of a billiard: where and at what angle each collision comes, as rows of a table.

#include <array>
#include <memory>

#include "carom/observe/boundary.hpp"
#include "carom/observe/observer.hpp"
#include "carom/observe/row_outlet.hpp"

namespace carom {

/// Rows: arclength [length] and sine as in Bounce, wall and feature (Boundary::Piece), ball, time [time].
class BoundaryMap {
 public:
  BoundaryMap(std::shared_ptr<const Boundary> boundary, const RowOutlet& outlet)
      : boundary_(std::move(boundary)), outlet_(&outlet) {}

  static std::vector<std::string> columns() { return {"arclength", "sine", "wall", "feature", "ball", "time"}; }

  void collision(const Collision& c, double, const Subject& subject) {
    if (!outlet_->open()) return;
    const std::optional<Bounce> b = boundary_->bounce(c, subject);
    if (!b) return;
    const Boundary::Piece& piece = boundary_->pieces()[b->piece];
    (*outlet_)(std::array{b->arclength, b->sine, static_cast<double>(piece.wall), static_cast<double>(piece.feature),
                          static_cast<double>(b->ball), c.time});
  }
  void end(double) {}
  [[nodiscard]] Estimates estimates() const { return {}; }

 private:
  std::shared_ptr<const Boundary> boundary_;
  const RowOutlet* outlet_;
};

}  // namespace carom
