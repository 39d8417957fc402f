// [ensemble] and --vary.

#include <algorithm>
#include <stdexcept>

#include "carom/core/error.hpp"
#include "carom/scene/ensemble.hpp"
#include "ensemble_keys.hpp"
#include "tables.hpp"
#include "words.hpp"

namespace carom {

namespace scene_text {

namespace {

VarySpec read_vary(TableReader t) {
  VarySpec v;
  v.where = t.where();
  t.require("key", "it says what is varied", "Add key = \"ball.0.velocity\"");
  t.text("key", v.key);
  t.values("values", v.values);
  t.number("from", v.from);
  t.number("to", v.to);
  t.integer("steps", v.steps);
  t.finish();
  return v;
}

// The parts between `separator`s that are in no quotes and no brackets.
std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == '\\' && quote == '"' && i + 1 < text.size()) parts.back() += text[i++];
      else if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == separator && depth == 0) {
      parts.emplace_back();
      continue;
    }
    parts.back() += text[i];
  }
  return parts;
}

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
  while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
  return s;
}

bool is_bracketed(std::string_view s) { return s.size() >= 2 && s.front() == '[' && s.back() == ']'; }

std::vector<std::string> elements(std::string_view array) {
  std::vector<std::string> parts = split(array.substr(1, array.size() - 2), ',');
  for (std::string& p : parts) p = std::string(trimmed(p));
  if (parts.back().empty()) parts.pop_back();  // [a, b,] and []
  return parts;
}

Number number_of(std::string_view text) {
  text = trimmed(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return parse_number(text);
}

}  // namespace

EnsembleSpec read_ensemble(TableReader t) {
  EnsembleSpec e;
  e.where = t.where();
  t.integer("count", e.count);
  t.seed("seed", e.seed);
  t.word<Combine>("combine", combinations, e.combine);
  t.tables("vary", [&](std::optional<TableReader> v) { e.vary.push_back(v ? read_vary(std::move(*v)) : VarySpec()); });
  t.finish();
  return e;
}

}  // namespace scene_text

VarySpec parse_vary(std::string_view text) {
  using namespace scene_text;
  const auto refuse = [&](std::string why) {
    return InputError(Problem{"", 0, "--vary " + std::string(text), std::move(why),
                              "For instance --vary collision.restitution=0.5:1:11 or --vary 'wall.0.radius=[1, 2]'"});
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0)
    throw refuse("it has the form KEY=FROM:TO:STEPS, KEY=FROM:TO, KEY=[a, b, c] or KEY=random");
  VarySpec v;
  v.key = text.substr(0, equals);
  const std::vector<std::string> parts = split(text.substr(equals + 1), ':');
  if (parts.size() == 1 && trimmed(parts[0]) == "random") {
    if (!ball_key(v.key) && !is_seed_key(v.key))
      throw refuse("directions, places and seeds are drawn by themselves: ball.0, ball.0.position, ball.0.velocity, gas.0.seed");
    return v;
  }
  if (parts.size() == 1) {
    if (!is_bracketed(trimmed(parts[0]))) throw refuse("a single value varies nothing");
    v.values = elements(trimmed(parts[0]));
    if (v.values.empty()) throw refuse("the list is empty");
    return v;
  }
  if (parts.size() > 3) throw refuse("a range has the form FROM:TO:STEPS or FROM:TO");
  try {
    v.from = number_of(parts[0]);
    v.to = number_of(parts[1]);
    if (parts.size() == 3) {
      std::size_t used = 0;
      v.steps = std::stoll(parts[2], &used);
      if (used != parts[2].size() || v.steps < 2) throw refuse("the steps of a range are a whole number from 2 on");
    }
  } catch (const std::logic_error&) {
    throw refuse("the ends of a range are numbers, and its steps a whole number from 2 on");
  }
  return v;
}

}  // namespace carom
