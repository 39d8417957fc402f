#pragma once
// Small displacements of all balls, carried along a run.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "carom/core/clock.hpp"
#include "carom/observe/subject.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// Some displacements (dx, dv) of every ball of finite mass, each carried through the flights and impacts of a run by their
/// exact derivative [Dellago1996; papers/tangent_map.md]: law "restitution" at a constant e, walls of any curvature, at rest
/// or moving. Every ball has a moment of its own, its last collision. Cost of a collision: about 20 D operations a
/// displacement and ball.
class TangentFlow {
 public:
  /// `count` displacements, all 0, at subject.moment. dv is held in lengths over `unit` [time].
  TangentFlow(const Scene& scene, const Subject& subject, std::size_t count, double unit = 1.0);

  /// To be told every collision, in order.
  void collision(const Collision& c);

  /// Every ball flies on to `now`, which no collision precedes that was not told.
  void advance_to(const Time<double>& now);

  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  /// Balls of finite mass, in the order of their numbers: "movers".
  [[nodiscard]] std::size_t movers() const noexcept { return since_.size(); }
  /// The mover's number of a ball; movers() or more: its mass is infinite.
  [[nodiscard]] std::size_t mover(std::uint32_t ball) const { return mover_[ball]; }

  /// All rows, mover by mover: component by component of dx, then of dv; a row is one number for each displacement.
  [[nodiscard]] std::span<double> rows() noexcept { return rows_; }
  [[nodiscard]] std::size_t row_count() const noexcept { return 2 * static_cast<std::size_t>(dimension_) * movers(); }
  /// dx (component < D) or dv of a mover, at its own moment.
  [[nodiscard]] std::span<double> row(std::size_t mover, std::size_t component) {
    return std::span(rows_).subspan((mover * 2 * static_cast<std::size_t>(dimension_) + component) * count_, count_);
  }
  /// The largest number, in size, of the rows of the last collision's parties.
  [[nodiscard]] double largest_of_last() const;
  [[nodiscard]] const Time<double>& last() const noexcept { return last_; }

 private:
  struct BallFacts {
    double radius = 0.0, mass = 1.0;
    bool pulled = true;  // by the uniform acceleration and the magnetic field
  };

  template <int D>
  void fly(std::size_t mover, const Time<double>& now);
  template <int D>
  void impact(const Collision& c);
  [[nodiscard]] Triple wall_acceleration(std::uint32_t wall, double time) const;
  [[nodiscard]] double* rows_of(std::size_t mover) {
    return rows_.data() + mover * 2 * static_cast<std::size_t>(dimension_) * count_;
  }

  int dimension_;
  std::size_t count_;
  double unit_, epoch_length_;  // [time]
  double magnetic_;             // [rad/time]
  Triple acceleration_;         // [length/time^2]
  std::vector<BallFacts> balls_;         // by number
  std::vector<std::size_t> mover_;       // by number
  std::vector<Time<double>> since_;      // by mover
  struct Swing {
    Triple amplitude{};
    double omega = 0.0, phase = 0.0;
  };
  std::vector<Swing> swings_;  // by wall; empty: no wall swings
  std::vector<double> rows_;
  Time<double> last_;
  std::array<std::size_t, 2> touched_{};  // movers of the last collision
};

}  // namespace carom
