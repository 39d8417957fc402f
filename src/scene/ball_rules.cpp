// The rules for what makes balls: [[ball]], [[lattice]], [[gas]].

#include <limits>
#include <map>

#include "keywords.hpp"
#include "table_rules.hpp"
#include "words.hpp"

namespace carom::scene_text {

namespace {

constexpr std::string_view mass_rule = "a mass is above 0, or \"inf\"";
constexpr std::string_view finite_mass_rule = "a mass is above 0";
constexpr std::string_view temperature_rule = "a temperature is 0 or more";

int dimension_of(LatticeKind kind) {
  switch (kind) {
    case LatticeKind::chain:
      return 1;
    case LatticeKind::cubic:
    case LatticeKind::fcc:
      return 3;
    default:
      return 2;
  }
}

bool is_infinite_mass(const Number& mass) { return mass.value == std::numeric_limits<double>::infinity(); }

void judge_rack(TableRules& rules, const LatticeSpec& l) {
  if (l.count != 0) rules.found("count", " is " + std::to_string(l.count), "the balls of a rack follow from its rows");
  if (l.packing_fraction) rules.found("packing_fraction", " has no meaning here", "a rack has a radius and a gap");
  constexpr int most_rows = 65535;  // 2^31 balls
  if (l.rows < 1 || l.rows > most_rows) rules.found("rows", " is " + std::to_string(l.rows), "a rack has 1 to 65535 rows");
  rules.not_negative("gap", l.gap, "a gap is 0 or more");
  rules.vector("apex", l.apex, Presence::required);
  if (rules.vector("direction", l.direction, Presence::optional) && is_zero(l.direction)) {
    rules.found("direction", " is zero", "it points from the apex to the last row");
  }
  if (!l.radius) rules.missing("radius", "the balls of a rack need a size", "Add radius = 0.5");
}

void judge_filling(Judgement& j, TableRules& rules, const LatticeSpec& l) {
  rules.ball_count(l.count);
  if (l.packing_fraction) rules.packing_fraction(*l.packing_fraction);
  if (!l.radius && !l.packing_fraction) {
    rules.missing("radius", "a lattice has a radius or a packing_fraction", "Add packing_fraction = 0.5");
  }
  const auto refuse = [&](std::string_view key) { rules.found(key, " has no meaning here", "only a rack has it"); };
  if (!l.apex.empty()) refuse("apex");
  if (!l.direction.empty()) refuse("direction");
  if (l.gap.value != 0.0) refuse("gap");
  if (j.scene.space.kind == SpaceKind::open) {
    rules.found("kind", " fills [space]", "an open space has no bounds", "Set kind, lower and upper under [space]",
                {{"space"}});
  }
}

}  // namespace

void judge_balls(Judgement& j) {
  std::map<std::string_view, std::size_t> names;
  for (std::size_t i = 0; i < j.scene.balls.size(); ++i) {
    const BallSpec& b = j.scene.balls[i];
    TableRules rules(j, {"ball", std::to_string(i)}, b.where);
    rules.vector("position", b.position, Presence::required);
    rules.vector("velocity", b.velocity, Presence::optional);
    rules.not_negative("radius", b.radius, "a radius is 0 or more");
    if (!is_infinite_mass(b.mass)) rules.positive("mass", b.mass, mass_rule);
    rules.material(b.material);
    if (b.fixed && !is_zero(b.velocity)) {
      rules.found("velocity", " is not zero", "a fixed ball never moves", "Set mass = \"inf\" instead of fixed?",
                  {rules.key("fixed")});
    }
    if (b.name.empty()) continue;
    const auto [first, is_new] = names.emplace(b.name, i);
    if (!is_new) {
      rules.found("name", " is " + in_quotes(b.name), "ball " + std::to_string(first->second) + " has the same name");
    }
  }
}

void judge_lattices(Judgement& j) {
  for (std::size_t i = 0; i < j.scene.lattices.size(); ++i) {
    const LatticeSpec& l = j.scene.lattices[i];
    TableRules rules(j, {"lattice", std::to_string(i)}, l.where);
    const int dimension = dimension_of(l.kind);
    if (is_dimension(j.scene.dimension) && dimension != j.scene.dimension) {
      rules.found("kind", " is " + in_quotes(word_for<LatticeKind>(lattice_kinds, l.kind)),
                  "it has dimension " + std::to_string(dimension) + ", the scene " + std::to_string(j.scene.dimension), "",
                  {{"dimension"}});
    }
    if (l.kind == LatticeKind::rack) {
      judge_rack(rules, l);
    } else {
      judge_filling(j, rules, l);
    }
    if (l.radius) rules.positive("radius", *l.radius, "the balls of a lattice have a radius above 0");
    const bool warm = l.temperature && l.temperature->value > 0.0;
    if (l.temperature) rules.not_negative("temperature", *l.temperature, temperature_rule);
    if (warm || !is_infinite_mass(l.mass)) rules.positive("mass", l.mass, warm ? finite_mass_rule : mass_rule);
    rules.material(l.material);
  }
}

void judge_gases(Judgement& j) {
  for (std::size_t i = 0; i < j.scene.gases.size(); ++i) {
    const GasSpec& g = j.scene.gases[i];
    TableRules rules(j, {"gas", std::to_string(i)}, g.where);
    rules.unbuilt("gas");
    rules.ball_count(g.count);
    if (g.packing_fraction) rules.packing_fraction(*g.packing_fraction);
    if (g.radius) rules.not_negative("radius", *g.radius, "a radius is 0 or more");
    const bool bounded = j.scene.space.kind != SpaceKind::open;
    if (g.speed) rules.positive("speed", *g.speed, "a speed is above 0");
    if (!bounded && !j.scene.tables.empty()) {
      if (!g.radius) rules.missing("radius", "a gas in a table needs the size of its balls", "Add radius = 0.01, or 0 for points");
      if (g.packing_fraction) rules.found("packing_fraction", " has no meaning here", "it is a share of [space], and there is none");
    } else if (!g.radius && !g.packing_fraction) {
      rules.missing("radius", "a gas has a radius or a packing_fraction", "Add packing_fraction = 0.3");
    } else if (!bounded && !(g.radius && g.packing_fraction)) {
      rules.found(g.radius ? "packing_fraction" : "radius", " is missing",
                  "without [space], radius and packing_fraction together set it", "Add [space]?", {{"space"}});
    }
    rules.positive("mass", g.mass, finite_mass_rule);
    rules.not_negative("temperature", g.temperature, temperature_rule);
    rules.material(g.material);
  }
}

}  // namespace carom::scene_text
