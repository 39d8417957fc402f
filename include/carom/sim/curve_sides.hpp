#pragma once
// Rounding must not carry a point through a curved wall that has two sides: as sides.hpp does for segments.

#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/predict/contact.hpp"
#include "carom/predict/sided.hpp"
#include "carom/world/state.hpp"

namespace carom {

/// How high a point is to the left of a two-sided curve, and whether that is within rounding of it.
template <class Real>
struct CurveHeight {
  Real height;
  bool near;    ///< so close to it, and to the span of it, that rounding may have carried it across
  bool at_end;  ///< as close to an end of it
};

template <class Real>
[[nodiscard]] inline CurveHeight<Real> curve_height(const Arc<Real>& arc, const Vec<Real, 2>& x, const Real& reach) {
  using std::abs;
  const Real doubt = place_doubt<Real>(x, arc.from, arc.to) + 8 * unit_roundoff<Real>() * (reach + 2 * arc.radius);
  const Real height = arc.height(x);
  const auto at = [&](const Vec<Real, 2>& end) { return abs(x[0] - end[0]) <= 2 * doubt && abs(x[1] - end[1]) <= 2 * doubt; };
  const bool at_end = !arc.whole && (at(arc.from) || at(arc.to));
  return {height, abs(height) <= doubt && (at_end || arc.spans(Vec<Real, 2>(x - arc.centre), doubt)), at_end};
}

template <class Real>
[[nodiscard]] inline CurveHeight<Real> curve_height(const Parabola<Real>& parabola, const Vec<Real, 2>& x, const Real& reach) {
  using std::abs;
  using std::sqrt;
  const Vec<Real, 2> r = x - parabola.centre;
  const Real across = cross2<Real>(parabola.axis, r), f = 2 * parabola.focal_length;
  const Real doubt = traced_doubt<Real>(parabola, r) + 8 * unit_roundoff<Real>() * reach;
  const Real height = parabola.form(r) / (2 * sqrt(Real(f * f + across * across)));
  const Real short_of = parabola.half_width - abs(across);
  return {height, abs(height) <= doubt && short_of >= -doubt, abs(short_of) <= doubt};
}

/// In a space that is not periodic: a point stored next to a curve that it did not hit holds the side that it flew on, if its place alone does not say that
/// side any more, or is at an end of the curve, where another piece may go on.
template <class Real, int D>
class CurveSides {
 public:
  using WorldType = World<Real, D>;

  /// Called before the state of ball i, a point, is written ...
  void note(const WorldType& world, std::uint32_t i) {
    sides_.clear();
    if (world.balls[i].radius > 0 || world.space.periodic()) return;
    for_each_curve(world, [&](const auto& curve) {
      const Contact<D>* held = wall_contact(world, i, index(curve.wall), curve.feature);
      const Real height = height_of(world, i, curve).height;
      sides_.push_back(held != nullptr ? held->side : std::int8_t(height > 0 ? 1 : height < 0 ? -1 : 0));
    });
  }
  /// ... and after it.
  void keep(WorldType& world, std::uint32_t i) const {
    if (sides_.empty()) return;
    std::size_t k = 0;
    for_each_curve(world, [&](const auto& curve) {
      const std::int8_t side = sides_[k++];
      const CurveHeight<Real> now = height_of(world, i, curve);
      if (side == 0 || !now.near || !(now.at_end || side * now.height <= 0)) return;
      if (wall_contact(world, i, index(curve.wall), curve.feature) != nullptr) return;
      hold_contact(world, i, Contact<D>{Party::wall, index(curve.wall), curve.feature, {}, side, false, 0, 0});
    });
  }

 private:
  template <class F>
  static void for_each_curve(const WorldType& world, F&& f) {
    for (const auto& s : world.walls.arcs) f(s);
    for (const auto& s : world.walls.parabolas) f(s);
  }
  template <class Shape>
  [[nodiscard]] static CurveHeight<Real> height_of(const WorldType& world, std::uint32_t i, const Shape& shape) {
    const Vec<Real, D> at = world.balls[i].position - shape.velocity * elapsed(world.start, world.balls[i].time);
    return curve_height<Real>(shape, at, world.details[i].reach);
  }

  std::vector<std::int8_t> sides_;  // by curve
};

}  // namespace carom
