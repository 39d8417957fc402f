#include "bullet_mesh.hpp"

#include <cmath>
#include <numbers>

#include "adapters.hpp"
#include "sphere_mesh.hpp"

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

void add_sphere(btTriangleMesh& mesh, const Piece& ring) {
  for (const auto& [a, b, c] : unit_sphere_triangles(bullet_ring_levels))
    mesh.addTriangle(vec(along(ring.point, ring.radius, a)), vec(along(ring.point, ring.radius, b)),
                     vec(along(ring.point, ring.radius, c)));
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
