#pragma once
// The flat pieces of the walls that a ball can rest on, counted from 1: faces, planes, segments and edges of polygons.

#include "carom/world/world.hpp"

namespace carom {

template <class Real, int D>
[[nodiscard]] inline std::size_t flat_count(const Walls<Real, D>& walls) {
  return walls.faces.size() + walls.planes.size() + walls.segments.size();
}

/// A ball's `held` is one byte.
inline constexpr std::size_t most_flat_walls = 255;

/// Number of a piece that stands in `walls`; 0 if it is not flat.
template <class Real, int D>
[[nodiscard]] inline std::size_t flat_number(const Walls<Real, D>& walls, const Face<Real, D>& s) {
  return static_cast<std::size_t>(&s - walls.faces.data()) + 1;
}
template <class Real, int D>
[[nodiscard]] inline std::size_t flat_number(const Walls<Real, D>& walls, const Plane<Real, D>& s) {
  return walls.faces.size() + static_cast<std::size_t>(&s - walls.planes.data()) + 1;
}
template <class Real, int D>
[[nodiscard]] inline std::size_t flat_number(const Walls<Real, D>& walls, const Segment<Real>& s) {
  return walls.faces.size() + walls.planes.size() + static_cast<std::size_t>(&s - walls.segments.data()) + 1;
}
template <class Real, int D>
[[nodiscard]] inline std::size_t flat_number(const Walls<Real, D>&, const Sphere<Real, D>&) {
  return 0;
}

template <class Real, int D, class Shape>
  requires is_curved<Shape>
[[nodiscard]] inline std::size_t flat_number(const Walls<Real, D>&, const Shape&) {
  return 0;
}

/// Calls f(piece) for the flat piece `number`.
template <class Real, int D, class F>
inline void with_flat(const Walls<Real, D>& walls, std::size_t number, F&& f) {
  std::size_t k = number - 1;
  if (k < walls.faces.size()) return f(walls.faces[k]);
  k -= walls.faces.size();
  if (k < walls.planes.size()) return f(walls.planes[k]);
  if constexpr (D == 2) f(walls.segments[k - walls.planes.size()]);
}

/// Normal of a flat piece, of length 1 but for rounding, towards the side that `a` presses a ball from.
template <class Real, int D, class Shape>
[[nodiscard]] inline Vec<Real, D> normal_against(const Shape& shape, const Vec<Real, D>& a) {
  const Vec<Real, D> n = shape.normal(a);
  if constexpr (std::is_same_v<Shape, Segment<Real>>) return dot<Real, D>(n, a) > 0 ? Vec<Real, D>(-n) : n;
  return n;
}

/// a without its part along n: what is left of an acceleration on a wall, each component rounded once.
template <class Real, int D>
[[nodiscard]] inline Vec<Real, D> along_wall(const Vec<Real, D>& a, const Vec<Real, D>& n) {
  const Wide<Real> share = wide_dot<Real, D>(n, a) / wide_dot<Real, D>(n, n);
  Vec<Real, D> along;
  for (int k = 0; k < D; ++k) along[k] = narrow(Wide<Real>(Wide<Real>(a[k]) - share * Wide<Real>(n[k])));
  return along;
}

}  // namespace carom
