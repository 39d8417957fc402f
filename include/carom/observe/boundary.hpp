#pragma once
// The boundary of a billiard in two dimensions as one line, and where on it collisions take place.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/observe/subject.hpp"
#include "carom/scene/scene.hpp"
#include "carom/sim/simulation.hpp"

namespace carom {

/// A collision in the coordinates of Birkhoff [Birkhoff1927].
struct Bounce {
  std::uint32_t ball = 0;    ///< that moves
  std::size_t piece = 0;     ///< of the boundary
  double arclength = 0.0;    ///< [length] along the whole boundary
  double sine = 0.0;         ///< of the angle of incidence, -1..1; > 0: the ball goes on with the wall on its right hand
};

/// Pieces in a row: the [[wall]]s in the order of their numbers, each with its features in theirs (the edges of a polygon);
/// the faces of a box, anticlockwise from the lower corner; then the rims of fixed balls, anticlockwise, in the order of
/// theirs. Corners belong to the piece that begins there, the end of a segment to the segment. Openings have no length.
class Boundary {
 public:
  struct Piece {
    std::uint32_t wall = 0;     ///< its number; of a fixed ball: the number of walls and faces plus the ball's
    std::int32_t feature = 0;
    double length = 0.0;        ///< [length] of the wall itself, whatever the radius of balls
    double begin = 0.0;         ///< [length] arclength at its beginning
  };

  Boundary(const Scene& scene, const Simulation& simulation);

  /// Why the scene has none; empty: it has one.
  [[nodiscard]] static std::string refusal(const Scene& scene, const Subject& subject);

  [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }
  [[nodiscard]] double length() const noexcept { return length_; }  ///< [length] of all pieces

  /// None: two balls that both move freely.
  [[nodiscard]] std::optional<Bounce> bounce(const Collision& c, const Subject& subject) const;

 private:
  void add(std::uint32_t wall, std::int32_t feature, double length);
  [[nodiscard]] std::size_t piece_of(const Collision& c, std::uint32_t wall, double& along) const;

  std::vector<Piece> pieces_;
  double length_ = 0.0;
  std::uint32_t walls_ = 0;                  // with the faces
  std::size_t face_piece_ = 0;               // the first piece of a face
  std::vector<std::size_t> first_piece_;     // by wall without the faces
  std::vector<std::int32_t> features_;       // by wall without the faces: how many pieces
  std::vector<std::size_t> rim_;             // by ball number, while there are fixed ones: its piece
  std::vector<double> radius_;               // by ball number, then too
};

/// [length] of one piece of a wall, 2-D: an edge of a polygon by its feature, else of all of it. Ellipse: 4 a E(e), by the
/// arithmetic-geometric mean; parabola: closed form; curve: the trapezium rule over its period, doubled until it stays.
[[nodiscard]] double wall_length(const WallSpec& wall, std::int32_t feature);

}  // namespace carom
