#pragma once
// Walls that Bullet has no shape for, as triangles: upright strips in the plane, a refined icosahedron in space.

#include <memory>

#include <btBulletDynamicsCommon.h>

#include "layout.hpp"

namespace carom::game_engine {

/// Of a segment or a ring. In 2-D its strips reach from -height to height across the plane.
[[nodiscard]] std::unique_ptr<btTriangleMesh> mesh_of(const Piece& piece, int dimension, double height);

}  // namespace carom::game_engine
