// The rules for [[wall]].

#include "keywords.hpp"
#include "table_rules.hpp"
#include "words.hpp"

namespace carom::scene_text {

namespace {

bool same_place(const Coordinates& a, const Coordinates& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].value != b[i].value) return false;
  }
  return true;
}

void judge_segment(TableRules& rules, const WallSpec& w) {
  const bool from = rules.vector("from", w.from, Presence::required);
  const bool to = rules.vector("to", w.to, Presence::required);
  if (from && to && same_place(w.from, w.to)) {
    rules.found("to", " is where the segment starts", "its ends are two places", "", {rules.key("from")});
  }
}

void judge_plane(TableRules& rules, const WallSpec& w) {
  rules.vector("point", w.point, Presence::required);
  if (rules.vector("normal", w.normal, Presence::required) && is_zero(w.normal)) {
    rules.found("normal", " is zero", "it points to the side of the balls");
  }
}

void judge_circle(TableRules& rules, const WallSpec& w) {
  rules.vector("centre", w.centre, Presence::required);
  rules.positive("radius", w.radius, "the radius of a wall is above 0");
}

void judge_polygon(TableRules& rules, const WallSpec& w) {
  const std::size_t n = w.vertices.size();
  if (n < 3) {
    rules.found("vertices", " has " + std::to_string(n) + (n == 1 ? " point" : " points"), "a polygon has 3 or more");
  }
  TableRules vertices(rules.inner("vertices"));
  bool good = true;
  for (std::size_t i = 0; i < n; ++i) {
    good = vertices.vector(std::to_string(i), w.vertices[i], Presence::required) && good;
  }
  for (std::size_t i = 0; good && n >= 3 && i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    if (!same_place(w.vertices[i], w.vertices[next])) continue;
    vertices.found(std::to_string(next), " is the point before it", "an edge has two ends",
                   next == 0 ? "The polygon closes itself" : "", {vertices.key(std::to_string(i))});
  }
}

void judge_dimension(TableRules& rules, WallKind kind, int dimension) {
  const bool flat = kind == WallKind::segment || kind == WallKind::polygon;
  if (!is_dimension(dimension) || kind == WallKind::plane || dimension == 2) return;
  if (kind == WallKind::circle && dimension == 3) return;
  rules.found("kind", " is " + in_quotes(word_for<WallKind>(wall_kinds, kind)),
              std::string(flat ? "it needs dimension 2" : "it needs dimension 2 or 3") + ", the scene has " +
                  std::to_string(dimension),
              "", {{"dimension"}});
}

}  // namespace

void judge_walls(Judgement& j) {
  for (std::size_t i = 0; i < j.scene.walls.size(); ++i) {
    const WallSpec& w = j.scene.walls[i];
    if (w.table >= 0) continue;  // judged as a table
    TableRules rules(j, {"wall", std::to_string(i)}, w.where);
    const std::string_view kind = word_for<WallKind>(wall_kinds, w.kind);
    rules.unbuilt("wall.kind", kind);
    judge_dimension(rules, w.kind, j.scene.dimension);
    switch (w.kind) {
      case WallKind::segment:
        judge_segment(rules, w);
        break;
      case WallKind::plane:
        judge_plane(rules, w);
        break;
      case WallKind::circle:
        judge_circle(rules, w);
        break;
      case WallKind::polygon:
        judge_polygon(rules, w);
        break;
      case WallKind::arc:
      case WallKind::ellipse:
      case WallKind::parabola:
      case WallKind::curve:
        break;  // refused by name
    }
    if (rules.vector("velocity", w.velocity, Presence::optional) && !is_zero(w.velocity)) {
      rules.unbuilt("wall.velocity", kind);
    }
    if (w.restitution) rules.restitution(*w.restitution);
    rules.material(w.material);
    if (w.opening && (w.restitution || !w.material.empty()))
      rules.found(w.restitution ? "restitution" : "material", " has no meaning here", "nothing bounces off an opening", "",
                  {rules.key("opening")});
  }
}

}  // namespace carom::scene_text
