#pragma once
// A scene as a game engine is given it: bodies and pieces of walls, in the engine's units of length and mass.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "carom/scene/scene.hpp"
#include "carom/world/restitution_table.hpp"

namespace carom::game_engine {

using Point = std::array<double, 3>;  ///< components beyond the dimension are 0

[[nodiscard]] double dot(const Point& u, const Point& v);
[[nodiscard]] double norm(const Point& u);
[[nodiscard]] Point along(const Point& x, double s, const Point& u);  ///< x + s u

/// dynamic: moved by impulses. driven: of infinite mass, on its own parabola. fixed: never moves.
enum class BodyKind : std::uint8_t { dynamic, driven, fixed };

struct Body {
  std::string name{};
  BodyKind kind = BodyKind::dynamic;
  Point position{}, velocity{};  ///< at the start
  double radius = 0.0;
  double mass = 1.0;
  std::uint32_t material = 0;
};

/// half_space: up to a plane. segment: two-sided. disc: a circle or sphere, balls outside. ring: balls inside.
enum class PieceKind : std::uint8_t { half_space, segment, disc, ring };

/// A piece of a wall, where it is at the start.
struct Piece {
  PieceKind kind = PieceKind::half_space;
  std::uint32_t wall = 0;                          ///< as Simulation numbers them
  std::int32_t feature = 0;                        ///< of the face, edge or circle
  Point point{};                                   ///< on the plane; of a segment, its first end; of a circle, its centre
  Point to{};                                      ///< segment: its other end
  std::int32_t point_feature = 0, to_feature = 0;  ///< segment: of its ends
  Point normal{};                                  ///< half_space: a unit vector to the balls' side
  double half_length = 0.0;  ///< half_space: how far a line that stands for it goes on, to both sides of `point`
  bool endless = false;      ///< half_space: of a plane, not of a face
  double radius = 0.0;       ///< disc, ring
  Point velocity{};
};

/// Feature that is nearest to x, `drift` being how far the wall has moved since the start.
[[nodiscard]] std::int32_t nearest_feature(const Piece& piece, const Point& x, const Point& drift);

/// One of the two parties of a contact: a ball, or a piece of a wall.
struct Party {
  const Piece* piece = nullptr;  ///< none: a ball
  std::uint32_t ball = 0;
};

struct Layout {
  int dimension = 2;
  SpaceKind space = SpaceKind::open;
  LawKind law = LawKind::restitution;
  int length = 0;      ///< engine's lengths = user's 2^length
  int mass = 0;        ///< engine's masses = user's 2^mass
  double start = 0.0;  ///< [time]
  Point acceleration{};
  std::vector<Body> bodies{};  ///< by ball number
  std::vector<Piece> pieces{};
  std::vector<std::string> foreign{};  ///< what stands in the scene and in no engine: "wall 2 is an arc"
  RestitutionTable<double> restitution{};
  double extent = 0.0;          ///< largest coordinate of a ball or a wall
  double largest_radius = 0.0;  ///< of the balls
  double smallest_radius = 0.0;
  double fastest = 0.0;  ///< [length/time] speed of a ball or a wall at the start

  [[nodiscard]] double restitution_of(const Party& a, const Party& b) const;
  [[nodiscard]] double to_user_length(double x) const;
  [[nodiscard]] double to_user_momentum(double p) const;
};

/// The scene with lengths such that 2^(size - 1) <= median radius < 2^size. Throws InputError.
[[nodiscard]] Layout make_layout(const Scene& scene, int size);

/// Straight edges of a polygon that stands for a ring, so that it lies within `depth` of the circle: at least 64, at most
/// 4096.
[[nodiscard]] int ring_edges(double radius, double depth);

/// Largest distance between the circle through the corners of such a polygon and its edges.
[[nodiscard]] double ring_depth(double radius, int edges);

}  // namespace carom::game_engine
