#include "bullet_mesh.hpp"

#include <cmath>
#include <numbers>

#include "adapters.hpp"

namespace carom::game_engine {

namespace {

btVector3 vec(const Point& x) {
  return {static_cast<btScalar>(x[0]), static_cast<btScalar>(x[1]), static_cast<btScalar>(x[2])};
}

void add_strip(btTriangleMesh& mesh, Point from, Point to, double height) {
  const Point up{0.0, 0.0, 1.0};
  const btVector3 a = vec(along(from, -height, up)), b = vec(along(to, -height, up)), c = vec(along(to, height, up)),
                  d = vec(along(from, height, up));
  mesh.addTriangle(a, b, c);
  mesh.addTriangle(a, c, d);
}

Point unit(const Point& x) { return along({}, 1 / norm(x), x); }

/// A triangle of the unit sphere, cut into four so many times, moved out to the ring.
void add_patch(btTriangleMesh& mesh, const Piece& ring, const Point& a, const Point& b, const Point& c, int levels) {
  if (levels == 0) {
    mesh.addTriangle(vec(along(ring.point, ring.radius, a)), vec(along(ring.point, ring.radius, b)),
                     vec(along(ring.point, ring.radius, c)));
    return;
  }
  const Point ab = unit(along(a, 1.0, b)), bc = unit(along(b, 1.0, c)), ca = unit(along(c, 1.0, a));
  add_patch(mesh, ring, a, ab, ca, levels - 1);
  add_patch(mesh, ring, ab, b, bc, levels - 1);
  add_patch(mesh, ring, ca, bc, c, levels - 1);
  add_patch(mesh, ring, ab, bc, ca, levels - 1);
}

void add_sphere(btTriangleMesh& mesh, const Piece& ring) {
  const double g = std::numbers::phi;
  const Point corner[12] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                            {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  constexpr int face[20][3] = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (const auto& f : face)
    add_patch(mesh, ring, unit(corner[f[0]]), unit(corner[f[1]]), unit(corner[f[2]]), bullet_ring_levels);
}

}  // namespace

std::unique_ptr<btTriangleMesh> mesh_of(const Piece& piece, int dimension, double height) {
  auto mesh = std::make_unique<btTriangleMesh>(true, false);
  if (piece.kind == PieceKind::segment) {
    add_strip(*mesh, piece.point, piece.to, height);
  } else if (dimension == 3) {
    add_sphere(*mesh, piece);
  } else {
    const int n = ring_edges(piece.radius, bullet_ring_depth);
    const auto corner = [&](int k) {
      const double angle = 2 * std::numbers::pi * k / n;
      return along(piece.point, piece.radius, {std::cos(angle), std::sin(angle), 0.0});
    };
    for (int k = 0; k < n; ++k) add_strip(*mesh, corner(k), corner(k + 1), height);
  }
  return mesh;
}

}  // namespace carom::game_engine
