#pragma once
// The walls of a world: one typed vector a shape, so that no prediction goes through a dispatch.

#include <string>
#include <vector>

#include "carom/shape/curved.hpp"
#include "carom/shape/face.hpp"
#include "carom/shape/plane.hpp"
#include "carom/shape/segment.hpp"
#include "carom/shape/sphere.hpp"
#include "carom/shape/swing.hpp"

namespace carom {

template <class Real, int D>
struct Walls {
  std::vector<Face<Real, D>> faces;
  std::vector<Plane<Real, D>> planes;
  std::vector<Segment<Real>> segments;  ///< 2-D
  std::vector<Sphere<Real, D>> spheres;
  std::vector<Arc<Real>> arcs;                ///< 2-D, as are those below
  std::vector<Ellipse<Real>> ellipses;
  std::vector<Parabola<Real>> parabolas;
  std::vector<PolarCurve<Real>> curves;
  std::vector<bool> openings;       ///< by wall number: balls whose centre comes to it leave; empty: none, else as many as labels
  std::vector<Swing<Real, D>> swings;
  std::vector<std::string> labels;  ///< by wall number: "0", "1", ... in file order, then the faces "x-", "x+", "y-", ...

  [[nodiscard]] bool empty() const noexcept { return labels.empty(); }
  [[nodiscard]] bool opens(std::uint32_t wall) const { return !openings.empty() && openings[wall]; }

  /// Calls f(shape) for every piece of every wall.
  template <class F>
  void for_each(F&& f) const {
    for (const auto& s : faces) f(s);
    for (const auto& s : planes) f(s);
    if constexpr (D == 2)
      for (const auto& s : segments) f(s);
    if constexpr (D > 1)
      for (const auto& s : spheres) f(s);
    if constexpr (D == 2) {
      for (const auto& s : arcs) f(s);
      for (const auto& s : ellipses) f(s);
      for (const auto& s : parabolas) f(s);
      for (const auto& s : curves) f(s);
    }
  }

  /// Calls f(shape) for the one piece that is feature `feature` of wall `wall`.
  template <class F>
  void with(std::uint32_t wall, std::int32_t feature, F&& f) const {
    for_each([&](const auto& s) {
      if (index(s.wall) == wall && s.feature == feature) f(s);
    });
  }
};

}  // namespace carom
