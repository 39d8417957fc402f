#include "carom/scene/tables.hpp"

#include <fmt/core.h>

#include "carom/scene/validate.hpp"
#include "keywords.hpp"
#include "table_numbers.hpp"

namespace carom {

namespace {

using namespace scene_text;
namespace mp = boost::multiprecision;

/// Lays out the pieces of one table, in its own frame.
class Maker {
 public:
  Maker(const TableSpec& table, int dimension)
      : table_(table), dimension_(dimension), frame_(table.centre, table.angle, dimension) {}

  TableParts make() {
    switch (table_.kind) {
      case TableKind::rectangle:
        rectangle(exact(table_.size[0]), exact(table_.size[1]));
        break;
      case TableKind::circle:
        circle("circle", {0, 0}, table_.radius, WallSide::inside);
        break;
      case TableKind::ellipse:
        ellipse();
        break;
      case TableKind::stadium:
        stadium();
        break;
      case TableKind::mushroom:
        mushroom();
        break;
      case TableKind::sinai:
        sinai();
        break;
      case TableKind::lorentz:
        lorentz();
        break;
      case TableKind::polygon:
        regular_polygon();
        break;
      case TableKind::triangle:
        triangle();
        break;
      case TableKind::wedge:
        wedge();
        break;
      case TableKind::cardioid:
        cardioid();
        break;
      case TableKind::pinball:
        pinball();
        break;
      case TableKind::annulus:
        circle("outer circle", {0, 0}, table_.outer, WallSide::inside);
        circle("inner circle", {exact(table_.offset), 0}, table_.inner, WallSide::outside);
        break;
      case TableKind::cradle:
        cradle();
        break;
      case TableKind::pool:
        rectangle(exact(table_.length), exact(table_.length) / 2);
        break;
    }
    return std::move(parts_);
  }

 private:
  WallSpec& wall(WallKind kind, std::string name) {
    parts_.names.push_back(std::move(name));
    WallSpec& w = parts_.walls.emplace_back();
    w.kind = kind;
    w.restitution = table_.restitution;
    w.material = table_.material;
    w.where = table_.where;
    return w;
  }
  void circle(std::string name, const TablePoint& centre, const Number& radius, WallSide side) {
    WallSpec& w = wall(WallKind::circle, std::move(name));
    w.centre = frame_.place(centre);
    w.radius = radius;
    w.side = side;
  }
  void segment(std::string name, const TablePoint& from, const TablePoint& to) {
    WallSpec& w = wall(WallKind::segment, std::move(name));
    w.from = frame_.place(from);
    w.to = frame_.place(to);
  }
  /// Anticlockwise from one end to the other; angles in half turns.
  void half_circle(std::string name, const TablePoint& centre, const Number& radius, const TablePoint& from,
                   const TablePoint& to, const Decimal& from_angle) {
    WallSpec& w = wall(WallKind::arc, std::move(name));
    w.centre = frame_.place(centre);
    w.radius = radius;
    w.from = frame_.place(from);
    w.to = frame_.place(to);
    w.from_angle = frame_.turned(Decimal(from_angle * half_turn()));
    w.to_angle = frame_.turned(Decimal((from_angle + 1) * half_turn()));
  }
  WallSpec& polygon(std::string name, const std::vector<TablePoint>& vertices) {
    WallSpec& w = wall(WallKind::polygon, std::move(name));
    for (const TablePoint& v : vertices) w.vertices.push_back(frame_.place(v));
    return w;
  }

  void rectangle(const Rational& width, const Rational& height) {
    const Rational x = width / 2, y = height / 2;
    polygon("cushion", {{-x, -y}, {x, -y}, {x, y}, {-x, y}});
  }

  void ellipse() {
    WallSpec& w = wall(WallKind::ellipse, "ellipse");
    w.centre = frame_.place({0, 0});
    w.axes = table_.axes;
    w.angle = table_.angle;
    w.side = WallSide::inside;
  }

  void stadium() {
    const Rational x = exact(table_.length) / 2, r = exact(table_.radius);
    segment("lower straight", {-x, -r}, {x, -r});
    half_circle("right half circle", {x, 0}, table_.radius, {x, -r}, {x, r}, Decimal(-0.5));
    segment("upper straight", {x, r}, {-x, r});
    half_circle("left half circle", {-x, 0}, table_.radius, {-x, r}, {-x, -r}, Decimal(0.5));
  }

  void mushroom() {
    const Rational r = exact(table_.cap_radius), x = exact(table_.stem_width) / 2, y = -exact(table_.stem_length);
    half_circle("cap", {0, 0}, table_.cap_radius, {r, 0}, {-r, 0}, Decimal(0));
    if (x < r) segment("left shoulder", {-r, 0}, {-x, 0});
    segment("left side", {-x, 0}, {-x, y});
    segment("foot", {-x, y}, {x, y});
    segment("right side", {x, y}, {x, 0});
    if (x < r) segment("right shoulder", {x, 0}, {r, 0});
  }

  void cell(SpaceKind kind, const Rational& width, const Rational& height) {
    SpaceSpec& space = parts_.space.emplace();
    space.kind = kind;
    space.lower = frame_.place({-width / 2, -height / 2});
    space.upper = frame_.place({width / 2, height / 2});
    if (kind == SpaceKind::box) {
      space.restitution = table_.restitution;
      space.material = table_.material;
    }
    space.where = table_.where;
  }

  void sinai() {
    circle("disk", {0, 0}, table_.radius, WallSide::outside);
    cell(table_.periodic ? SpaceKind::periodic : SpaceKind::box, exact(table_.size[0]), exact(table_.size[1]));
  }

  void lorentz() {
    const Rational a = exact(table_.spacing);
    circle("disk", {0, 0}, table_.radius, WallSide::outside);
    if (table_.lattice == TableLattice::square) return cell(SpaceKind::periodic, a, a);
    // The edge and its half are doubles of one significand, so that both rows of disks are equally far from each other.
    const Number edge(nearest_double(Rational(a * rational_of(mp::sqrt(Decimal(3))))));
    const Rational height = exact(edge);
    circle("disk at the corner", {a / 2, height / 2}, table_.radius, WallSide::outside);
    cell(SpaceKind::periodic, a, height);
  }

  void regular_polygon() {
    const Decimal step = half_turn() / table_.sides, radius = 1 / (2 * mp::sin(step));
    std::vector<TablePoint> vertices;
    for (std::int64_t k = 0; k < table_.sides; ++k) {
      const Decimal angle = step * (2 * k - 1);  // from straight below
      vertices.push_back({exact(table_.side) * rational_of(Decimal(radius * mp::sin(angle))),
                          -exact(table_.side) * rational_of(Decimal(radius * mp::cos(angle)))});
    }
    polygon("polygon", vertices);
  }

  void triangle() {
    const Rational a = exact(table_.lengths[0]), b = exact(table_.lengths[1]), c = exact(table_.lengths[2]);
    const Rational x = (a * a + c * c - b * b) / (2 * a);
    const Rational y = a * rational_of(mp::sqrt(decimal_of(Rational((c * c - x * x) / (a * a)))));
    const Rational mx = (a + x) / 3, my = y / 3;
    polygon("triangle", {{-mx, -my}, {a - mx, -my}, {x - mx, y - my}});
  }

  void wedge() {
    const Decimal half = decimal_of(exact(table_.opening_angle)) / 2;
    const Rational x = exact(table_.length) * rational_of(mp::sin(half)), y = exact(table_.length) * rational_of(mp::cos(half));
    segment("left side", {-x, y}, {0, 0});
    segment("right side", {0, 0}, {x, y});
  }

  void cardioid() {
    WallSpec& w = wall(WallKind::curve, "cardioid");
    w.centre = frame_.place({0, 0});
    w.angle = table_.angle;
    w.cosines = {table_.scale, table_.scale};
    w.side = WallSide::inside;
  }

  void pinball() {
    const Rational a = exact(table_.spacing), third = rational_of(Decimal(1 / mp::sqrt(Decimal(3))));
    const std::vector<TablePoint> corners{{-a / 2, -a * third / 2}, {a / 2, -a * third / 2}, {0, a * third}};
    circle("left disk", corners[0], table_.radius, WallSide::outside);
    circle("right disk", corners[1], table_.radius, WallSide::outside);
    circle("upper disk", corners[2], table_.radius, WallSide::outside);
    polygon("opening", corners).opening = true;
  }

  void cradle() {
    const Rational r = exact(table_.radius);
    for (std::int64_t k = 0; k < table_.count; ++k) {
      BallSpec& b = parts_.balls.emplace_back();
      b.position = frame_.place({r * (2 * k + 1 - table_.count), 0});
      b.radius = table_.radius;
      b.material = table_.material;
      b.where = table_.where;
    }
  }

  const TableSpec& table_;
  int dimension_;
  TableFrame frame_;
  TableParts parts_;
};

/// Straight ways between the disks that never end: always on a square lattice of disks apart, on a triangular one where the
/// rows leave room, sqrt(3)/2 spacing > 2 radius.
bool has_corridors(const TableSpec& t) {
  if (t.lattice == TableLattice::square) return t.spacing.value > 2 * t.radius.value;
  const Rational s = exact(t.spacing), r = exact(t.radius);
  return 3 * s * s > 16 * r * r;
}

}  // namespace

TableParts table_parts(const TableSpec& table, int dimension) { return Maker(table, dimension).make(); }

Scene with_tables(Scene scene) {
  if (!has_tables_out(scene)) return scene;
  if (std::vector<Problem> problems = validate(scene); !problems.empty()) throw InputError(std::move(problems));
  scene.tables_in = true;
  for (std::size_t t = 0; t < scene.tables.size(); ++t) {
    TableParts parts = table_parts(scene.tables[t], scene.dimension);
    for (WallSpec& w : parts.walls) {
      w.table = static_cast<int>(t);
      scene.walls.push_back(std::move(w));
    }
    for (BallSpec& b : parts.balls) scene.balls.push_back(std::move(b));
    if (parts.space) scene.space = std::move(*parts.space);
  }
  return scene;
}

std::vector<std::string> tables_explained(const Scene& scene) {
  std::vector<std::string> sentences;
  for (std::size_t t = 0; t < scene.tables.size(); ++t) {
    const TableSpec& table = scene.tables[t];
    const TableParts parts = table_parts(table, scene.dimension);
    std::size_t first = 0;
    while (first < scene.walls.size() && scene.walls[first].table != static_cast<int>(t)) ++first;
    std::string s = fmt::format("table {} (\"{}\")", t, word_for<TableKind>(table_kinds, table.kind));
    const std::size_t n = parts.names.size();
    if (n == 1) s += fmt::format(", wall {}: ", first);
    if (n > 1) s += fmt::format(", walls {} to {}: ", first, first + n - 1);
    for (std::size_t k = 0; k < n; ++k) s += (k > 0 ? ", " : "") + parts.names[k];
    if (!parts.balls.empty()) s += fmt::format(": {} balls at rest in a row", parts.balls.size());
    if (parts.space) s += parts.space->kind == SpaceKind::periodic ? " in a periodic cell" : " in a box";
    if (table.kind == TableKind::lorentz) s += has_corridors(table) ? ", infinite horizon" : ", finite horizon";
    sentences.push_back(std::move(s));
  }
  return sentences;
}

}  // namespace carom
