#pragma once
// How a ball touches a wall at a place: the direction of the impulse, the gap left, and the shape of the wall there.

#include <array>

#include "carom/core/double_double.hpp"
#include "carom/shape/curved.hpp"
#include "carom/sim/wall_party.hpp"

namespace carom {

/// A ball's centre at a wall, in the frame of the wall.
template <class Real, int D>
struct WallTouch {
  std::array<Wide<Real>, D> into_wall;  ///< from the ball to the wall, of any length
  Real gap;                             ///< [length unit] between the surfaces
  bool singular = false;                ///< a point at a vertex or a cusp: there is no normal

  WallTouch(const std::array<Wide<Real>, D>& direction, const Real& between) : into_wall(direction), gap(between) {}
  /// n: towards the ball.
  WallTouch(const Vec<Real, D>& n, const Real& between, bool no_normal) : gap(between), singular(no_normal) {
    for (int k = 0; k < D; ++k) into_wall[k] = Wide<Real>(Real(-n[k]));
  }
};

template <class Real, int D, class Shape>
[[nodiscard]] inline WallTouch<Real, D> wall_touch(const Shape& shape, const Vec<Real, D>& at, const Real& radius,
                                                   std::int8_t side) {
  return {towards_ball<Real, D>(shape, at, side), Real(shape.gap(at) - radius), singular_contact<Real, D>(shape, radius)};
}

/// A piece of an arc is met between its ends, which are vertices of their own.
template <class Real>
[[nodiscard]] inline WallTouch<Real, 2> arc_touch(const Arc<Real>& arc, const Vec<Real, 2>& at, const Real& radius,
                                                  std::int8_t side) {
  using std::abs;
  return {Vec<Real, 2>(arc.normal(at) * Real(side)), Real(abs(arc.height(at)) - radius), false};
}

/// A point at an ellipse; what its place is off the ellipse is off by a rounding.
template <class Real>
[[nodiscard]] inline WallTouch<Real, 2> point_touch(const Ellipse<Real>& ellipse, const Vec<Real, 2>& r) {
  using std::abs;
  using std::sqrt;
  std::array<Wide<Real>, 2> into = ellipse.normal(r);
  for (Wide<Real>& component : into) component = -component;
  const Vec<Real, 2> c = ellipse.rounded(r);
  const Real across = narrow(into[0]), along = narrow(into[1]);
  // (|c|^2 - 1) / |grad |c|^2|, and the gradient is 2 / (a b) times the normal.
  const Real gap = (dot<Real, 2>(c, c) - 1) * ellipse.a * ellipse.b / (2 * sqrt(Real(across * across + along * along)));
  return {into, Real(abs(gap))};
}

/// The parameter of the place where a ball touches a traced curve.
template <class Real, class Curve>
[[nodiscard]] inline Real touched_parameter(const Curve& curve, const Vec<Real, 2>& r, const Real& radius) {
  if constexpr (requires { curve.parameter(r); })
    if (!(radius > 0)) return curve.parameter(r);
  return nearest_on<Real>(curve, r);
}

template <class Real, class Curve>
[[nodiscard]] inline WallTouch<Real, 2> traced_touch(const Curve& curve, const Vec<Real, 2>& at, const Real& radius,
                                                     std::int8_t side) {
  using std::abs;
  const Vec<Real, 2> r = at - curve.centre;
  if constexpr (std::is_same_v<Curve, Ellipse<Real>>)
    if (!(radius > 0)) return point_touch<Real>(curve, r);
  const Real u = touched_parameter<Real>(curve, r, radius);
  const Vec<Real, 2> from_wall = r - curve.place(u);
  if (radius > 0) return {from_wall, Real(length_of<Real>(from_wall) - radius), false};
  const Vec<Real, 2> along = curve.along(u), left(-along[1], along[0]);
  const Real stretch = length_of<Real>(along);
  // Where the curve hardly moves with its parameter, rounding of the place is more than its direction bears: a cusp.
  if (!(stretch * stretch > curve.bend_bound() * traced_doubt<Real>(curve, r))) return {left, Real(0), true};
  return {Vec<Real, 2>(left * Real(side)), Real(abs(dot<Real, 2>(left, from_wall)) / stretch), false};
}

/// The curvature of a traced curve at u [1/length unit], > 0 where it bends away from a ball on that side.
template <class Real, class Curve>
[[nodiscard]] inline Real traced_curvature(const Curve& curve, const Real& u, std::int8_t side) {
  const Vec<Real, 2> along = curve.along(u);
  const Real stretch = length_of<Real>(along);
  return -Real(side) * cross2<Real>(along, curve.frame(u).bend) / (stretch * stretch * stretch);
}

template <class Real, int D, class Shape>
[[nodiscard]] inline WallTouch<Real, D> touch_at(const Shape& shape, const Vec<Real, D>& at, const Real& radius,
                                                 std::int8_t side) {
  if constexpr (std::is_same_v<Shape, Arc<Real>>) {
    return arc_touch<Real>(shape, at, radius, side);
  } else if constexpr (is_curved<Shape>) {
    return traced_touch<Real>(shape, at, radius, side);
  } else {
    return wall_touch<Real, D>(shape, at, radius, side);
  }
}

}  // namespace carom
