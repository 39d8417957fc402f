#pragma once
// Triangles that stand for a sphere: an icosahedron, refined.

#include <array>
#include <vector>

#include "layout.hpp"

namespace carom::game_engine {

using Triangle = std::array<Point, 3>;

/// An icosahedron on the unit sphere, each face cut into four `levels` times: 20 4^levels triangles, corners on the sphere.
[[nodiscard]] std::vector<Triangle> unit_sphere_triangles(int levels);

/// Largest distance between the unit sphere and those triangles.
[[nodiscard]] double sphere_mesh_depth(int levels);

}  // namespace carom::game_engine
