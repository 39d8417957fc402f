#pragma once
// Rounding must not carry a point through a wall: a point stored next to a segment holds the side that it flew on.

#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/predict/ball_wall.hpp"
#include "carom/predict/contact.hpp"
#include "carom/sim/curve_sides.hpp"
#include "carom/world/state.hpp"

namespace carom {

/// A point stored next to a segment that it did not hit may have been rounded across it, or past the end of it. It holds
/// the side that it flew on: it touches that segment, and hits it if it closes. So in a convex corner a point that hits one
/// edge as close to the vertex as rounding can tell has still the other edge before it, and cannot get out between the two.
template <class Real, int D>
class Sides {
 public:
  using WorldType = World<Real, D>;

  /// Called before the state of ball i is written ...
  void note(const WorldType& world, std::uint32_t i) {
    if constexpr (D == 2) {
      sides_.clear();
      curves_.note(world, i);
      const Ball<Real, D>& ball = world.balls[i];
      if (ball.radius > 0 || growth_of(world, i) > 0) return;
      if (world.space.periodic()) {
        before_ = ball;
        image_ = world.details[i].image;
        held_ = world.details[i].contacts;
        return;
      }
      for (const Segment<Real>& s : world.walls.segments) {
        const Contact<D>* held = wall_contact(world, i, index(s.wall), s.feature);
        const Real height = s.height(Vec<Real, D>(ball.position - drift(world, s, ball.time)));
        sides_.push_back(held != nullptr ? held->side : std::int8_t(height > 0 ? 1 : height < 0 ? -1 : 0));
      }
    }
  }
  /// ... and after it. `normal` points away from what the ball has just hit, with any length.
  void keep(WorldType& world, std::uint32_t i, const Vec<Real, D>& normal) const {
    if constexpr (D == 2) {
      curves_.keep(world, i, normal);
      if (world.space.periodic() && !(world.balls[i].radius > 0) && !(growth_of(world, i) > 0)) keep_in_periods(world, i, normal);
      for (std::size_t k = 0; k < sides_.size(); ++k) {
        const Segment<Real>& s = world.walls.segments[k];
        if (sides_[k] == 0 || !lost(world, i, s, sides_[k], normal)) continue;
        if (wall_contact(world, i, index(s.wall), s.feature) != nullptr) continue;
        hold_contact(world, i, Contact<D>{Party::wall, index(s.wall), s.feature, {}, sides_[k], false, 0, 0});
      }
    }
  }

 private:
  /// The same where each segment stands in every period.
  void keep_in_periods(WorldType& world, std::uint32_t i, const Vec<Real, 2>& normal) const {
    const Ball<Real, D>& ball = world.balls[i];
    for (const Segment<Real>& s : world.walls.segments)
      for_each_image(world.space, s, ball.position, position_doubt(ball.position, s, world.details[i].reach),
                     [&](const Image<D>& image) {
                       if (wall_contact(world, i, index(s.wall), s.feature, image) != nullptr) return;
                       Image<D> before = image;  // seen from where the ball was stored
                       for (int k = 0; k < D; ++k)
                         before[k] += static_cast<std::int32_t>(world.details[i].image[k] - image_[k]);
                       const std::int8_t side = side_before(world, s, before);
                       if (side == 0 || !lost(world, i, moved_by(world.space, s, image), side, normal)) return;
                       hold_contact(world, i, Contact<D>{Party::wall, index(s.wall), s.feature, image, side, false, 0, 0});
                     });
  }
  [[nodiscard]] std::int8_t side_before(const WorldType& world, const Segment<Real>& s, const Image<D>& image) const {
    for (const Contact<D>& c : held_)
      if (c.with(Party::wall, index(s.wall), s.feature, image)) return c.side;
    const Real height = moved_by(world.space, s, image).height(before_.position);
    return std::int8_t(height > 0 ? 1 : height < 0 ? -1 : 0);
  }

  /// The stored position alone does not say any more that the ball is on that side of the segment.
  [[nodiscard]] static bool lost(const WorldType& world, std::uint32_t i, const Segment<Real>& s, std::int8_t side,
                                 const Vec<Real, 2>& normal) {
    using std::abs;
    const Ball<Real, D>& ball = world.balls[i];
    const Vec<Real, 2> at = ball.position - drift(world, s, ball.time);
    const Real doubt = position_doubt(at, s, world.details[i].reach);
    const Real height = s.height(at);
    if (abs(height) > doubt) return false;  // on its side, or flown across the line, beside the segment
    const Real before = dot<Real, 2>(s.along, at - s.from), beyond = dot<Real, 2>(s.along, at - s.to);
    if (before < -doubt || beyond > doubt) return false;
    const bool at_an_end = before < doubt || beyond > -doubt;
    if (!at_an_end) return side * height <= 0;
    if (s.smooth_from || s.smooth_to) return true;  // what was hit may be the piece that goes on from here
    // What runs away behind the surface that was hit is out of reach.
    return dot<Real, 2>(normal, s.from - at) > 0 || dot<Real, 2>(normal, s.to - at) > 0;
  }

  /// How far rounding can put a stored point off its path, and the height that is computed of it off the truth: at most 8 u
  /// of the coordinates in play, those that its flight began at among them (two roundings of the advance, three of the
  /// height).
  [[nodiscard]] static Real position_doubt(const Vec<Real, 2>& at, const Segment<Real>& s, const Real& reach) {
    using std::abs;
    return 8 * unit_roundoff<Real>() *
           (reach + abs(at[0]) + abs(at[1]) + abs(s.from[0]) + abs(s.from[1]) + abs(s.to[0]) + abs(s.to[1]));
  }

  std::vector<std::int8_t> sides_;  // of a point, by segment; in a periodic space the three below
  Ball<Real, D> before_;
  Turns<D> image_{};
  std::vector<Contact<D>> held_;
  CurveSides<Real, D> curves_;
};

}  // namespace carom
