#include "table_rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "unbuilt.hpp"
#include "words.hpp"

namespace carom::scene_text {

Judgement::Judgement(const Scene& s) : scene(s) {
  for (const MaterialSpec& m : s.materials) materials.insert(m.name);
}

std::string shown(const Number& n) { return n.text.empty() ? fmt::format("{}", n.value) : n.text; }

bool is_zero(const Coordinates& v) {
  return std::all_of(v.begin(), v.end(), [](const Number& n) { return n.value == 0.0; });
}

std::string example_vector(int dimension) {
  std::string s = "[1";
  for (int i = 1; i < dimension; ++i) s += ", 0";
  return s + "]";
}

void TableRules::found(std::string_view key, const std::string& what, std::string_view why, std::string hint,
                       std::vector<Path> judged_by) {
  const Path path = this->key(key);
  judged_by.insert(judged_by.begin(), path);
  judgement_.findings.push_back({std::move(judged_by), where_, dotted(path) + what, std::string(why), std::move(hint)});
}

void TableRules::missing(std::string_view key, std::string_view why, std::string hint) {
  found(key, " is missing", why, std::move(hint));
}

void TableRules::unbuilt(std::string_view feature, std::string_view value) {
  if (!is_unbuilt(feature, value)) return;
  const std::string_view last = feature.substr(feature.rfind('.') + 1);
  const Path path = feature.find('.') == std::string_view::npos ? table_ : key(last);
  judgement_.findings.push_back({{path}, where_, unbuilt_message(feature, value), std::string(unbuilt_reason), ""});
}

bool TableRules::finite(std::string_view key, const Number& n) {
  if (std::isfinite(n.value)) return true;
  found(key, " is " + shown(n), "a finite number is needed");
  return false;
}

void TableRules::positive(std::string_view key, const Number& n, std::string_view why) {
  if (finite(key, n) && n.value <= 0.0) found(key, " is " + shown(n), why);
}

void TableRules::not_negative(std::string_view key, const Number& n, std::string_view why) {
  if (finite(key, n) && n.value < 0.0) found(key, " is " + shown(n), why);
}

void TableRules::restitution(const Number& e) {
  if (!finite("restitution", e)) return;
  if (e.value < 0.0 || e.value > 1.0) {
    found("restitution", " is " + shown(e), "restitution is from 0 (plastic) to 1 (elastic)");
  }
}

void TableRules::packing_fraction(const Number& phi) {
  if (!finite("packing_fraction", phi)) return;
  if (phi.value <= 0.0 || phi.value > 1.0) {
    found("packing_fraction", " is " + shown(phi), "a share of the space is above 0 and at most 1");
  }
}

void TableRules::ball_count(std::int64_t n) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (n < 1) found("count", " is " + std::to_string(n), "at least 1 ball is needed");
  if (n > most) found("count", " is " + std::to_string(n), "balls are numbered with 31 bits");
}

void TableRules::material(const std::string& name) {
  if (name.empty() || judgement_.materials.count(name) > 0) return;
  const std::vector<std::string_view> known(judgement_.materials.begin(), judgement_.materials.end());
  found("material", " is " + in_quotes(name), "no material has this name",
        known.empty() ? "Add [" + dotted({"material", name}) + "]" : suggestion(name, known), {{"material"}});
}

bool TableRules::vector(std::string_view key, const Coordinates& v, Presence presence) {
  const int dimension = judgement_.scene.dimension;
  if (v.empty()) {
    if (presence == Presence::required) {
      missing(key, "a vector is needed here",
              "Add " + std::string(key) + " = " + example_vector(is_dimension(dimension) ? dimension : 2));
    }
    return false;
  }
  if (is_dimension(dimension) && v.size() != static_cast<std::size_t>(dimension)) {
    const auto components = [](std::size_t n) { return std::to_string(n) + (n == 1 ? " component" : " components"); };
    const std::string hint = v.size() <= 3 ? "Set dimension = " + std::to_string(v.size()) + "?" : "";
    found(key, " has " + components(v.size()), "the scene has dimension " + std::to_string(dimension), hint,
          {{"dimension"}});
    return false;
  }
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (std::isfinite(v[i].value)) continue;
    found(key, " has the component " + shown(v[i]), "finite numbers are needed");
    return false;
  }
  return true;
}

}  // namespace carom::scene_text
