#pragma once
// The closed outlines of ready-made tables: which places are inside.

#include <array>
#include <cstddef>
#include <vector>

#include "carom/scene/scene.hpp"

namespace carom {

/// The places inside a closed outline, by the parity of its crossings with a ray: a place on the outline itself may count
/// either way. In doubles; what touches or overlaps is judged elsewhere.
class Outline {
 public:
  /// Of table `table` of a scene that has its walls.
  Outline(const Scene& scene, std::size_t table);

  [[nodiscard]] bool inside(const double* x) const;
  /// Inside, or on the outline: within 2^-30 of its size.
  [[nodiscard]] bool inside_or_on(const double* x) const;
  [[nodiscard]] const std::array<double, 2>& lower() const { return lower_; }
  [[nodiscard]] const std::array<double, 2>& upper() const { return upper_; }

 private:
  using Point = std::array<double, 2>;

  /// A piece on which y is monotone: straight, or on the right (+1) or left (-1) half of a circle.
  struct Piece {
    Point from, to;
    int half = 0;
    Point centre{};
    double radius = 0;
  };
  void add_wall(const WallSpec& wall);
  void add_arc(const WallSpec& wall);
  void add(const Piece& piece);
  void hold(const Point& p);

  std::vector<Piece> pieces_;
  Point lower_, upper_;
};

/// Whether a table of this kind is closed: one of walls, or of walls and openings.
[[nodiscard]] bool is_closed(TableKind kind);

/// Those of all closed tables of a scene that has its walls.
[[nodiscard]] std::vector<Outline> outlines(const Scene& scene);

}  // namespace carom
