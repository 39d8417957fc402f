#pragma once
// What a proof is about: balls, walls and laws in exact rational numbers.

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "carom/core/rational.hpp"
#include "carom/scene/scene.hpp"

namespace carom::certify {

/// Three components; those beyond the dimension are 0.
using Vector = std::array<Rational, 3>;

[[nodiscard]] bool is_zero(const Vector& v);

struct SystemBall {
  Vector position, velocity;     ///< [length], [length/time] at the start; positions are not wrapped
  Rational radius;               ///< [length]
  std::optional<Rational> mass;  ///< [mass]; none: infinite
  bool fixed = false;
  std::uint32_t material = 0;    ///< row of the restitution tables
};

enum class PieceKind : std::uint8_t { plane, sphere, edge, vertex };

/// One piece of a wall that a ball can meet.
struct Piece {
  PieceKind kind = PieceKind::plane;
  std::uint32_t wall = 0;
  std::int32_t feature = 0;
  Vector point;           ///< [length] plane: on it; sphere: centre; edge: its beginning; vertex: itself; at the start
  Vector direction;       ///< plane: normal, of any length; edge: from its beginning to its end
  Vector velocity;        ///< [length/time]
  Rational radius;        ///< sphere [length]
  bool inside = false;    ///< sphere: the balls are inside
};

struct System {
  int dimension = 2;
  Rational start;                                  ///< [time]
  Vector acceleration;                             ///< [length/time^2] of every ball that is not fixed
  std::optional<Vector> period;                    ///< [length] of a periodic space
  std::vector<SystemBall> balls;
  std::vector<Piece> pieces;
  std::vector<std::string> walls;                  ///< labels, by wall number
  std::vector<std::vector<Rational>> restitution;  ///< e between materials
  std::vector<std::vector<Rational>> at_wall;      ///< e of a material at a wall

  [[nodiscard]] bool accelerated() const;
};

/// The system of a scene: its exact numbers; generated balls as the doubles that the generator gives. Throws InputError,
/// naming everything that no proof is made for, and scenes that start in contact.
[[nodiscard]] System system_of(const Scene& scene);

/// One line a thing, each beginning with "# "; `read_system` reads it back, up to the first line of another kind. Throws
/// std::invalid_argument.
void write_system(std::ostream& out, const System& system);
[[nodiscard]] System read_system(std::istream& in);

}  // namespace carom::certify
