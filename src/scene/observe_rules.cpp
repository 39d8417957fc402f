// The rules for [observe].

#include "table_rules.hpp"

namespace carom::scene_text {

namespace {

void judge_every(TableRules& rules, const std::optional<Number>& every) {
  if (every) rules.positive("every", *every, "the time between samples is above 0");
}

void judge_count(TableRules& rules, std::string_view key, std::int64_t n, std::int64_t least, std::int64_t most) {
  if (n < least || n > most)
    rules.found(key, " is " + std::to_string(n),
                "it is a number from " + std::to_string(least) + " to " + std::to_string(most));
}

void judge_lags(Judgement& j, const char* key, const std::optional<LagsSpec>& l) {
  if (!l) return;
  TableRules rules(j, {"observe", key}, j.scene.observe.where);
  judge_every(rules, l->every);
  judge_count(rules, "lags", l->lags, 2, 100'000);
  if (l->origins) judge_count(rules, "origins", *l->origins, 1, 1000);
}

void judge_billiard(Judgement& j) {
  const ObserveSpec& o = j.scene.observe;
  if (const auto& l = o.lyapunov) {
    TableRules rules(j, {"observe", "lyapunov"}, o.where);
    if (l->exponents) judge_count(rules, "exponents", *l->exponents, 1, 100'000);
    if (l->every) rules.positive("every", *l->every, "the time between orthonormalisations is above 0");
    if (l->finite_time) rules.positive("finite_time", *l->finite_time, "a span of time is above 0");
  }
  if (const auto& p = o.poincare) {
    TableRules rules(j, {"observe", "poincare"}, o.where);
    rules.vector("point", p->point, Presence::required);
    if (rules.vector("normal", p->normal, Presence::required) && is_zero(p->normal))
      rules.found("normal", " is zero", "crossings towards it count");
  }
  if (const auto& s = o.survival) {
    TableRules rules(j, {"observe", "survival"}, o.where);
    if (s->from) rules.finite("from", *s->from);
    if (s->to) rules.finite("to", *s->to);
    if (s->from && s->to && !(s->from->value < s->to->value))
      rules.found("to", " is " + shown(*s->to), "the fit ends after it begins", "", {rules.key("from")});
    judge_count(rules, "bins", s->bins, 2, 100'000);
  }
  if (const auto& p = o.phase_space_portion) {
    TableRules rules(j, {"observe", "phase_space_portion"}, o.where);
    judge_count(rules, "bins", p->bins, 2, 10'000);
  }
}

}  // namespace

void judge_observe(Judgement& j) {
  const ObserveSpec& o = j.scene.observe;
  TableRules rules(j, {"observe"}, o.where);
  if (o.after_events || o.after_time) rules.unbuilt("observe.after");
  if (o.pressure) rules.unbuilt("observe.pressure");
  if (o.collision_rate) rules.unbuilt("observe.collision_rate");
  if (o.mean_free_path) rules.unbuilt("observe.mean_free_path");
  if (o.speed_histogram) rules.unbuilt("observe.speed_histogram");

  if (const auto& r = o.radial_distribution) {
    TableRules inner(j, {"observe", "radial_distribution"}, o.where);
    judge_every(inner, r->every);
    if (r->r_max) inner.positive("r_max", *r->r_max, "it is the largest distance of two centres");
    judge_count(inner, "bins", r->bins, 1, 100'000);
  }
  judge_lags(j, "mean_squared_displacement", o.mean_squared_displacement);
  judge_lags(j, "velocity_autocorrelation", o.velocity_autocorrelation);
  judge_lags(j, "angle_autocorrelation", o.angle_autocorrelation);
  judge_lags(j, "diffusion", o.diffusion);
  judge_billiard(j);

  if (o.after_events && o.after_time)
    rules.found("after", " has events and time", "measuring starts once", "Give one of them");
  TableRules after(j, {"observe", "after"}, o.where);
  if (o.after_time) after.finite("time", *o.after_time);
  if (o.after_events && *o.after_events < 0) {
    after.found("events", " is " + std::to_string(*o.after_events), "a number of collisions is 0 or more");
  }
}

}  // namespace carom::scene_text
