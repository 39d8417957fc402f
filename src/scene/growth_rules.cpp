// The rules for balls that grow: what grows, what else the scene may ask for then, and when such a run ends.

#include <algorithm>

#include "carom/scene/growing.hpp"
#include "keywords.hpp"
#include "table_rules.hpp"
#include "unbuilt.hpp"
#include "words.hpp"

namespace carom::scene_text {

namespace {

constexpr std::string_view rate_rule = "a radius grows, or stays as it is (0)";

template <class Spec>
void judge_rates(Judgement& j, const char* table, const std::vector<Spec>& specs) {
  for (std::size_t i = 0; i < specs.size(); ++i)
    TableRules(j, {table, std::to_string(i)}, specs[i].where)
        .not_negative("radius_growth", specs[i].radius_growth, rate_rule);
}

/// The first key that says that balls grow.
Path growing_key(const Scene& s) {
  const auto first = [](const char* table, const auto& specs) -> Path {
    for (std::size_t i = 0; i < specs.size(); ++i)
      if (specs[i].radius_growth.value > 0) return Path{table, std::to_string(i)} / std::string("radius_growth");
    return {};
  };
  for (Path p : {first("ball", s.balls), first("lattice", s.lattices), first("gas", s.gases)})
    if (!p.empty()) return p;
  return {};
}

/// Growing balls fly straight and bounce off straight and round walls, one impact at a time.
void judge_company(Judgement& j) {
  const Scene& s = j.scene;
  const Path grows = growing_key(s);
  const auto refuse = [&](const Path& table, Where where, std::string_view key, const std::string& what) {
    TableRules(j, table, where).found(key, what + " with balls that grow: not built yet", unbuilt_reason, "", {grows});
  };
  const CollisionSpec& c = s.collision;
  if (c.law != LawKind::restitution)
    refuse({"collision"}, c.where, "law", " is " + in_quotes(word_for<LawKind>(law_kinds, c.law)));
  if (c.simultaneous != Simultaneous::sequential) refuse({"collision"}, c.where, "simultaneous", " is \"symmetric\"");
  if (c.regularise != Regularise::stop)
    refuse({"collision"}, c.where, "regularise", " is " + in_quotes(word_for<Regularise>(regularise_kinds, c.regularise)));
  if (!is_zero(s.motion.acceleration)) refuse({"motion"}, s.motion.where, "acceleration", " is not zero");
  if (s.motion.magnetic && s.motion.magnetic->value != 0) refuse({"motion"}, s.motion.where, "magnetic", " is not zero");
  for (std::size_t i = 0; i < s.walls.size(); ++i) {
    const WallSpec& w = s.walls[i];
    const bool known = w.kind == WallKind::segment || w.kind == WallKind::plane || w.kind == WallKind::circle ||
                       w.kind == WallKind::polygon;
    const Path table{"wall", std::to_string(i)};
    if (!known) refuse(table, w.where, "kind", " is curved");
    if (w.opening) refuse(table, w.where, "opening", " is true");
    if (w.oscillation) refuse(table, w.where, "oscillation", " is there");
  }
  const ObserveSpec& o = s.observe;
  if (o.pressure) refuse({"observe"}, o.where, "pressure", " is true");
  if (s.run.rescale_every) {  // they follow the speeds from impact to impact
    if (o.mean_free_path) refuse({"observe"}, o.where, "mean_free_path", " is true");
    if (o.speed_histogram) refuse({"observe"}, o.where, "speed_histogram", " is true");
  }
  if (o.lyapunov) refuse({"observe"}, o.where, "lyapunov", " is there");
}

}  // namespace

void judge_growth(Judgement& j) {
  const RunSpec& r = j.scene.run;
  judge_rates(j, "ball", j.scene.balls);
  judge_rates(j, "lattice", j.scene.lattices);
  judge_rates(j, "gas", j.scene.gases);
  TableRules rules(j, {"run"}, r.where);
  if (balls_grow(j.scene)) {
    judge_company(j);
  } else {
    const auto idle = [&](std::string_view key) {
      rules.found(key, " has no meaning here", "no ball grows", "Add radius_growth = 0.01 to the gas?");
    };
    if (r.until_packing) idle("until_packing");
    if (r.until_reduced_pressure) idle("until_reduced_pressure");
    if (r.rescale_every) idle("rescale_every");
  }
  if (r.until_packing && rules.finite("until_packing", *r.until_packing) &&
      (r.until_packing->value <= 0 || r.until_packing->value >= 1))
    rules.found("until_packing", " is " + shown(*r.until_packing), "a share of the space is above 0 and below 1");
  if (r.until_reduced_pressure && rules.finite("until_reduced_pressure", *r.until_reduced_pressure) &&
      r.until_reduced_pressure->value <= 1)
    rules.found("until_reduced_pressure", " is " + shown(*r.until_reduced_pressure), "that of an ideal gas is 1");
  if (r.rescale_every && *r.rescale_every < 1)
    rules.found("rescale_every", " is " + std::to_string(*r.rescale_every), "it is a number of collisions, 1 or more");
}

}  // namespace carom::scene_text
