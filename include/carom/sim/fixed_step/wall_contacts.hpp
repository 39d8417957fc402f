#pragma once
// How far a ball is from each piece of each wall, and in which direction: what a step asks at one moment.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/world/world.hpp"

namespace carom {

/// A ball beside a piece of a wall.
template <int D>
struct WallContact {
  std::uint32_t wall;
  std::int32_t feature;
  double gap;               ///< [length unit] between the surfaces; < 0: overlap
  Vec<double, D> normal;    ///< unit, towards the centre of the ball
  Vec<double, D> velocity;  ///< [length unit / L] of the wall
};

/// A two-sided wall acts towards the side that the centre is on. Where an edge and its end are both near, the nearer of
/// them is the one: the edge if the centre lies beside it, the end if it lies beyond.
template <int D>
class WallContacts {
 public:
  using Vector = Vec<double, D>;

  explicit WallContacts(const Walls<double, D>& walls) : walls_(walls) {
    walls.for_each([&](const auto& shape) {
      if constexpr (requires { shape.velocity; })
        fastest_ = std::max(fastest_, std::sqrt(dot<double, D>(shape.velocity, shape.velocity)));
    });
    edges_.resize(walls.spheres.size());
    if constexpr (D == 2)
      for (std::size_t k = 0; k < walls.spheres.size(); ++k)
        for (const Segment<double>& s : walls.segments) {
          if (s.wall != walls.spheres[k].wall) continue;
          if (s.from == walls.spheres[k].centre) edges_[k].push_back(s.along);
          if (s.to == walls.spheres[k].centre) edges_[k].push_back(-s.along);
        }
    if constexpr (D == 2)
      for (std::size_t k = 0; k < walls.spheres.size(); ++k)
        for (const Arc<double>& a : walls.arcs) {
          if (a.wall != walls.spheres[k].wall || a.whole) continue;
          const Vector from = a.from - a.centre, to = a.to - a.centre;
          if (a.from == walls.spheres[k].centre) edges_[k].push_back(Vector(-from[1], from[0]));
          if (a.to == walls.spheres[k].centre) edges_[k].push_back(Vector(to[1], -to[0]));
        }
  }

  /// [length unit / L] speed of the fastest wall.
  [[nodiscard]] double fastest() const noexcept { return fastest_; }

  /// Calls f(WallContact) for every piece nearer than `within` [length unit] to the surface of a ball of that radius at x,
  /// `t` [L] after the world's start.
  template <class F>
  void near(const Vector& x, double radius, double t, double within, F&& f) const {
    for (const Face<double, D>& face : walls_.faces) {
      const double gap = face.gap(x) - radius;
      if (gap <= within) f(WallContact<D>{index(face.wall), face.feature, gap, face.normal(x), Vector::Zero()});
    }
    for (const Plane<double, D>& plane : walls_.planes) {
      const double gap = plane.gap(Vector(x - plane.velocity * t)) - radius;
      if (gap <= within) f(WallContact<D>{index(plane.wall), plane.feature, gap, plane.direction, plane.velocity});
    }
    if constexpr (D == 2)
      for (const Segment<double>& s : walls_.segments) beside(s, Vector(x - s.velocity * t), radius, within, f);
    if constexpr (D == 2)
      walls_.for_each([&](const auto& shape) {
        if constexpr (is_curved<std::remove_cvref_t<decltype(shape)>>)
          along_curve(shape, Vector(x - shape.velocity * t), radius, within, f);
      });
    if constexpr (D > 1)
      for (std::size_t k = 0; k < walls_.spheres.size(); ++k)
        around(k, Vector(x - walls_.spheres[k].velocity * t), radius, within, f);
  }

 private:
  /// A curve with an inside acts from where the balls belong, one with two sides from where the centre is.
  template <class Shape, class F>
  static void along_curve(const Shape& shape, const Vector& x, double radius, double within, F& f) requires(D == 2) {
    double gap;
    Vector n;
    if constexpr (std::is_same_v<Shape, Arc<double>>) {
      if (!shape.spans(Vector(x - shape.centre), 0.0)) return;
      const double height = shape.height(x);
      gap = std::abs(height) - radius;
      n = height < 0 ? Vector(x - shape.centre) : Vector(shape.centre - x);
    } else {
      const Vector r = x - shape.centre;
      n = r - shape.place(nearest_on<double>(shape, r));
      gap = shape.gap(x);
      if (gap < 0) n = -n;
      gap -= radius;
    }
    const double length = length_of<double>(n);
    if (gap <= within && length > 0) f(WallContact<D>{index(shape.wall), shape.feature, gap, Vector(n / length), shape.velocity});
  }

  template <class F>
  static void beside(const Segment<double>& s, const Vector& x, double radius, double within, F& f) requires(D == 2) {
    const double height = s.height(x), gap = std::abs(height) - radius;
    if (!(gap <= within)) return;
    if (dot<double, D>(s.along, Vector(x - s.from)) < 0 || dot<double, D>(s.along, Vector(x - s.to)) > 0) return;
    f(WallContact<D>{index(s.wall), s.feature, gap, Vector(height < 0 ? -s.direction : s.direction), s.velocity});
  }

  template <class F>
  void around(std::size_t k, const Vector& x, double radius, double within, F& f) const {
    const Sphere<double, D>& sphere = walls_.spheres[k];
    const Vector r = x - sphere.centre;
    const double distance = std::sqrt(dot<double, D>(r, r));
    const double gap = (sphere.inside ? sphere.radius - distance : distance - sphere.radius) - radius;
    if (!(gap <= within) || distance == 0) return;
    for (const Vector& along : edges_[k])
      if (dot<double, D>(r, along) > 0) return;  // beside the edge
    f(WallContact<D>{index(sphere.wall), sphere.feature, gap, Vector(r / (sphere.inside ? -distance : distance)),
                     sphere.velocity});
  }

  const Walls<double, D>& walls_;
  double fastest_ = 0;
  std::vector<std::vector<Vector>> edges_;  // by sphere: the directions of the edges that end in it
};

}  // namespace carom
