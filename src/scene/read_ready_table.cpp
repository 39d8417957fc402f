#include <algorithm>
#include <array>

#include "ready_tables.hpp"
#include "words.hpp"

namespace carom::scene_text {

namespace {

// The keys of each kind beside kind, centre, restitution and material.
struct KindKeys {
  TableKind kind;
  std::array<std::string_view, 4> keys;
};
constexpr std::array kind_keys{KindKeys{TableKind::rectangle, {"size", "angle"}},
                               KindKeys{TableKind::circle, {"radius", "angle"}},
                               KindKeys{TableKind::ellipse, {"axes", "angle"}},
                               KindKeys{TableKind::stadium, {"radius", "length", "angle"}},
                               KindKeys{TableKind::mushroom, {"cap_radius", "stem_width", "stem_length", "angle"}},
                               KindKeys{TableKind::sinai, {"size", "radius", "periodic"}},
                               KindKeys{TableKind::lorentz, {"lattice", "spacing", "radius"}},
                               KindKeys{TableKind::polygon, {"sides", "side", "angle"}},
                               KindKeys{TableKind::triangle, {"lengths", "angle"}},
                               KindKeys{TableKind::wedge, {"length", "angle"}},
                               KindKeys{TableKind::cardioid, {"scale", "angle"}},
                               KindKeys{TableKind::pinball, {"spacing", "radius", "angle"}},
                               KindKeys{TableKind::annulus, {"inner", "outer", "offset", "angle"}},
                               KindKeys{TableKind::cradle, {"count", "radius", "angle"}},
                               KindKeys{TableKind::pool, {"length", "angle"}}};

bool has(const KindKeys& k, std::string_view key) {
  return !key.empty() && std::find(k.keys.begin(), k.keys.end(), key) != k.keys.end();
}

/// What no default can stand for; `example` is a value.
struct Needed {
  std::string_view key, example;
};
constexpr std::array needed{Needed{"size", "[2, 1]"},     Needed{"radius", "1.0"},      Needed{"axes", "[2, 1]"},
                            Needed{"length", "2.0"},      Needed{"cap_radius", "1.0"},  Needed{"stem_width", "0.5"},
                            Needed{"stem_length", "1.0"}, Needed{"lattice", "\"triangular\""}, Needed{"spacing", "2.5"},
                            Needed{"sides", "5"},         Needed{"side", "1.0"},        Needed{"lengths", "[3, 4, 5]"},
                            Needed{"scale", "1.0"},       Needed{"inner", "0.5"},       Needed{"outer", "1.0"},
                            Needed{"count", "5"}};

void read_lengths(TableReader& t, std::string_view key, std::vector<Number>& to) { t.coordinates(key, to); }

/// One number is a square.
void read_size(TableReader& t, Coordinates& to) {
  const toml::node* node = t.source().get("size");
  if (node == nullptr || node->is_array()) return t.coordinates("size", to);
  Number side;
  t.number("size", side);
  to = {side, side};
}

void read_numbers(TableReader& t, const KindKeys& keys, TableSpec& s) {
  struct NumberKey {
    std::string_view key;
    Number* to;
  };
  for (const NumberKey& n : {NumberKey{"radius", &s.radius}, {"length", &s.length}, {"cap_radius", &s.cap_radius},
                             {"stem_width", &s.stem_width}, {"stem_length", &s.stem_length}, {"side", &s.side},
                             {"spacing", &s.spacing}, {"inner", &s.inner}, {"outer", &s.outer}, {"offset", &s.offset},
                             {"scale", &s.scale}})
    if (has(keys, n.key)) t.number(n.key, *n.to);
  if (has(keys, "angle")) t.number("angle", s.kind == TableKind::wedge ? s.opening_angle : s.angle);
}

}  // namespace

TableSpec read_ready_table(TableReader t) {
  TableSpec s;
  s.where = t.where();
  t.require("kind", "a table has a kind", "Add kind = \"stadium\"");
  if (!t.has("kind") || !t.word<TableKind>("kind", table_kinds, s.kind)) {
    t.abandon();
    return s;
  }
  const std::string_view word = word_for<TableKind>(table_kinds, s.kind);
  const KindKeys& keys =
      *std::find_if(kind_keys.begin(), kind_keys.end(), [&](const KindKeys& k) { return k.kind == s.kind; });
  const std::string why = "a table of kind \"" + std::string(word) + "\" is given by it";
  for (const Needed& n : needed)
    if (has(keys, n.key)) t.require(n.key, why, "Add " + std::string(n.key) + " = " + std::string(n.example));
  if (s.kind == TableKind::wedge) t.require("angle", "it is the angle between the two sides", "Add angle = 1.0");
  for (const KindKeys& other : kind_keys)
    for (const std::string_view key : other.keys)
      if (!key.empty() && !has(keys, key) && t.has(key))
        t.misplaced(key, "it belongs to kind = \"" + std::string(word_for<TableKind>(table_kinds, other.kind)) +
                             "\", not \"" + std::string(word) + '"');
  t.coordinates("centre", s.centre);
  read_numbers(t, keys, s);
  if (has(keys, "size")) read_size(t, s.size);
  if (has(keys, "axes")) read_lengths(t, "axes", s.axes);
  if (has(keys, "lengths")) read_lengths(t, "lengths", s.lengths);
  if (has(keys, "sides")) t.integer("sides", s.sides);
  if (has(keys, "count")) t.integer("count", s.count);
  if (has(keys, "lattice")) t.word<TableLattice>("lattice", table_lattices, s.lattice);
  if (has(keys, "periodic")) t.flag("periodic", s.periodic);
  t.number("restitution", s.restitution);
  t.text("material", s.material);
  t.finish();
  return s;
}

}  // namespace carom::scene_text
