#pragma once
// Rounding must not carry a point through a wall: a point stored next to a segment holds the side that it flew on.

#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/predict/ball_wall.hpp"
#include "carom/predict/contact.hpp"
#include "carom/world/state.hpp"

namespace carom {

/// A point stored next to a segment that it did not hit may have been rounded across it. It holds the side that it flew
/// on: it touches that segment, and hits it if it closes.
template <class Real, int D>
class Sides {
 public:
  using WorldType = World<Real, D>;

  /// Called before the state of ball i is written ...
  void note(const WorldType& world, std::uint32_t i) {
    if constexpr (D == 2) {
      sides_.clear();
      const Ball<Real, D>& ball = world.balls[i];
      if (ball.radius > 0) return;
      for (const Segment<Real>& s : world.walls.segments) {
        const Contact<D>* held = wall_contact(world, i, index(s.wall), s.feature);
        const Real height = s.height(Vec<Real, D>(ball.position - drift(world, s, ball.time)));
        sides_.push_back(held != nullptr ? held->side : std::int8_t(height > 0 ? 1 : height < 0 ? -1 : 0));
      }
    }
  }
  /// ... and after it.
  void keep(WorldType& world, std::uint32_t i) const {
    using std::abs;
    if constexpr (D == 2) {
      const Ball<Real, D>& ball = world.balls[i];
      for (std::size_t k = 0; k < sides_.size(); ++k) {
        const Segment<Real>& s = world.walls.segments[k];
        const Vec<Real, D> at = ball.position - drift(world, s, ball.time);
        if (sides_[k] == 0 || sides_[k] * s.height(at) > 0) continue;
        if (abs(s.height(at)) > position_doubt(at, s)) continue;  // it flew across the line, beside the segment
        if (dot<Real, D>(s.along, at - s.from) < 0 || dot<Real, D>(s.along, at - s.to) > 0) continue;
        if (wall_contact(world, i, index(s.wall), s.feature) != nullptr) continue;
        hold_contact(world, i, Contact<D>{Party::wall, index(s.wall), s.feature, {}, sides_[k], false, 0, 0});
      }
    }
  }

 private:
  /// How far rounding can put a stored point off its path, and the height that is computed of it off the truth: at most 8 u
  /// of the coordinates in play (two roundings of the advance, three of the height).
  [[nodiscard]] static Real position_doubt(const Vec<Real, 2>& at, const Segment<Real>& s) {
    using std::abs;
    return 8 * unit_roundoff<Real>() * (abs(at[0]) + abs(at[1]) + abs(s.from[0]) + abs(s.from[1]));
  }

  std::vector<std::int8_t> sides_;  // of a point, by segment
};

}  // namespace carom
