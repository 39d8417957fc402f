#include "sphere_mesh.hpp"

#include <algorithm>
#include <numbers>

namespace carom::game_engine {

namespace {

Point unit(const Point& x) { return along({}, 1 / norm(x), x); }

std::vector<Triangle> icosahedron() {
  const double g = std::numbers::phi;
  const std::array<Point, 12> corner{Point{-1, g, 0}, {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                     {0, -1, -g},     {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  constexpr std::size_t face[20][3] = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  std::vector<Triangle> all;
  for (const auto& f : face) all.push_back({unit(corner[f[0]]), unit(corner[f[1]]), unit(corner[f[2]])});
  return all;
}

}  // namespace

std::vector<Triangle> unit_sphere_triangles(int levels) {
  std::vector<Triangle> all = icosahedron();
  for (int level = 0; level < levels; ++level) {
    std::vector<Triangle> finer;
    finer.reserve(4 * all.size());
    for (const auto& [a, b, c] : all) {
      const Point ab = unit(along(a, 1.0, b)), bc = unit(along(b, 1.0, c)), ca = unit(along(c, 1.0, a));
      finer.insert(finer.end(), {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    all = std::move(finer);
  }
  return all;
}

/// The plane of a triangle is nearest to the centre; where its foot lies within, that is how deep the triangle reaches.
double sphere_mesh_depth(int levels) {
  double depth = 0.0;
  for (const auto& [a, b, c] : unit_sphere_triangles(levels)) {
    const Point u = along(b, -1.0, a), v = along(c, -1.0, a);
    const Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    depth = std::max(depth, 1 - std::abs(dot(n, a)) / norm(n));
  }
  return depth;
}

}  // namespace carom::game_engine
