#include "rules.hpp"

#include <algorithm>
#include <utility>

#include "keywords.hpp"
#include "ready_tables.hpp"
#include "table_rules.hpp"
#include "words.hpp"

namespace carom::scene_text {

namespace {

void judge_dimension(Judgement& j) {
  const int d = j.scene.dimension;
  if (!is_dimension(d))
    TableRules(j, {}, {}).found("dimension", " is " + std::to_string(d), "a scene has dimension 1, 2 or 3");
}

void judge_space(Judgement& j) {
  const SpaceSpec& s = j.scene.space;
  TableRules rules(j, {"space"}, s.where);
  const std::string_view kind = word_for<SpaceKind>(space_kinds, s.kind);
  rules.unbuilt("space.kind", kind);
  if (s.kind == SpaceKind::open) {
    const auto refuse = [&](std::string_view key) {
      rules.found(key, " has no meaning here", "an open space has no faces", "Set kind = \"box\" or \"periodic\"?",
                  {rules.key("kind")});
    };
    if (!s.lower.empty()) refuse("lower");
    if (!s.upper.empty()) refuse("upper");
    if (s.restitution) refuse("restitution");
    if (!s.material.empty()) refuse("material");
    return;
  }
  if (s.lower.empty() && s.upper.empty()) {
    const bool sized = std::any_of(j.scene.gases.begin(), j.scene.gases.end(),
                                   [](const GasSpec& g) { return g.radius && g.packing_fraction; });
    rules.found("lower", " and space.upper are missing", "a " + std::string(kind) + " space lies between two corners",
                  sized && s.kind == SpaceKind::periodic
                      ? "Leave out [space]: radius and packing_fraction of the gas make a periodic space that fits"
                      : "Add the corners, as in lower = [0, 0], upper = [10, 5] in 2-D");
    return;
  }
  const bool lower = rules.vector("lower", s.lower, Presence::required);
  const bool upper = rules.vector("upper", s.upper, Presence::required);
  for (std::size_t i = 0; lower && upper && i < s.lower.size() && i < s.upper.size(); ++i) {
    if (s.lower[i].value < s.upper[i].value) continue;
    rules.found("upper", " has the component " + shown(s.upper[i]),
                "each is above that of space.lower, here " + shown(s.lower[i]), "", {rules.key("lower")});
    break;
  }
  if (s.kind == SpaceKind::periodic && (s.restitution || !s.material.empty())) {
    rules.found(s.restitution ? "restitution" : "material", " has no meaning here", "a periodic space has no faces");
  }
  if (s.restitution) rules.restitution(*s.restitution);
  rules.material(s.material);
}

void judge_motion(Judgement& j) {
  const MotionSpec& m = j.scene.motion;
  TableRules rules(j, {"motion"}, m.where);
  if (rules.vector("acceleration", m.acceleration, Presence::optional) && !is_zero(m.acceleration)) {
    rules.unbuilt("motion.acceleration");
  }
  if (!m.magnetic || !rules.finite("magnetic", *m.magnetic) || m.magnetic->value == 0) return;
  if (is_dimension(j.scene.dimension) && j.scene.dimension != 2)
    rules.found("magnetic", " needs dimension 2", "the field stands across the plane that balls circle in", "", {{"dimension"}});
  if (!is_zero(m.acceleration))
    rules.found("magnetic", " is not built together with motion.acceleration", "their paths are cycloids, not circles",
                "Leave one of them out", {rules.key("acceleration")});
}

void judge_collision(Judgement& j) {
  const CollisionSpec& c = j.scene.collision;
  TableRules rules(j, {"collision"}, c.where);
  rules.unbuilt("collision.law", word_for<LawKind>(law_kinds, c.law));
  rules.restitution(c.restitution);
  if (c.regularise == Regularise::rest && c.simultaneous == Simultaneous::symmetric)
    rules.found("regularise", " is \"rest\"", "rest with simultaneous = \"symmetric\" is not built yet", "",
                {rules.key("simultaneous")});
  if (c.law != LawKind::restitution && c.simultaneous == Simultaneous::symmetric)
    rules.found("simultaneous", " is \"symmetric\"",
                "balls that " + std::string(word_for<LawKind>(law_kinds, c.law)) + " do so pair by pair", "",
                {rules.key("law")});
  rules.not_negative("contact_time", c.contact_time, "a contact lasts some time, or 0 (off)");
  if (c.reference_speed)
    rules.positive("reference_speed", *c.reference_speed, "it is the speed of approach at which restitution holds as given");
  const bool viscoelastic = c.regularise == Regularise::viscoelastic;
  if (viscoelastic && !c.reference_speed)
    rules.missing("reference_speed", "viscoelastic restitution depends on the speed, and is given at one",
                  "Add reference_speed = 1.0");
  if (!viscoelastic && c.reference_speed)
    rules.found("reference_speed", " has no meaning here", "restitution depends on the speed only if viscoelastic",
                "Add regularise = \"viscoelastic\"?", {rules.key("regularise")});
  if (c.law == LawKind::restitution) return;
  const std::string why =
      "balls that " + std::string(word_for<LawKind>(law_kinds, c.law)) + " do not bounce: it belongs to law = \"restitution\"";
  if (c.contact_time.value > 0) rules.found("contact_time", " is " + shown(c.contact_time), why, "", {rules.key("law")});
  if (c.regularise != Regularise::stop)
    rules.found("regularise", " is " + in_quotes(word_for<Regularise>(regularise_kinds, c.regularise)), why, "",
                {rules.key("law")});
}

/// A viscoelastic impact always returns something.
void judge_viscoelastic(Judgement& j) {
  const Scene& s = j.scene;
  if (s.collision.regularise != Regularise::viscoelastic) return;
  const auto judge = [&](const Path& table, Where where, const Number& e) {
    if (e.value == 0.0)
      TableRules(j, table, where)
          .found("restitution", " is 0", "a viscoelastic impact returns something", "Give a value above 0",
                 {{"collision", "regularise"}});
  };
  judge({"collision"}, s.collision.where, s.collision.restitution);
  if (s.space.restitution) judge({"space"}, s.space.where, *s.space.restitution);
  for (const MaterialSpec& m : s.materials) judge({"material", m.name}, m.where, m.restitution);
  for (std::size_t i = 0; i < s.material_pairs.size(); ++i)
    judge({"material_pair", std::to_string(i)}, s.material_pairs[i].where, s.material_pairs[i].restitution);
  for (std::size_t i = 0; i < s.walls.size(); ++i)
    if (s.walls[i].restitution) judge({"wall", std::to_string(i)}, s.walls[i].where, *s.walls[i].restitution);
}

void judge_materials(Judgement& j) {
  std::set<std::string> names;
  for (const MaterialSpec& m : j.scene.materials) {
    const Path path{"material", m.name};
    if (m.name.empty()) j.findings.push_back({{path}, m.where, "a material has no name", "it is used by its name", ""});
    if (!names.insert(m.name).second) {
      j.findings.push_back({{path}, m.where, dotted(path) + " is given twice", "a material has one definition", ""});
    }
    TableRules(j, path, m.where).restitution(m.restitution);
  }
}

void judge_material_pairs(Judgement& j) {
  std::set<std::pair<std::string, std::string>> pairs;
  for (std::size_t i = 0; i < j.scene.material_pairs.size(); ++i) {
    const MaterialPairSpec& p = j.scene.material_pairs[i];
    TableRules rules(j, {"material_pair", std::to_string(i)}, p.where);
    for (const std::string& name : {p.first, p.second}) {
      if (j.materials.count(name) > 0) continue;
      const std::vector<std::string_view> known(j.materials.begin(), j.materials.end());
      rules.found("of", " names " + in_quotes(name), "no material has this name",
                  known.empty() ? "Add [" + dotted({"material", name}) + "]" : suggestion(name, known), {{"material"}});
    }
    if (!pairs.insert(std::minmax(p.first, p.second)).second) {
      rules.found("of", " is given twice", "two materials have one restitution");
    }
    rules.restitution(p.restitution);
  }
}

void judge_run(Judgement& j) {
  const RunSpec& r = j.scene.run;
  TableRules rules(j, {"run"}, r.where);
  if (!r.until && !r.events && !r.until_packing && !r.until_reduced_pressure) {
    j.findings.push_back({{rules.key("until"), rules.key("events")},
                          r.where,
                          "the run has no end",
                          "run.until or run.events is required",
                          "Add until = 10.0 under [run]"});
  }
  const bool start = rules.finite("start", r.start);
  if (r.until && rules.finite("until", *r.until) && start && r.until->value < r.start.value) {
    rules.found("until", " is " + shown(*r.until), "that is before run.start = " + shown(r.start), "",
                {rules.key("start")});
  }
  if (r.events && *r.events < 0)
    rules.found("events", " is " + std::to_string(*r.events), "a number of collisions is 0 or more");
  if (r.sample_every) rules.positive("sample_every", *r.sample_every, "the time between frames is above 0");
}

void judge_output(Judgement& j) {
  const OutputSpec& o = j.scene.output;
  TableRules rules(j, {"output"}, o.where);
  if (!o.events.empty() && o.events == o.trajectory)
    rules.found("trajectory", " is " + in_quotes(o.trajectory), "output.events has the same name");
  if (!o.ledger.empty() && (o.ledger == o.events || o.ledger == o.trajectory))
    rules.found("ledger", " is " + in_quotes(o.ledger), "another file of [output] has the same name");
  TableRules every(j, {"output", "checkpoint", "every"}, o.where);
  if (o.checkpoint_every_time) {
    every.finite("time", *o.checkpoint_every_time);
    if (o.checkpoint_every_time->value <= 0)
      every.found("time", " is not above 0", "it is a span of time", "Leave it out for one at the end");
  }
  if (o.checkpoint_every_events && *o.checkpoint_every_events <= 0)
    every.found("events", " is not above 0", "it is a number of collisions", "Leave it out for one at the end");
  if (o.trajectory.empty()) return;
  const std::size_t dot = o.trajectory.rfind('.');
  const std::string ending = dot == std::string::npos ? "" : o.trajectory.substr(dot);
  if (ending != ".csv" && ending != ".h5" && ending != ".xyz")
    rules.found("trajectory", " is " + in_quotes(o.trajectory), "its ending says the format: .h5, .xyz or .csv");
}

void judge_presence(Judgement& j) {
  const Scene& s = j.scene;
  const bool cradle = std::any_of(s.tables.begin(), s.tables.end(), [](const TableSpec& t) { return t.kind == TableKind::cradle; });
  if (!s.balls.empty() || !s.lattices.empty() || !s.gases.empty() || cradle) return;
  j.findings.push_back(
      {{{"ball"}, {"lattice"}, {"gas"}}, {}, "the scene has no balls", "there is nothing to move", "Add a [[ball]]"});
}

}  // namespace

std::vector<Finding> findings(const Scene& scene) {
  Judgement j(scene);
  judge_dimension(j);
  judge_space(j);
  judge_motion(j);
  judge_collision(j);
  judge_viscoelastic(j);
  judge_materials(j);
  judge_material_pairs(j);
  judge_balls(j);
  judge_lattices(j);
  judge_gases(j);
  judge_walls(j);
  judge_tables(j);
  judge_ensemble(j);
  judge_run(j);
  judge_growth(j);
  judge_observe(j);
  judge_output(j);
  judge_presence(j);
  return std::move(j.findings);
}

}  // namespace carom::scene_text
