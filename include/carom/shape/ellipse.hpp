#pragma once
// An ellipse in the plane, with the balls inside or outside of it.

#include <array>
#include <cstdint>

#include "carom/core/angle.hpp"
#include "carom/core/double_double.hpp"
#include "carom/core/id.hpp"
#include "carom/shape/arclength.hpp"
#include "carom/shape/nearest.hpp"

namespace carom {

/// (p / a)^2 + (q / b)^2 = 1, with p along `axis` and q to its left. y(u) = (a cos u, b sin u).
template <class Real>
struct Ellipse {
  WallId wall{};
  std::int32_t feature = 0;
  Vec<Real, 2> centre;    ///< [length unit] at the world's start
  Vec<Real, 2> velocity;  ///< [length unit / L]
  Vec<Real, 2> axis;      ///< unit, of the first semi-axis
  Real a = Real(1), b = Real(1);  ///< [length unit] semi-axes
  Real round = Real(0);           ///< 2 pi
  bool inside = true;             ///< the balls are inside
  Arclength<Real> length{};       ///< from the end of the first semi-axis, anticlockwise

  /// r in the frame in which the ellipse is a circle of radius 1: straight paths stay straight, parabolas parabolas.
  [[nodiscard]] Vec<Real, 2> rounded(const Vec<Real, 2>& r) const {
    return Vec<Real, 2>(dot<Real, 2>(axis, r) / a, cross2<Real>(axis, r) / b);
  }
  [[nodiscard]] Vec<Real, 2> turned(const Real& along, const Real& across) const {
    return Vec<Real, 2>(axis[0] * along - axis[1] * across, axis[1] * along + axis[0] * across);
  }
  /// Towards the balls at r on it, of any length, in twice the precision: -+ the gradient of (p / a)^2 + (q / b)^2. A direction
  /// that is rounded the same way over half of the ellipse would let an orbit's caustic drift.
  [[nodiscard]] std::array<Wide<Real>, 2> normal(const Vec<Real, 2>& r) const {
    using W = Wide<Real>;
    const W flatness = W(b) / W(a);
    const W p = wide_dot<Real, 2>(axis, r) * flatness;
    const W q = W(wide_product<Real>(axis[0], r[1]) - wide_product<Real>(axis[1], r[0])) / flatness;
    const W x = p * W(axis[0]) - q * W(axis[1]), y = p * W(axis[1]) + q * W(axis[0]);
    return inside ? std::array<W, 2>{W(-x), W(-y)} : std::array<W, 2>{x, y};
  }
  /// The parameter of the place that is reached by stretching r.
  [[nodiscard]] Real parameter(const Vec<Real, 2>& r) const { return angle_of<Real>(rounded(r)); }

  // Traced.
  [[nodiscard]] Vec<Real, 2> place(const Real& u) const {
    using std::cos;
    using std::sin;
    return turned(Real(a * cos(u)), Real(b * sin(u)));
  }
  [[nodiscard]] Vec<Real, 2> along(const Real& u) const {
    using std::cos;
    using std::sin;
    return turned(Real(-a * sin(u)), Real(b * cos(u)));
  }
  [[nodiscard]] TracedFrame<Real> frame(const Real& u) const {
    using std::cos;
    using std::sin;
    const Real c = cos(u), s = sin(u);
    const Vec<Real, 2> place = turned(Real(a * c), Real(b * s));
    return {place, turned(Real(-a * s), Real(b * c)), Vec<Real, 2>(-place)};
  }
  [[nodiscard]] Real begin() const { return Real(0); }
  [[nodiscard]] Real end() const { return round; }
  [[nodiscard]] bool closed() const { return true; }
  [[nodiscard]] Real bend_bound() const { return a < b ? b : a; }
  [[nodiscard]] Real twist_bound() const { return a < b ? b : a; }
  [[nodiscard]] Real size() const { return a < b ? b : a; }

  [[nodiscard]] std::int8_t home() const { return inside ? 1 : -1; }
  [[nodiscard]] bool within(const Vec<Real, 2>& r) const {
    const Vec<Real, 2> c = rounded(r);
    return dot<Real, 2>(c, c) < 1;
  }
  /// Distance from it; < 0 on the side where the balls are not.
  [[nodiscard]] Real gap(const Vec<Real, 2>& x) const {
    const Vec<Real, 2> r = x - centre;
    const Real distance = length_of<Real>(Vec<Real, 2>(r - place(nearest_on<Real>(*this, r))));
    return within(r) == inside ? distance : Real(-distance);
  }
};

}  // namespace carom
