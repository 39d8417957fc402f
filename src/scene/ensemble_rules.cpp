// What [ensemble] may hold.

#include <algorithm>

#include "carom/scene/ensemble.hpp"
#include "ensemble_keys.hpp"
#include "table_rules.hpp"
#include "words.hpp"

namespace carom::scene_text {

namespace {

void judge_vary(Judgement& j, std::size_t index) {
  const VarySpec& v = j.scene.ensemble->vary[index];
  TableRules rules(j, {"ensemble", "vary", std::to_string(index)}, v.where);
  if (v.key.empty()) return rules.found("key", " is empty", "it is a dotted path", "Write key = \"ball.0.velocity\"");
  if (v.key == "ensemble" || v.key.starts_with("ensemble."))
    rules.found("key", " is " + in_quotes(v.key), "an ensemble does not vary itself");
  const bool range = v.from || v.to;
  if (range && !v.values.empty()) return rules.found("values", " and a range", "it has one of them", "", {rules.key("from")});
  if (v.values.empty() && !range && !ball_key(v.key) && !is_seed_key(v.key))
    rules.found("key", " is " + in_quotes(v.key) + ", without values and range",
                "directions, places and seeds are drawn by themselves: ball.0, ball.0.position, ball.0.velocity, gas.0.seed",
                "Give from and to, or values");
  if (v.steps != 0 && (!range || v.steps < 2))
    rules.found("steps", " is " + std::to_string(v.steps), "a range with from and to is walked in 2 steps or more");
  if (range && !(v.from && v.to)) return rules.missing(v.from ? "to" : "from", "a range has two ends");
  if (range && rules.finite("from", *v.from)) rules.finite("to", *v.to);
}

}  // namespace

void judge_ensemble(Judgement& j) {
  if (!j.scene.ensemble) return;
  const EnsembleSpec& e = *j.scene.ensemble;
  TableRules rules(j, {"ensemble"}, e.where);
  const auto too_many = [&](const char* key) {
    rules.found(key, " makes more than " + std::to_string(most_runs) + " runs", "that is the limit");
  };
  const std::int64_t count = e.count.value_or(1);
  if (count < 1) rules.found("count", " is " + std::to_string(count), "there is at least one run");
  if (count > most_runs) return too_many("count");
  std::int64_t runs = std::max<std::int64_t>(count, 1), zipped = 0;
  for (std::size_t i = 0; i < e.vary.size(); ++i) {
    judge_vary(j, i);
    const VarySpec& v = e.vary[i];
    const std::int64_t length = v.values.empty() ? v.steps : static_cast<std::int64_t>(v.values.size());
    if (length <= 0) continue;
    if (e.combine == Combine::zip) {
      if (zipped != 0 && zipped != length)
        return rules.found("vary", " has lists of " + std::to_string(zipped) + " and " + std::to_string(length) + " values",
                           "lists that are zipped are equally long", "Or combine = \"grid\"");
      zipped = length;
    } else if (length > most_runs / runs) {
      return too_many("vary");
    } else {
      runs *= length;
    }
  }
  if (zipped > 0 && zipped > most_runs / runs) too_many("vary");
}

}  // namespace carom::scene_text
