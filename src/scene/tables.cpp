#include "tables.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "observe_reader.hpp"
#include "ready_tables.hpp"
#include "unbuilt.hpp"

namespace carom::scene_text {

namespace {

// A key of [[wall]] or [[lattice]] that belongs to a kind; one that belongs to several has a row for each.
template <class E>
struct KindKey {
  std::string_view key;
  E kind;
};

// Refuses the keys of other kinds, by the name of the kind that has them.
template <class E, std::size_t N, std::size_t M>
void refuse_other_kinds(TableReader& t, E kind, const std::array<KindKey<E>, N>& keys,
                        const std::array<Word<E>, M>& words) {
  for (const KindKey<E>& k : keys) {
    const auto same = [&k](const KindKey<E>& other) { return other.key == k.key; };
    const bool first = &*std::find_if(keys.begin(), keys.end(), same) == &k;
    const bool fits = std::any_of(keys.begin(), keys.end(), [&](const auto& other) { return same(other) && other.kind == kind; });
    if (!first || fits || !t.has(k.key)) continue;
    const std::string other(word_for<E>(words, k.kind));
    t.misplaced(k.key, "it belongs to kind = \"" + other + "\", not \"" + std::string(word_for<E>(words, kind)) + '"');
  }
}

constexpr std::array wall_keys{
    KindKey<WallKind>{"from", WallKind::segment},  KindKey<WallKind>{"to", WallKind::segment},
    KindKey<WallKind>{"point", WallKind::plane},   KindKey<WallKind>{"normal", WallKind::plane},
    KindKey<WallKind>{"centre", WallKind::circle}, KindKey<WallKind>{"radius", WallKind::circle},
    KindKey<WallKind>{"side", WallKind::circle},   KindKey<WallKind>{"vertices", WallKind::polygon},
    KindKey<WallKind>{"centre", WallKind::arc},    KindKey<WallKind>{"radius", WallKind::arc},
    KindKey<WallKind>{"from_angle", WallKind::arc}, KindKey<WallKind>{"to_angle", WallKind::arc},
    KindKey<WallKind>{"centre", WallKind::ellipse}, KindKey<WallKind>{"axes", WallKind::ellipse},
    KindKey<WallKind>{"angle", WallKind::ellipse}, KindKey<WallKind>{"side", WallKind::ellipse},
    KindKey<WallKind>{"centre", WallKind::parabola}, KindKey<WallKind>{"angle", WallKind::parabola},
    KindKey<WallKind>{"focal_length", WallKind::parabola}, KindKey<WallKind>{"half_width", WallKind::parabola},
    KindKey<WallKind>{"centre", WallKind::curve},  KindKey<WallKind>{"angle", WallKind::curve},
    KindKey<WallKind>{"cosines", WallKind::curve}, KindKey<WallKind>{"sines", WallKind::curve},
    KindKey<WallKind>{"side", WallKind::curve}};

constexpr std::array rack_keys{
    KindKey<LatticeKind>{"rows", LatticeKind::rack}, KindKey<LatticeKind>{"gap", LatticeKind::rack},
    KindKey<LatticeKind>{"apex", LatticeKind::rack}, KindKey<LatticeKind>{"direction", LatticeKind::rack}};

SpaceSpec read_space(TableReader t) {
  SpaceSpec s;
  s.where = t.where();
  if (!t.word<SpaceKind>("kind", space_kinds, s.kind)) t.abandon();
  t.coordinates("lower", s.lower);
  t.coordinates("upper", s.upper);
  t.number("restitution", s.restitution);
  t.text("material", s.material);
  t.finish();
  return s;
}

MotionSpec read_motion(TableReader t) {
  MotionSpec m;
  m.where = t.where();
  t.coordinates("acceleration", m.acceleration);
  t.number("magnetic", m.magnetic);
  t.finish();
  return m;
}

CollisionSpec read_collision(TableReader t) {
  CollisionSpec c;
  c.where = t.where();
  t.word<LawKind>("law", law_kinds, c.law);
  t.number("restitution", c.restitution);
  t.word<Simultaneous>("simultaneous", simultaneous_rules, c.simultaneous);
  t.number("contact_time", c.contact_time);
  t.word<Regularise>("regularise", regularise_kinds, c.regularise);
  t.number("reference_speed", c.reference_speed);
  t.finish();
  return c;
}

std::vector<MaterialSpec> read_materials(TableReader t) {
  std::vector<MaterialSpec> materials;
  for (const auto& [key, node] : t.source()) {
    MaterialSpec m;
    m.name = key.str();
    if (std::optional<TableReader> material = t.table(key.str())) {
      m.where = material->where();
      material->number("restitution", m.restitution);
      material->finish();
    }
    materials.push_back(std::move(m));
  }
  return materials;
}

MaterialPairSpec read_material_pair(TableReader t) {
  MaterialPairSpec p;
  p.where = t.where();
  t.require("restitution", "a pair of materials is there to set it", "Add restitution = 0.9");
  t.number("restitution", p.restitution);
  const toml::node* of = t.take("of");
  const toml::array* names = of == nullptr ? nullptr : of->as_array();
  if (names != nullptr && names->size() == 2 && names->is_homogeneous<std::string>()) {
    p.first = *names->get(0)->value<std::string>();
    p.second = *names->get(1)->value<std::string>();
  } else if (of == nullptr) {
    t.require("of", "a pair has two materials", "Add of = [\"ivory\", \"rubber\"]");
  } else {
    t.refuse("of", " is not a pair", "the names of two materials are needed", "Write of = [\"ivory\", \"rubber\"]");
  }
  t.finish();
  return p;
}

BallSpec read_ball(TableReader t) {
  BallSpec b;
  b.where = t.where();
  t.text("name", b.name);
  t.coordinates("position", b.position);
  t.coordinates("velocity", b.velocity);
  t.number("radius", b.radius);
  t.number("mass", b.mass);
  t.text("material", b.material);
  t.flag("fixed", b.fixed);
  t.number("radius_growth", b.radius_growth);
  t.finish();
  return b;
}

LatticeSpec read_lattice(TableReader t) {
  LatticeSpec l;
  l.where = t.where();
  t.require("kind", "a lattice has a kind", "Add kind = \"hexagonal\"");
  if (!t.has("kind") || !t.word<LatticeKind>("kind", lattice_kinds, l.kind)) {
    t.abandon();
    return l;
  }
  t.integer("count", l.count);
  t.number("packing_fraction", l.packing_fraction);
  t.number("radius", l.radius);
  t.number("mass", l.mass);
  t.text("material", l.material);
  t.number("temperature", l.temperature);
  t.seed("seed", l.seed);
  t.number("radius_growth", l.radius_growth);
  refuse_other_kinds(t, l.kind, rack_keys, lattice_kinds);
  if (l.kind == LatticeKind::rack) {
    t.integer("rows", l.rows);
    t.number("gap", l.gap);
    t.coordinates("apex", l.apex);
    t.coordinates("direction", l.direction);
  }
  t.finish();
  return l;
}

GasSpec read_gas(TableReader t) {
  GasSpec g;
  g.where = t.where();
  t.integer("count", g.count);
  t.number("packing_fraction", g.packing_fraction);
  t.number("radius", g.radius);
  t.number("mass", g.mass);
  if (t.has("speed")) t.misplaced("temperature", "speed says how fast the balls are");
  t.number("temperature", g.temperature);
  t.number("speed", g.speed);
  t.text("material", g.material);
  t.seed("seed", g.seed);
  t.number("radius_growth", g.radius_growth);
  t.finish();
  return g;
}

void read_shape(TableReader& t, WallSpec& w) {
  switch (w.kind) {
    case WallKind::segment:
      t.coordinates("from", w.from);
      t.coordinates("to", w.to);
      break;
    case WallKind::plane:
      t.coordinates("point", w.point);
      t.coordinates("normal", w.normal);
      break;
    case WallKind::circle:
      t.coordinates("centre", w.centre);
      t.require("radius", "a circle has one", "Add radius = 1.0");
      t.number("radius", w.radius);
      t.word<WallSide>("side", wall_sides, w.side);
      break;
    case WallKind::polygon:
      t.vertices("vertices", w.vertices);
      break;
    case WallKind::arc:
      t.coordinates("centre", w.centre);
      t.require("radius", "an arc has one", "Add radius = 1.0");
      t.number("radius", w.radius);
      t.require("from_angle", "an arc begins at one", "Add from_angle = 0.0, in radians");
      t.require("to_angle", "an arc ends at one", "Add to_angle = 1.0, in radians, anticlockwise from from_angle");
      t.number("from_angle", w.from_angle);
      t.number("to_angle", w.to_angle);
      break;
    case WallKind::ellipse:
      t.coordinates("centre", w.centre);
      t.coordinates("axes", w.axes);
      t.number("angle", w.angle);
      t.word<WallSide>("side", wall_sides, w.side);
      break;
    case WallKind::parabola:
      t.coordinates("centre", w.centre);
      t.number("angle", w.angle);
      t.require("focal_length", "a parabola has one", "Add focal_length = 1.0");
      t.number("focal_length", w.focal_length);
      t.require("half_width", "a parabola ends somewhere", "Add half_width = 1.0");
      t.number("half_width", w.half_width);
      break;
    case WallKind::curve:
      t.coordinates("centre", w.centre);
      t.number("angle", w.angle);
      t.coordinates("cosines", w.cosines);
      t.coordinates("sines", w.sines);
      t.word<WallSide>("side", wall_sides, w.side);
      break;
  }
}

OscillationSpec read_oscillation(TableReader t) {
  OscillationSpec o;
  t.require("amplitude", "a wall swings along a vector", "Add amplitude = [0, 0.1]");
  t.coordinates("amplitude", o.amplitude);
  t.number("omega", o.omega);
  t.number("phase", o.phase);
  t.finish();
  return o;
}

WallSpec read_wall(TableReader t) {
  WallSpec w;
  w.where = t.where();
  t.require("kind", "a wall has a kind", "Add kind = \"plane\"");
  if (!t.has("kind") || !t.word<WallKind>("kind", wall_kinds, w.kind)) {
    t.abandon();
    return w;
  }
  read_shape(t, w);
  refuse_other_kinds(t, w.kind, wall_keys, wall_kinds);
  t.flag("opening", w.opening);
  t.coordinates("velocity", w.velocity);
  if (std::optional<TableReader> swing = t.table("oscillation")) w.oscillation = read_oscillation(std::move(*swing));
  t.number("restitution", w.restitution);
  t.text("material", w.material);
  t.finish();
  return w;
}

RunSpec read_run(TableReader t) {
  RunSpec r;
  r.where = t.where();
  t.number("start", r.start);
  t.number("until", r.until);
  t.integer("events", r.events);
  t.number("until_packing", r.until_packing);
  t.number("until_reduced_pressure", r.until_reduced_pressure);
  t.integer("rescale_every", r.rescale_every);
  t.number("sample_every", r.sample_every);
  t.seed("seed", r.seed);
  t.finish();
  return r;
}

EngineSpec read_engine(TableReader t) {
  EngineSpec e;
  e.where = t.where();
  t.word<SearchKind>("search", search_kinds, e.search);
  t.word<QueueKind>("queue", queue_kinds, e.queue);
  t.flag("vectors", e.vectors);
  t.finish();
  return e;
}

OutputSpec read_output(TableReader t) {
  OutputSpec o;
  o.where = t.where();
  t.text("events", o.events);
  t.text("trajectory", o.trajectory);
  t.text("ledger", o.ledger);
  t.word<FramesAt>("trajectory_frames", frame_kinds, o.trajectory_frames);
  if (std::optional<TableReader> checkpoint = t.table("checkpoint")) {
    o.checkpoint = "checkpoint.carom";
    checkpoint->text("file", o.checkpoint);
    if (std::optional<TableReader> every = checkpoint->table("every")) {
      every->number("time", o.checkpoint_every_time);
      every->integer("events", o.checkpoint_every_events);
      every->finish();
    }
    checkpoint->finish();
  }
  t.finish();
  return o;
}

// One table, or its defaults where it is not there.
template <class Spec>
void read_one(TableReader& root, std::string_view key, Spec (*read)(TableReader), Spec& to) {
  if (std::optional<TableReader> t = root.table(key)) to = read(std::move(*t));
}

// All of [[key]]; a placeholder for what is no table, so that numbers stay those of the file.
template <class Spec>
void read_each(TableReader& root, std::string_view key, Spec (*read)(TableReader), std::vector<Spec>& to) {
  root.tables(key, [&](std::optional<TableReader> t) { to.push_back(t ? read(std::move(*t)) : Spec()); });
}

}  // namespace

Scene read_tables(const toml::table& table, Report& report) {
  Scene s;
  TableReader root(report, table, {});
  root.text("title", s.title);
  root.integer("dimension", s.dimension);
  read_one(root, "space", read_space, s.space);
  read_one(root, "motion", read_motion, s.motion);
  read_one(root, "collision", read_collision, s.collision);
  read_one(root, "material", read_materials, s.materials);
  read_each(root, "material_pair", read_material_pair, s.material_pairs);
  read_each(root, "ball", read_ball, s.balls);
  read_each(root, "lattice", read_lattice, s.lattices);
  read_each(root, "gas", read_gas, s.gases);
  read_each(root, "wall", read_wall, s.walls);
  read_each(root, "table", read_ready_table, s.tables);
  if (std::optional<TableReader> t = root.table("ensemble")) s.ensemble = read_ensemble(std::move(*t));
  read_one(root, "run", read_run, s.run);
  read_one(root, "engine", read_engine, s.engine);
  read_one(root, "observe", read_observe, s.observe);
  read_one(root, "output", read_output, s.output);
  root.finish();
  return s;
}

}  // namespace carom::scene_text
