#pragma once
// Where balls may be in a scene, as far as its walls say it: what places are drawn from.

#include <optional>
#include <vector>

#include "carom/scene/scene.hpp"

namespace carom::scene_text {

/// The space, or the box around the walls of an open one.
struct Outline {
  std::vector<double> lower, upper;  ///< [length]

  /// None: an open space without walls that bound it.
  [[nodiscard]] static std::optional<Outline> of(const Scene& scene);

  /// Whether a place is on the side of the walls that balls are on: inside of what is sided "inside" and outside of what is
  /// "outside"; with segments, arcs and polygons as outline of an open 2-D space, an odd number of times around it.
  [[nodiscard]] bool holds(const std::vector<double>& x) const;

 private:
  explicit Outline(const Scene& s) : scene(&s) {}
  const Scene* scene;
};

}  // namespace carom::scene_text
