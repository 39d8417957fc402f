#pragma once
// The rules that many tables share: ranges of numbers, components of vectors, names of materials.

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rules.hpp"

namespace carom::scene_text {

/// What all tables of a scene are judged by, and what was found.
struct Judgement {
  const Scene& scene;
  std::set<std::string, std::less<>> materials;
  std::vector<Finding> findings;

  explicit Judgement(const Scene& s);
};

enum class Presence { optional, required };

/// The rules for one table: [space], [[ball]] 3, ...
class TableRules {
 public:
  TableRules(Judgement& judgement, Path table, Where where)
      : judgement_(judgement), table_(std::move(table)), where_(where) {}

  void found(std::string_view key, const std::string& what, std::string_view why, std::string hint = {},
             std::vector<Path> judged_by = {});
  void missing(std::string_view key, std::string_view why, std::string hint = {});
  void unbuilt(std::string_view feature, std::string_view value = {});

  bool finite(std::string_view key, const Number& n);
  void positive(std::string_view key, const Number& n, std::string_view why);
  void not_negative(std::string_view key, const Number& n, std::string_view why);
  void restitution(const Number& e);
  void packing_fraction(const Number& phi);
  void ball_count(std::int64_t n);
  void material(const std::string& name);

  /// Finite numbers, as many as the scene has dimensions. False if it is not there or wrong.
  bool vector(std::string_view key, const Coordinates& v, Presence presence);

  /// The rules for a table or array in this one.
  [[nodiscard]] TableRules inner(std::string_view name) const { return {judgement_, key(name), where_}; }

  [[nodiscard]] Path key(std::string_view name) const { return table_ / std::string(name); }

 private:
  Judgement& judgement_;
  Path table_;
  Where where_;
};

/// As the user wrote it, or the shortest text that reads back the same.
[[nodiscard]] std::string shown(const Number& n);

[[nodiscard]] bool is_zero(const Coordinates& v);

/// A dimension that the other rules may judge by.
[[nodiscard]] inline bool is_dimension(int d) { return d >= 1 && d <= 3; }

/// "[1, 0]": an example of a vector with this many components, for hints.
[[nodiscard]] std::string example_vector(int dimension);

void judge_balls(Judgement& judgement);
void judge_lattices(Judgement& judgement);
void judge_gases(Judgement& judgement);
void judge_walls(Judgement& judgement);
void judge_observe(Judgement& judgement);
void judge_ensemble(Judgement& judgement);
void judge_growth(Judgement& judgement);

}  // namespace carom::scene_text
