#include <cmath>
#include <numbers>

#include "ready_tables.hpp"
#include "words.hpp"

namespace carom::scene_text {

namespace {

constexpr std::string_view above_zero = "a length is above 0";

/// `n` numbers above 0.
bool lengths(TableRules& rules, std::string_view key, const std::vector<Number>& v, std::size_t n, std::string_view why) {
  if (v.size() != n) {
    rules.found(key, " has " + std::to_string(v.size()) + (v.size() == 1 ? " number" : " numbers"), why);
    return false;
  }
  for (const Number& x : v)
    if (!(x.value > 0) || !std::isfinite(x.value)) {
      rules.found(key, " holds " + shown(x), above_zero);
      return false;
    }
  return true;
}

void judge_mushroom(TableRules& rules, const TableSpec& t) {
  rules.positive("cap_radius", t.cap_radius, above_zero);
  rules.positive("stem_width", t.stem_width, above_zero);
  rules.positive("stem_length", t.stem_length, above_zero);
  if (t.stem_width.value > 2 * t.cap_radius.value)
    rules.found("stem_width", " is " + shown(t.stem_width),
                "a stem is no wider than its cap, 2 cap_radius = " + shown(Number(2 * t.cap_radius.value)), "",
                {rules.key("cap_radius")});
}

void judge_sinai(TableRules& rules, const TableSpec& t) {
  rules.positive("radius", t.radius, above_zero);
  if (!lengths(rules, "size", t.size, 2, "the cell has a width and a height, or one number for both")) return;
  const double room = std::min(t.size[0].value, t.size[1].value) / 2;
  if (t.radius.value >= room)
    rules.found("radius", " is " + shown(t.radius), "a disk that fits into the cell has a radius below " + shown(Number(room)),
                "", {rules.key("size")});
}

void judge_spacing(TableRules& rules, const TableSpec& t) {
  rules.positive("radius", t.radius, above_zero);
  rules.positive("spacing", t.spacing, above_zero);
  if (t.radius.value > 0 && t.spacing.value < 2 * t.radius.value)
    rules.found("spacing", " is " + shown(t.spacing),
                "disks that do not overlap have centres at least 2 radius = " + shown(Number(2 * t.radius.value)) + " apart",
                "", {rules.key("radius")});
}

void judge_triangle(TableRules& rules, const TableSpec& t) {
  if (!lengths(rules, "lengths", t.lengths, 3, "a triangle has three sides")) return;
  for (std::size_t k = 0; k < 3; ++k)
    if (!(t.lengths[k].value < t.lengths[(k + 1) % 3].value + t.lengths[(k + 2) % 3].value)) {
      rules.found("lengths", " holds " + shown(t.lengths[k]), "each side of a triangle is shorter than the other two together");
      return;
    }
}

void judge_annulus(TableRules& rules, const TableSpec& t) {
  rules.positive("inner", t.inner, above_zero);
  rules.positive("outer", t.outer, above_zero);
  if (rules.finite("offset", t.offset) && !(t.inner.value + std::abs(t.offset.value) < t.outer.value))
    rules.found("inner", " is " + shown(t.inner), "the inner circle lies inside the outer one: inner + |offset| < outer", "",
                {rules.key("outer"), rules.key("offset")});
}

void judge_count(TableRules& rules, std::string_view key, std::int64_t n, std::int64_t least, std::int64_t most) {
  if (n < least || n > most)
    rules.found(key, " is " + std::to_string(n),
                "it is a number from " + std::to_string(least) + " to " + std::to_string(most));
}

void judge_numbers(TableRules& rules, const TableSpec& t) {
  switch (t.kind) {
    case TableKind::rectangle:
      lengths(rules, "size", t.size, 2, "a rectangle has a width and a height");
      break;
    case TableKind::circle:
      rules.positive("radius", t.radius, above_zero);
      break;
    case TableKind::ellipse:
      lengths(rules, "axes", t.axes, 2, "an ellipse has two semi-axes");
      break;
    case TableKind::stadium:
      rules.positive("radius", t.radius, above_zero);
      rules.positive("length", t.length, "the straight parts have a length above 0; without them it is a circle");
      break;
    case TableKind::mushroom:
      judge_mushroom(rules, t);
      break;
    case TableKind::sinai:
      judge_sinai(rules, t);
      break;
    case TableKind::lorentz:
    case TableKind::pinball:
      judge_spacing(rules, t);
      break;
    case TableKind::polygon:
      judge_count(rules, "sides", t.sides, 3, 10'000);
      rules.positive("side", t.side, above_zero);
      break;
    case TableKind::triangle:
      judge_triangle(rules, t);
      break;
    case TableKind::wedge:
      rules.positive("length", t.length, above_zero);
      if (!(t.opening_angle.value > 0 && t.opening_angle.value < std::numbers::pi))
        rules.found("angle", " is " + shown(t.opening_angle), "the angle between the sides is between 0 and pi");
      break;
    case TableKind::cardioid:
      rules.positive("scale", t.scale, above_zero);
      break;
    case TableKind::annulus:
      judge_annulus(rules, t);
      break;
    case TableKind::cradle:
      judge_count(rules, "count", t.count, 1, 1'000'000);
      rules.positive("radius", t.radius, above_zero);
      break;
    case TableKind::pool:
      rules.positive("length", t.length, above_zero);
      break;
  }
}

bool brings_space(const TableSpec& t) { return t.kind == TableKind::sinai || t.kind == TableKind::lorentz; }

}  // namespace

void judge_tables(Judgement& j) {
  const Scene& scene = j.scene;
  for (std::size_t i = 0; i < scene.tables.size(); ++i) {
    const TableSpec& t = scene.tables[i];
    TableRules rules(j, {"table", std::to_string(i)}, t.where);
    const std::string kind = " is " + in_quotes(word_for<TableKind>(table_kinds, t.kind));
    if (is_dimension(scene.dimension) && scene.dimension != 2 && !(t.kind == TableKind::cradle && scene.dimension == 1))
      rules.found("kind", kind, "tables need dimension 2, the scene has " + std::to_string(scene.dimension), "",
                  {{"dimension"}});
    if (brings_space(t) && !scene.tables_in && scene.space.kind != SpaceKind::open)
      rules.found("kind", kind, "such a table brings its own [space]", "Leave out [space]", {{"space"}});
    if (brings_space(t) && scene.tables.size() > 1)
      rules.found("kind", kind, "such a table fills the whole space, and the scene has other tables");
    rules.vector("centre", t.centre, Presence::optional);
    rules.finite("angle", t.angle);
    judge_numbers(rules, t);
    if (t.restitution) rules.restitution(*t.restitution);
    rules.material(t.material);
  }
}

}  // namespace carom::scene_text
