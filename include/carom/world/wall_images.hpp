#pragma once
// Walls in a periodic space stand in every period: where, and which of them are near a place.

#include <cmath>

#include "carom/core/double_double.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// The piece as it stands n periods away: each coordinate rounded once, so that ends which are one place in the plane are the
/// same numbers.
template <class Real, int D, class Shape>
[[nodiscard]] inline Shape moved_by(const Space<Real, D>& space, Shape shape, const Image<D>& n) {
  const auto move = [&](Vec<Real, D>& x) {
    for (int k = 0; k < D; ++k)
      if (n[k] != 0) x[k] = narrow(Wide<Real>(Wide<Real>(x[k]) + wide_product<Real>(Real(n[k]), space.edge[k])));
  };
  if constexpr (requires { shape.from; }) {
    move(shape.from);
    move(shape.to);
  }
  if constexpr (requires { shape.centre; }) move(shape.centre);
  if constexpr (requires { shape.point; }) move(shape.point);
  return shape;
}

/// Calls f(shape, placed) for a feature of a wall: as the world holds it, and as it stands in period n.
template <class Real, int D, class F>
inline void with_wall(const World<Real, D>& world, std::uint32_t wall, std::int32_t feature, const Image<D>& n, F&& f) {
  world.walls.with(wall, feature, [&](const auto& shape) {
    if (n == Image<D>{}) return f(shape, shape);
    f(shape, moved_by(world.space, shape, n));
  });
}

/// A point of the piece's own, and how far from it the piece reaches.
template <class Real>
[[nodiscard]] inline const Vec<Real, 2>& middle_of(const Segment<Real>& s) {
  return s.from;
}
template <class Real>
[[nodiscard]] inline Real reach_of(const Segment<Real>& s) {
  using std::sqrt;
  const Vec<Real, 2> along = s.to - s.from;
  return sqrt(dot<Real, 2>(along, along));
}
template <class Real, int D>
[[nodiscard]] inline const Vec<Real, D>& middle_of(const Sphere<Real, D>& s) {
  return s.centre;
}
template <class Real, int D>
[[nodiscard]] inline Real reach_of(const Sphere<Real, D>& s) {
  return s.radius;
}

template <class Real>
[[nodiscard]] inline const Vec<Real, 2>& middle_of(const Arc<Real>& s) {
  return s.centre;
}
template <class Real>
[[nodiscard]] inline Real reach_of(const Arc<Real>& s) {
  return s.radius;
}
template <class Shape>
  requires requires(const Shape& s) { s.size(); }
[[nodiscard]] inline const auto& middle_of(const Shape& s) {
  return s.centre;
}
template <class Shape>
  requires requires(const Shape& s) { s.size(); }
[[nodiscard]] inline auto reach_of(const Shape& s) {
  return s.size();
}

/// Calls f(n) for every period n in which the piece may come closer than `distance` to x, or x is inside of it. Faces and
/// planes stand in none.
template <class Real, int D, class Shape, class F>
inline void for_each_image(const Space<Real, D>& space, const Shape& shape, const Vec<Real, D>& x, const Real& distance,
                           F&& f) {
  if constexpr (requires { reach_of(shape); }) {
    using std::ceil;
    using std::floor;
    const Vec<Real, D>& middle = middle_of(shape);
    const Real reach = reach_of(shape) + distance;
    Image<D> low, high, n;
    for (int k = 0; k < D; ++k) {  // |x - middle - n edge| <= reach, and one more for rounding
      low[k] = static_cast<std::int32_t>(floor((x[k] - middle[k] - reach) / space.edge[k]));
      high[k] = static_cast<std::int32_t>(ceil((x[k] - middle[k] + reach) / space.edge[k]));
    }
    n = low;
    while (true) {
      if (!(moved_by(space, shape, n).gap(x) > distance)) f(n);
      int k = 0;
      while (k < D && ++n[k] > high[k]) {
        n[k] = low[k];
        ++k;
      }
      if (k == D) return;
    }
  }
}

}  // namespace carom
