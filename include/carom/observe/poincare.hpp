#pragma once
// Where and how fast balls cross a line.

#include <array>
#include <vector>

#include "carom/observe/block_sums.hpp"
#include "carom/observe/observer.hpp"
#include "carom/observe/row_outlet.hpp"
#include "carom/scene/scene.hpp"

namespace carom {

/// Crossings of the line through `point` across `normal`, in the direction of `normal`, by the exact flight between two
/// collisions; in a periodic space, of the line and its images. With e the direction of the line, `normal` turned by -90
/// degrees, rows: position e.(x - point) [length] (periodic: modulo the period), velocity e.v [length/time], ball,
/// time [time].
///   poincare.rate [1/time]: crossings of all balls over time.
/// A collision on the line belongs to the flight that ends there.
class Poincare {
 public:
  Poincare(const PoincareSpec& spec, const RowOutlet& outlet, const Subject& subject);

  /// Why it has no meaning; empty: it has one.
  [[nodiscard]] static std::string refusal(const PoincareSpec& spec, const Subject& subject);
  static std::vector<std::string> columns() { return {"position", "velocity", "ball", "time"}; }

  void flight(const Flight& f);
  void collision(const Collision&, double, const Subject&) {}
  void end(double t);
  [[nodiscard]] Estimates estimates() const;

 private:
  void crossings(const Flight& f, double from, double to, double s_from, double s_to);
  void round(const Flight& f);
  void crossed(const Flight& f, double s);

  const RowOutlet* outlet_;
  std::array<double, 2> point_{}, normal_{}, along_{};
  double period_ = 0.0, across_ = 0.0;  // [length] of the images of the line, and along it; 0: none
  double began_;                        // [time]
  BlockSums<2> sums_;                   // time, crossings
};

}  // namespace carom
