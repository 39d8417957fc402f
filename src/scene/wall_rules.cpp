// The rules for [[wall]].

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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

void judge_arc(TableRules& rules, const WallSpec& w) {
  rules.vector("centre", w.centre, Presence::required);
  rules.positive("radius", w.radius, "the radius of a wall is above 0");
  if (!rules.finite("from_angle", w.from_angle) || !rules.finite("to_angle", w.to_angle)) return;
  if (w.from_angle.value == w.to_angle.value)
    rules.found("to_angle", " is where the arc begins", "its ends are two places",
                "For a whole turn give kind = \"circle\"", {rules.key("from_angle")});
  const double turn = w.to_angle.value - w.from_angle.value, full = 2 * std::numbers::pi;
  if (std::abs(turn) > full * (1 + 1e-15))
    rules.found("to_angle", " is more than a turn from from_angle", "an arc is at most a whole circle, 2 pi",
                "", {rules.key("from_angle")});
}

void judge_ellipse(TableRules& rules, const WallSpec& w) {
  rules.vector("centre", w.centre, Presence::required);
  rules.finite("angle", w.angle);
  if (w.axes.empty()) return rules.missing("axes", "an ellipse has two semi-axes", "Add axes = [2.0, 1.0]");
  if (w.axes.size() != 2)
    return rules.found("axes", " has " + std::to_string(w.axes.size()) + (w.axes.size() == 1 ? " number" : " numbers"),
                       "an ellipse has two semi-axes");
  TableRules axes(rules.inner("axes"));
  for (std::size_t i = 0; i < 2; ++i) axes.positive(std::to_string(i), w.axes[i], "a semi-axis is above 0");
}

void judge_parabola(TableRules& rules, const WallSpec& w) {
  rules.vector("centre", w.centre, Presence::required);
  rules.finite("angle", w.angle);
  rules.positive("focal_length", w.focal_length, "the focus is inside");
  rules.positive("half_width", w.half_width, "it ends at this distance from its axis");
}

/// Where r(theta) is least on a fine grid: theta, r.
std::pair<double, double> least_radius(const WallSpec& w) {
  std::pair<double, double> least{0, HUGE_VAL};
  const std::size_t n = 64 * std::max<std::size_t>(16, std::max(w.cosines.size(), w.sines.size()));
  for (std::size_t i = 0; i < n; ++i) {
    const double theta = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    double r = 0;
    for (std::size_t k = 0; k < w.cosines.size(); ++k) r += w.cosines[k].value * std::cos(static_cast<double>(k) * theta);
    for (std::size_t k = 0; k < w.sines.size(); ++k) r += w.sines[k].value * std::sin(static_cast<double>(k) * theta);
    if (r < least.second) least = {theta, r};
  }
  return least;
}

void judge_curve(TableRules& rules, const WallSpec& w) {
  rules.vector("centre", w.centre, Presence::required);
  rules.finite("angle", w.angle);
  if (w.cosines.empty())
    return rules.missing("cosines", "r(theta) is a sum of cosines and sines", "Add cosines = [1.0, 0.2] for 1 + 0.2 cos theta");
  bool good = true;
  double size = 0;
  for (const auto& [name, terms] : {std::pair{"cosines", &w.cosines}, std::pair{"sines", &w.sines}}) {
    TableRules list(rules.inner(name));
    for (std::size_t k = 0; k < terms->size(); ++k) {
      good = list.finite(std::to_string(k), (*terms)[k]) && good;
      size += std::abs((*terms)[k].value);
    }
  }
  if (!good) return;
  if (!w.sines.empty() && w.sines[0].value != 0)
    TableRules(rules.inner("sines")).found("0", " is not 0", "sin 0 is 0: the first sine counts nothing", "Begin with 0");
  const auto [theta, r] = least_radius(w);
  if (!(r >= -1e-15 * size) || size == 0)
    rules.found("cosines", size == 0 ? " make no curve" : " make r(" + shown(Number(theta)) + ") = " + shown(Number(r)),
                size == 0 ? "r(theta) is 0 everywhere" : "r(theta) is nowhere below 0");
}

void judge_dimension(TableRules& rules, WallKind kind, int dimension) {
  const bool flat = kind != WallKind::plane && kind != WallKind::circle;
  if (!is_dimension(dimension) || kind == WallKind::plane || dimension == 2) return;
  if (kind == WallKind::circle && dimension == 3) return;
  rules.found("kind", " is " + in_quotes(word_for<WallKind>(wall_kinds, kind)),
              std::string(flat ? "it needs dimension 2" : "it needs dimension 2 or 3") + ", the scene has " +
                  std::to_string(dimension),
              "", {{"dimension"}});
}

/// Walls of straight lines and circles move and swing. A ball on a circle beside a wall that swings would have to be followed for
/// ever: their motions together never repeat.
void judge_motion(TableRules& rules, const WallSpec& w, const Scene& scene) {
  const bool moves = rules.vector("velocity", w.velocity, Presence::optional) && !is_zero(w.velocity);
  const std::string kind(word_for<WallKind>(wall_kinds, w.kind));
  const bool simple = w.kind == WallKind::plane || w.kind == WallKind::segment || w.kind == WallKind::circle ||
                      w.kind == WallKind::polygon;
  const bool magnetic = scene.motion.magnetic && scene.motion.magnetic->value != 0;
  if (magnetic && moves && !simple)
    rules.found("velocity", " moves a wall of kind " + in_quotes(kind) + " in a magnetic field", "that is not built",
                "Let it stand still", {{"motion", "magnetic"}});
  if (!w.oscillation) return;
  TableRules swing(rules.inner("oscillation"));
  const bool swings = swing.vector("amplitude", w.oscillation->amplitude, Presence::required) && !is_zero(w.oscillation->amplitude);
  swing.positive("omega", w.oscillation->omega, "a wall swings at a frequency above 0");
  swing.finite("phase", w.oscillation->phase);
  if (!swings) return;
  if (!simple)
    rules.found("oscillation", " of " + std::string(kind) + " is not built", "planes, segments, circles and polygons swing");
  if (magnetic)
    rules.found("oscillation", " swings a wall in a magnetic field",
                "a ball that circles beside it may never meet it, and nothing repeats that would tell", "", {{"motion", "magnetic"}});
  if (scene.collision.regularise == Regularise::rest)
    rules.found("oscillation", " is not built together with regularise = \"rest\"", "no ball rests on a wall that swings",
                "Use collision.contact_time", {{"collision", "regularise"}});
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
        judge_arc(rules, w);
        break;
      case WallKind::ellipse:
        judge_ellipse(rules, w);
        break;
      case WallKind::parabola:
        judge_parabola(rules, w);
        break;
      case WallKind::curve:
        judge_curve(rules, w);
        break;
    }
    judge_motion(rules, w, j.scene);
    if (w.restitution) rules.restitution(*w.restitution);
    rules.material(w.material);
    if (w.opening && (w.restitution || !w.material.empty()))
      rules.found(w.restitution ? "restitution" : "material", " has no meaning here", "nothing bounces off an opening", "",
                  {rules.key("opening")});
  }
}

}  // namespace carom::scene_text
