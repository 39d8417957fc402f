#pragma once
// A part of a parabola in the plane, about its vertex; balls may be on either side.

#include <cstdint>

#include "carom/core/id.hpp"
#include "carom/shape/arclength.hpp"
#include "carom/shape/nearest.hpp"

namespace carom {

/// q^2 = 4 f p, |q| <= w, with p along `axis` from the vertex, q to its left. y(u) = (u^2 / 4 f, -u), so that the focus is to
/// the left.
template <class Real>
struct Parabola {
  WallId wall{};
  std::int32_t feature = 0;
  Vec<Real, 2> centre;    ///< [length unit] its vertex, at the world's start
  Vec<Real, 2> velocity;  ///< [length unit / L]
  Vec<Real, 2> axis;      ///< unit, from the vertex to the focus
  Real focal_length = Real(1), half_width = Real(1);  ///< [length unit]
  Arclength<Real> length{};                           ///< from the end where q = w

  /// r in its own frame.
  [[nodiscard]] Vec<Real, 2> framed(const Vec<Real, 2>& r) const {
    return Vec<Real, 2>(dot<Real, 2>(axis, r), cross2<Real>(axis, r));
  }
  [[nodiscard]] Vec<Real, 2> turned(const Real& along, const Real& across) const {
    return Vec<Real, 2>(axis[0] * along - axis[1] * across, axis[1] * along + axis[0] * across);
  }
  /// 4 f p - q^2: positive on the side of the focus.
  [[nodiscard]] Real form(const Vec<Real, 2>& r) const {
    const Vec<Real, 2> own = framed(r);
    return 4 * focal_length * own[0] - own[1] * own[1];
  }
  /// Towards the left of it, the focus, at x on it; of any length.
  [[nodiscard]] Vec<Real, 2> normal(const Vec<Real, 2>& x) const {
    return turned(Real(2 * focal_length), Real(-cross2<Real>(axis, Vec<Real, 2>(x - centre))));
  }
  /// The parameter of the place that is as far from the axis as r.
  [[nodiscard]] Real parameter(const Vec<Real, 2>& r) const { return -cross2<Real>(axis, r); }

  // Traced.
  [[nodiscard]] Vec<Real, 2> place(const Real& u) const { return turned(Real(u * u / (4 * focal_length)), Real(-u)); }
  [[nodiscard]] Vec<Real, 2> along(const Real& u) const { return turned(Real(u / (2 * focal_length)), Real(-1)); }
  [[nodiscard]] TracedFrame<Real> frame(const Real& u) const {
    return {place(u), along(u), Vec<Real, 2>(axis / Real(2 * focal_length))};
  }
  [[nodiscard]] Real begin() const { return -half_width; }
  [[nodiscard]] Real end() const { return half_width; }
  [[nodiscard]] bool closed() const { return false; }
  [[nodiscard]] Real bend_bound() const { return 1 / (2 * focal_length); }
  [[nodiscard]] Real twist_bound() const { return Real(0); }
  [[nodiscard]] Real size() const { return half_width + half_width * half_width / (4 * focal_length); }

  /// Distance to it.
  [[nodiscard]] Real gap(const Vec<Real, 2>& x) const {
    const Vec<Real, 2> r = x - centre;
    return length_of<Real>(Vec<Real, 2>(r - place(nearest_on<Real>(*this, r))));
  }
};

}  // namespace carom
