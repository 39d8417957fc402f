#pragma once
// Rounding must not carry a point through a curved wall that has two sides: as sides.hpp does for segments.

#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/predict/contact.hpp"
#include "carom/predict/sided.hpp"
#include "carom/world/state.hpp"
#include "carom/world/wall_images.hpp"

namespace carom {

/// How high a point is to the left of a two-sided curve, and whether that is within rounding of it.
template <class Real>
struct CurveHeight {
  Real height;
  bool near;    ///< so close to it, and to the span of it, that rounding may have carried it across
  bool at_end;  ///< as close to an end of it
};

/// How far rounding can put a stored point off its path, and the height that is computed of it off the truth.
template <class Real>
[[nodiscard]] inline Real height_doubt(const Arc<Real>& arc, const Vec<Real, 2>& x, const Real& reach) {
  return place_doubt<Real>(x, arc.from, arc.to) + 8 * unit_roundoff<Real>() * (reach + 2 * arc.radius);
}
template <class Real>
[[nodiscard]] inline Real height_doubt(const Parabola<Real>& parabola, const Vec<Real, 2>& x, const Real& reach) {
  return traced_doubt<Real>(parabola, Vec<Real, 2>(x - parabola.centre)) + 8 * unit_roundoff<Real>() * reach;
}

template <class Real>
[[nodiscard]] inline CurveHeight<Real> curve_height(const Arc<Real>& arc, const Vec<Real, 2>& x, const Real& reach) {
  using std::abs;
  const Real doubt = height_doubt(arc, x, reach);
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
  const Real doubt = height_doubt(parabola, x, reach);
  const Real height = parabola.form(r) / (2 * sqrt(Real(f * f + across * across)));
  const Real short_of = parabola.half_width - abs(across);
  return {height, abs(height) <= doubt && short_of >= -doubt, abs(short_of) <= doubt};
}

/// A point stored next to a curve that it did not hit holds the side that it came from, if its place alone does not say that side
/// any more, or is at an end of the curve, where another piece may go on.
template <class Real, int D>
class CurveSides {
 public:
  using WorldType = World<Real, D>;
  using Vector = Vec<Real, D>;

  /// Called before the state of ball i, a point, is written ...
  void note(const WorldType& world, std::uint32_t i) {
    noted_ = !(world.balls[i].radius > 0) && !(world.walls.arcs.empty() && world.walls.parabolas.empty());
    if (!noted_) return;
    velocity_ = world.balls[i].velocity;
    time_ = world.balls[i].time;
    image_ = world.details[i].image;
    held_.clear();
    if (world.balls[i].in_contact) held_ = world.details[i].contacts;
  }
  /// ... and after it. `normal` points away from what the ball has just hit, with any length.
  void keep(WorldType& world, std::uint32_t i, const Vector& normal) const {
    if (!noted_) return;
    const Vector came = velocity_then(world, elapsed(time_, world.balls[i].time));
    for_each_curve(world, [&](const auto& curve) {
      const Vector at = world.balls[i].position - curve.velocity * elapsed(world.start, world.balls[i].time);
      if (!world.space.periodic()) return keep_beside(world, i, curve, at, {}, came, normal);
      const Real near = 4 * height_doubt(curve, at, Real(world.details[i].reach + world.space.edge[0] + world.space.edge[1]));
      for_each_image(world.space, curve, at, near, [&](const Image<D>& image) {
        keep_beside(world, i, moved_by(world.space, curve, image), at, image, came, normal);
      });
    });
  }

 private:
  /// Beside a curve as it stands in period `image`.
  template <class Curve>
  void keep_beside(WorldType& world, std::uint32_t i, const Curve& curve, const Vector& at, const Image<D>& image,
                   const Vector& came, const Vector& normal) const {
    const CurveHeight<Real> now = curve_height<Real>(curve, at, world.details[i].reach);
    if (!now.near || wall_contact(world, i, index(curve.wall), curve.feature, image) != nullptr) return;
    Image<D> before = image;  // seen from where the ball was stored
    for (int k = 0; k < D; ++k) before[k] += static_cast<std::int32_t>(world.details[i].image[k] - image_[k]);
    std::int8_t side = 0;
    for (const Contact<D>& c : held_)
      if (c.with(Party::wall, index(curve.wall), curve.feature, before)) side = c.side;
    // A point at a curve has come from where it was not: down from the left, or from the right.
    const Real rise = dot<Real, D>(curve.normal(at), Vector(came - curve.velocity));
    if (side == 0) side = std::int8_t(rise < 0 ? 1 : rise > 0 ? -1 : 0);
    if (side == 0 || !(now.at_end ? in_reach(curve, at, normal) : side * now.height <= 0)) return;
    hold_contact(world, i, Contact<D>{Party::wall, index(curve.wall), curve.feature, image, side, false, 0, 0});
  }

  /// The velocity noted, after a flight of that length.
  [[nodiscard]] Vector velocity_then(const WorldType& world, const Real& flight) const {
    using std::cos;
    using std::sin;
    if (world.magnetic == 0) return velocity_ + world.acceleration * flight;
    const Real angle = world.magnetic * flight, c = cos(angle), s = sin(angle);
    return Vector(c * velocity_[0] - s * velocity_[1], s * velocity_[0] + c * velocity_[1]);
  }

  template <class F>
  static void for_each_curve(const WorldType& world, F&& f) {
    for (const auto& s : world.walls.arcs) f(s);
    for (const auto& s : world.walls.parabolas) f(s);
  }
  /// What runs away behind the surface that was hit is out of reach; where the pieces go on without a corner, none does.
  [[nodiscard]] static bool in_reach(const Arc<Real>& arc, const Vector& at, const Vector& normal) {
    if (arc.smooth_from || arc.smooth_to) return true;
    const Vector there = arc.centre + arc.middle() * (arc.radius / length_of<Real>(arc.middle())) - at;
    return dot<Real, D>(normal, Vector(arc.from - at)) > 0 || dot<Real, D>(normal, Vector(arc.to - at)) > 0 ||
           dot<Real, D>(normal, there) > 0;
  }
  [[nodiscard]] static bool in_reach(const Parabola<Real>& parabola, const Vector& at, const Vector& normal) {
    const Vector r = at - parabola.centre;
    return dot<Real, D>(normal, Vector(parabola.place(parabola.begin()) - r)) > 0 ||
           dot<Real, D>(normal, Vector(parabola.place(parabola.end()) - r)) > 0 || dot<Real, D>(normal, Vector(-r)) > 0;
  }

  std::vector<Contact<D>> held_;
  bool noted_ = false;
  Vector velocity_ = Vector::Zero();
  Time<Real> time_;
  Turns<D> image_{};
};

}  // namespace carom
