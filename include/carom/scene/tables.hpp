#pragma once
// Ready-made billiard tables: what walls, what space and what balls each kind of [[table]] stands for.
//
// In the frame of the table (its centre at the origin, before it is turned by `angle`), in the order of the wall numbers:
//   rectangle  a polygon, size = [w, h]
//   circle     a circle of `radius`, balls inside
//   ellipse    an ellipse with semi-axes `axes`, balls inside
//   stadium    lower straight of `length`, right half circle of `radius`, upper straight, left half circle [Bunimovich1979]
//   mushroom   half circle of `cap_radius` over y = 0, then left shoulder, left side, foot, right side and right shoulder of a
//              stem `stem_width` wide and `stem_length` long [Bunimovich2001]
//   sinai      a circle of `radius`, balls outside, in a periodic cell (or in a box) of `size` [Sinai1970]
//   lorentz    circles of `radius`, balls outside, in a periodic cell. square: one, `spacing` by `spacing`. triangular: two, at
//              the centre and at the corner of a cell `spacing` by sqrt(3) `spacing`; a hexagonal cell with one circle repeats
//              to the same plane. The corner's circle reaches over the edge and stands in all periods
//   polygon    a regular one with `sides` of length `side`, one of them below and level
//   triangle   a polygon with sides of `lengths`, in order: the first level, its centroid at the centre
//   wedge      left and right side of `length`, upwards from the centre, `angle` between them; open above
//   cardioid   a curve r = scale (1 + cos theta), balls inside; its cusp is at the centre
//   pinball    three circles of `radius`, balls outside, at the corners of an equilateral triangle with sides `spacing`; the
//              triangle is an opening: what leaves it never comes back [GaspardRice1989]
//   annulus    a circle of radius `outer`, balls inside; one of radius `inner`, `offset` to the right, balls outside
//   cradle     no wall: `count` balls of `radius` at rest in a row along x, each touching the next (also in 1-D)
//   pool       a polygon `length` by `length` / 2, without pockets
//
// Sums and products of the numbers given are exact. Roots, sines and cosines are taken in 100 decimal digits without the
// machine's libm, so they are the same everywhere; `value` is rounded once, `text` has `table_digits` of them. Where two pieces
// join, their ends are the same numbers; an arc has them as `from` and `to` beside its angles.

#include <string>
#include <utility>
#include <vector>

#include "carom/scene/scene.hpp"

namespace carom {

/// Significant digits of a table's irrational numbers.
inline constexpr int table_digits = 90;

/// What a table stands for. Lengths in the unit of the scene.
struct TableParts {
  std::vector<WallSpec> walls{};
  std::vector<std::string> names{};   ///< of the walls: "upper straight"
  std::vector<BallSpec> balls{};      ///< they follow those of [[ball]]
  std::optional<SpaceSpec> space{};   ///< that the kind brings
};

/// The parts of a table in a scene of this dimension. Requires values that `validate` has no objection to.
[[nodiscard]] TableParts table_parts(const TableSpec& table, int dimension);

/// Whether the parts of a scene's tables are still to be put into it: one made in code.
[[nodiscard]] inline bool has_tables_out(const Scene& scene) { return !scene.tables.empty() && !scene.tables_in; }

/// The scene with all parts of its tables in it: walls and balls after its own. A scene that has them already stays as it is.
/// Throws InputError if there are problems in the scene.
[[nodiscard]] Scene with_tables(Scene scene);

/// "walls 0 to 3: lower straight, right half circle, upper straight, left half circle", one sentence for each table.
[[nodiscard]] std::vector<std::string> tables_explained(const Scene& scene);

}  // namespace carom
