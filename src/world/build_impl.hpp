#pragma once
// The making of a World, in the arithmetic of Real.

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "carom/core/check.hpp"
#include "carom/core/error.hpp"
#include "carom/law/viscoelastic.hpp"
#include "carom/scene/tables.hpp"
#include "carom/scene/validate.hpp"
#include "carom/world/build.hpp"
#include "carom/world/flat_walls.hpp"
#include "carom/world/gases.hpp"
#include "choose_units.hpp"
#include "curved_walls.hpp"
#include "near_joints.hpp"
#include "growth_plan.hpp"
#include "outline.hpp"
#include "real_number.hpp"
#include "roster.hpp"
#include "start_contacts.hpp"

namespace carom {

template <class Real>
Time<Real> clock_time(const Number& t, int exponent) {
  namespace mp = boost::multiprecision;
  const int bits = significand_bits<Real>();
  Rational q = exact(t);
  q = exponent > 0 ? Rational(q / Rational(mp::cpp_int(1) << exponent))
                   : Rational(q * Rational(mp::cpp_int(1) << -exponent));
  mp::cpp_int epoch = numerator(q) / denominator(q);
  if (Rational(epoch) > q) --epoch;  // truncation towards zero of a negative time
  if (mp::abs(epoch) > mp::cpp_int(last_epoch)) return Time<Real>::never();
  const Rational ticks = (q - Rational(epoch)) * Rational(mp::cpp_int(1) << bits);
  mp::cpp_int k = numerator(ticks) / denominator(ticks);
  const Rational rest = (ticks - Rational(k)) * 2;
  if (rest > 1 || (rest == 1 && (k & 1) != 0)) ++k;
  if (k == mp::cpp_int(1) << bits) {
    k = 0;
    ++epoch;
  }
  using std::ldexp;
  Time<Real> time;
  time.epoch = epoch.template convert_to<std::int64_t>();
  time.offset = ldexp(Real(k), -bits);
  return time;
}

namespace detail {

template <class Real, int D>
class WorldBuilder {
 public:
  explicit WorldBuilder(const Scene& scene) : scene_(scene) {}

  World<Real, D> build() {
    build_all_but_gases();
    for (PlacedGroup& g : roster_.groups) add_group(g);
    order_on_line();
    return std::move(world_);
  }

  WorldAndGases<D> build_apart() requires(std::is_same_v<Real, double>) {
    build_all_but_gases();
    WorldAndGases<D> parts;
    for (PlacedGroup& g : roster_.groups) parts.gases.push_back(apart(g));
    order_on_line();
    parts.world = std::move(world_);
    return parts;
  }

 private:
  using Vector = Vec<Real, D>;

  /// Gases are left in the roster: their balls are placed clear of everything. On a line points may meet, so there they are
  /// judged like all others.
  void build_all_but_gases() {
    CAROM_EXPECT(scene_.dimension == D);
    CAROM_EXPECT(!has_tables_out(scene_));
    problems_ = validate(scene_);
    throw_problems();
    roster_ = make_roster(scene_);
    world_.units = choose_units(scene_, roster_, problems_);
    throw_problems();
    world_.start = clock_time<Real>(scene_.run.start, world_.units.time);
    judge_clock();
    world_.law = scene_.collision.law;
    world_.simultaneous = scene_.collision.simultaneous;
    world_.regularise = scene_.collision.regularise;
    world_.contact_time = real_number<Real>(scene_.collision.contact_time, -world_.units.time);
    fill_motion();
    number_materials();
    fill_space();
    fill_walls();
    if constexpr (D == 2)
      for (Problem& p : near_joints(scene_, world_)) problems_.push_back(std::move(p));
    fill_growth();
    fill_balls();
    judge_places();
    fill_restitution();
    judge_rest();
    find_start_contacts(scene_, world_, bits_, lines_, problems_);
    throw_problems();
  }

  void throw_problems() const {
    if (!problems_.empty()) throw InputError(problems_);
  }

  Real length(const Number& n) const { return real_number<Real>(n, -world_.units.length); }
  Vector point(const Coordinates& c) const {
    Vector x;
    for (int k = 0; k < D; ++k) x[k] = length(c[k]);
    return x;
  }
  Vector velocity(const Coordinates& c) const {
    Vector v = Vector::Zero();
    for (int k = 0; k < D && !c.empty(); ++k) v[k] = real_number<Real>(c[k], -world_.units.velocity());
    return v;
  }

  void judge_clock() {
    const auto beyond = [&](const Number& t, const char* key) {
      if (clock_time<Real>(t, world_.units.time).is_never())
        problems_.push_back({scene_.file, scene_.run.where.line, fmt::format("{} = {} lies beyond the clock", key, t.value),
                             fmt::format("this scene's clock counts 2^62 epochs of 2^{}", world_.units.time),
                             "Give an earlier time, or slower balls"});
    };
    beyond(scene_.run.start, "start");
    if (scene_.run.until) beyond(*scene_.run.until, "until");
  }

  void fill_motion() {
    for (int k = 0; k < D && !scene_.motion.acceleration.empty(); ++k)
      world_.acceleration[k] = real_number<Real>(scene_.motion.acceleration[k], -world_.units.acceleration());
    if (scene_.motion.magnetic) world_.magnetic = real_number<Real>(*scene_.motion.magnetic, world_.units.time);
  }

  /// Of all balls, those of the gases too.
  void fill_growth() {
    GrowthPlan<Real, D> plan(scene_, world_);
    for (const BallSpec& b : scene_.balls)
      plan.add(1, length(b.radius), rate(b.radius_growth), !b.fixed && velocity(b.velocity) != Vector(Vector::Zero()));
    for (const PlacedGroup& g : roster_.groups) {
      const bool moves = std::any_of(g.balls.velocity.begin(), g.balls.velocity.end(), [](double v) { return v != 0; });
      plan.add(g.balls.position.size() / D, length(Number(g.balls.radius)), rate(g.radius_growth), moves);
    }
    world_.growth = plan.finished(problems_);
  }
  Real rate(const Number& growth) const { return real_number<Real>(growth, -world_.units.velocity()); }

  void judge_rest() {
    const std::size_t count = flat_count(world_.walls);
    if (world_.regularise == Regularise::rest && count > most_flat_walls)
      problems_.push_back({scene_.file, scene_.collision.where.line,
                           fmt::format("regularise = \"rest\" with {} flat walls", count),
                           fmt::format("faces, planes, segments and edges of polygons may be {} in all", most_flat_walls),
                           "Use fewer, or collision.contact_time"});
  }

  void number_materials() {
    materials_[""] = 0;
    for (const MaterialSpec& m : scene_.materials)
      materials_.emplace(m.name, static_cast<std::uint32_t>(materials_.size()));
  }

  void fill_space() {
    Space<Real, D>& space = world_.space;
    space.kind = roster_.region.kind;
    if (space.kind == SpaceKind::open) return;
    const bool given = scene_.space.kind != SpaceKind::open;
    for (int k = 0; k < D; ++k) {
      const Number lower = given ? scene_.space.lower[k] : Number(roster_.region.lower[k]);
      const Number upper = given ? scene_.space.upper[k] : Number(roster_.region.upper[k]);
      space.lower[k] = length(lower);
      space.edge[k] = length(upper) - space.lower[k];
      upper_[k] = length(upper);
    }
  }

  void fill_walls() {
    Walls<Real, D>& walls = world_.walls;
    for (const WallSpec& spec : scene_.walls) {
      if (!judge_wall(spec)) continue;
      if (spec.opening) walls.openings.resize(walls.labels.size() + 1);
      if (spec.opening) walls.openings.back() = true;
      const WallId id = wall_id(walls.labels.size());
      walls.labels.push_back(std::to_string(walls.labels.size()));
      surfaces_.push_back({spec.material, spec.restitution});
      add_wall(spec, id);
    }
    if constexpr (D == 2) Joints<Real>(walls).join();
    if (world_.space.kind == SpaceKind::box) add_faces(walls);
    if (!walls.openings.empty()) walls.openings.resize(walls.labels.size());
  }

  void add_faces(Walls<Real, D>& walls) {
    for (int k = 0; k < D; ++k)
      for (const int sign : {+1, -1}) {
        Face<Real, D> face;
        face.wall = wall_id(walls.labels.size());
        face.axis = k;
        face.sign = sign;
        face.coordinate = sign > 0 ? world_.space.lower[k] : upper_[k];
        if constexpr (D == 2) face.begin = (k == 1) == (sign > 0) ? world_.space.lower[1 - k] : upper_[1 - k];
        walls.faces.push_back(face);
        walls.labels.push_back(std::string(1, "xyz"[k]) + (sign > 0 ? "-" : "+"));
        surfaces_.push_back({scene_.space.material, scene_.space.restitution});
      }
  }

  /// What a wall cannot be together with the space and the law.
  [[nodiscard]] bool judge_wall(const WallSpec& spec) {
    const auto refuse = [&](const char* what, const char* why, const char* hint) {
      problems_.push_back({scene_.file, spec.where.line, what, why, hint});
      return false;
    };
    if (spec.opening && world_.law != LawKind::restitution)
      return refuse("an opening where balls stick or merge", "a ball leaves alone", "Use law = \"restitution\"");
    if (!world_.space.periodic()) return true;
    if (spec.kind == WallKind::plane)
      return refuse("a plane in a periodic space", "behind it all other periods would lie", "Use a segment from edge to edge, or a box");
    const bool closed = spec.kind == WallKind::circle || spec.kind == WallKind::ellipse || spec.kind == WallKind::curve;
    if (closed && spec.side == WallSide::inside)
      return refuse("a wall with the balls inside in a periodic space", "they never leave it, so nothing repeats",
                    "Set side = \"outside\", or leave out [space]");
    if (std::any_of(spec.velocity.begin(), spec.velocity.end(), [](const Number& v) { return v.value != 0; }))
      return refuse("a wall that moves in a periodic space", "it would leave its cell", "Let it stand still, or use a box");
    if (spec.oscillation)
      return refuse("a wall that swings in a periodic space", "it would leave its cell", "Let it stand still, or use a box");
    if (world_.law != LawKind::restitution || world_.regularise == Regularise::rest)
      return refuse("a wall in a periodic space where balls stick, merge or come to rest", "not built yet",
                    "Use law = \"restitution\" without rest, or a box");
    return true;
  }

  /// The row of the swing of a wall, or -1.
  std::int32_t swing_of_wall(const WallSpec& spec) {
    if (!spec.oscillation || is_still(spec.oscillation->amplitude)) return -1;
    Swing<Real, D> swing;
    swing.amplitude = point(spec.oscillation->amplitude);
    swing.omega = real_number<Real>(spec.oscillation->omega, world_.units.time);
    swing.phase = real_number<Real>(spec.oscillation->phase, 0);
    world_.walls.swings.push_back(swing);
    return static_cast<std::int32_t>(world_.walls.swings.size()) - 1;
  }
  [[nodiscard]] static bool is_still(const Coordinates& v) {
    return std::all_of(v.begin(), v.end(), [](const Number& c) { return c.value == 0; });
  }

  void add_wall(const WallSpec& spec, WallId id) {
    using std::sqrt;
    const std::int32_t swing = swing_of_wall(spec);
    if (spec.kind == WallKind::plane) {
      Plane<Real, D> plane;
      plane.wall = id;
      plane.point = point(spec.point);
      plane.velocity = velocity(spec.velocity);
      plane.swing = swing;
      Vector n;
      for (int k = 0; k < D; ++k) n[k] = real_number<Real>(spec.normal[k], 0);
      // Scaled by a power of two first: any normal that is not zero will do.
      Real largest(0);
      for (int k = 0; k < D; ++k) largest = std::max<Real>(largest, n[k] < 0 ? Real(-n[k]) : n[k]);
      using std::frexp;
      using std::ldexp;
      int exponent = 0;
      (void)frexp(largest, &exponent);
      for (int k = 0; k < D; ++k) n[k] = ldexp(n[k], -exponent);
      plane.direction = n / Real(sqrt(dot<Real, D>(n, n)));
      world_.walls.planes.push_back(plane);
    } else if (spec.kind == WallKind::circle) {
      Sphere<Real, D> sphere;
      sphere.wall = id;
      sphere.centre = point(spec.centre);
      sphere.velocity = velocity(spec.velocity);
      sphere.swing = swing;
      sphere.radius = length(spec.radius);
      sphere.inside = spec.side == WallSide::inside;
      world_.walls.spheres.push_back(sphere);
    } else if (is_curved_kind(spec.kind)) {
      if constexpr (D == 2) add_curved_wall(spec, id);
    } else if constexpr (D == 2) {
      const std::vector<Coordinates> corners =
          spec.kind == WallKind::polygon ? spec.vertices : std::vector<Coordinates>{spec.from, spec.to};
      const std::size_t n = corners.size(), edges = spec.kind == WallKind::polygon ? n : 1;
      for (std::size_t e = 0; e < edges; ++e)
        world_.walls.segments.push_back(segment(spec, id, static_cast<std::int32_t>(e), corners[e], corners[(e + 1) % n]));
      for (std::size_t c = 0; c < n; ++c)
        world_.walls.spheres.push_back(vertex(spec, id, static_cast<std::int32_t>(edges + c), point(corners[c])));
      for (std::size_t e = 0; e < edges; ++e) world_.walls.segments[world_.walls.segments.size() - 1 - e].swing = swing;
      for (std::size_t c = 0; c < n; ++c) world_.walls.spheres[world_.walls.spheres.size() - 1 - c].swing = swing;
    }
  }

  [[nodiscard]] static bool is_curved_kind(WallKind kind) {
    return kind == WallKind::arc || kind == WallKind::ellipse || kind == WallKind::parabola || kind == WallKind::curve;
  }
  void add_curved_wall(const WallSpec& spec, WallId id) requires(D == 2) {
    const auto to_length = [this](const Number& n) { return length(n); };
    const auto add = [&](auto& list, auto shape) {
      shape.wall = id;
      shape.velocity = velocity(spec.velocity);
      list.push_back(std::move(shape));
    };
    Walls<Real, 2>& walls = world_.walls;
    if (spec.kind == WallKind::ellipse) return add(walls.ellipses, make_ellipse<Real>(spec, to_length));
    if (spec.kind == WallKind::parabola) return add(walls.parabolas, make_parabola<Real>(spec, to_length));
    if (spec.kind == WallKind::curve) return add(walls.curves, make_polar_curve<Real>(spec, to_length));
    add(walls.arcs, make_arc<Real>(spec, to_length));
    const Arc<Real>& arc = walls.arcs.back();
    if (arc.whole) return;
    walls.spheres.push_back(vertex(spec, id, 1, arc.from));
    walls.spheres.push_back(vertex(spec, id, 2, arc.to));
  }

  Segment<Real> segment(const WallSpec& spec, WallId id, std::int32_t feature, const Coordinates& from,
                        const Coordinates& to) const requires(D == 2) {
    using std::sqrt;
    Segment<Real> s;
    s.wall = id;
    s.feature = feature;
    s.from = point(from);
    s.to = point(to);
    s.velocity = velocity(spec.velocity);
    const Vector edge = s.to - s.from;
    s.along = edge / Real(sqrt(dot<Real, D>(edge, edge)));
    s.direction = Vector(-s.along[1], s.along[0]);
    return s;
  }
  /// A vertex is a point that balls may hit: a sphere of radius 0.
  Sphere<Real, D> vertex(const WallSpec& spec, WallId id, std::int32_t feature, const Vector& at) const {
    Sphere<Real, D> s;
    s.wall = id;
    s.feature = feature;
    s.centre = at;
    s.velocity = velocity(spec.velocity);
    s.inside = false;
    return s;
  }

  /// A ball of a scene with closed tables starts in one of them.
  void judge_places() {
    const std::vector<Outline> tables = outlines(scene_);
    if (tables.empty()) return;
    for (const BallSpec& b : scene_.balls) {
      const double x[2] = {b.position[0], b.position[1]};
      if (b.fixed || std::any_of(tables.begin(), tables.end(), [&](const Outline& t) { return t.inside_or_on(x); }))
        continue;
      problems_.push_back({scene_.file, b.where.line,
                           fmt::format("a ball starts at [{}, {}], outside of {}", x[0], x[1],
                                       tables.size() == 1 ? "the table" : "all tables"),
                           fmt::format("the table lies between [{:.6g}, {:.6g}] and [{:.6g}, {:.6g}]", tables[0].lower()[0],
                                       tables[0].lower()[1], tables[0].upper()[0], tables[0].upper()[1]),
                           "Move the ball into it"});
    }
  }

  /// Appends a ball; `rounded`: its numbers are doubles, whatever the arithmetic.
  void add_ball(const Vector& x, const Vector& v, const Real& radius, const Number& mass, bool fixed,
                const std::string& material, std::string name, int line, bool rounded) {
    Ball<Real, D>& ball = world_.balls.emplace_back();
    ball.position = x;
    ball.velocity = v;
    ball.radius = radius;
    ball.fixed = fixed;
    ball.time = world_.start;
    BallDetail<Real, D>& detail = world_.details.emplace_back();
    detail.image = wrap(world_.space, ball.position);
    detail.mass = fixed ? infinity<Real>() : real_number<Real>(mass, -world_.units.mass);
    detail.material = materials_.at(material);
    detail.name = std::move(name);
    bits_.push_back(input_bits<Real>(rounded));
    lines_.push_back(line);
  }

  void fill_balls() {
    for (const BallSpec& b : scene_.balls)
      add_ball(point(b.position), velocity(b.velocity), length(b.radius), b.mass, b.fixed, b.material, b.name, b.where.line,
               scene_.rounded);
    const std::size_t judged = D == 1 ? roster_.groups.size() : scene_.lattices.size();
    for (std::size_t g = 0; g < judged; ++g) add_group(roster_.groups[g]);
    roster_.groups.erase(roster_.groups.begin(), roster_.groups.begin() + static_cast<std::ptrdiff_t>(judged));
  }

  /// Its memory is given back.
  void add_group(PlacedGroup& group) {
    const PlacedBalls balls = std::move(group.balls);
    const Real radius = length(Number(balls.radius));
    world_.balls.reserve(world_.balls.size() + balls.position.size() / D);
    world_.details.reserve(world_.balls.size() + balls.position.size() / D);
    for (std::size_t i = 0; i * D < balls.position.size(); ++i) {
      Vector x, v = Vector::Zero();
      for (int k = 0; k < D; ++k) {
        x[k] = length(Number(balls.position[i * D + k]));
        if (!balls.velocity.empty()) v[k] = real_number<Real>(Number(balls.velocity[i * D + k]), -world_.units.velocity());
      }
      add_ball(x, v, radius, group.mass, false, group.material, "", group.line, true);
    }
  }

  GasBalls apart(PlacedGroup& group) const requires(std::is_same_v<Real, double>) {
    GasBalls gas{length(Number(group.balls.radius)), real_number<Real>(group.mass, -world_.units.mass),
                 materials_.at(group.material), std::move(group.balls.position), std::move(group.balls.velocity)};
    for (std::size_t i = 0; i < gas.position.size(); i += D) {
      Vector x;
      for (int k = 0; k < D; ++k) x[k] = std::ldexp(gas.position[i + k], -world_.units.length);
      wrap(world_.space, x);
      for (int k = 0; k < D; ++k) gas.position[i + k] = x[k];
    }
    for (double& v : gas.velocity) v = std::ldexp(v, -world_.units.velocity());
    return gas;
  }

  /// material_pair > restitution written at the wall or space > smaller of the two materials > the one there is >
  /// [collision].
  Real restitution_of(const std::string& a, const std::string& b, const std::optional<Number>& written) const {
    for (const MaterialPairSpec& p : scene_.material_pairs)
      if ((p.first == a && p.second == b) || (p.first == b && p.second == a)) return real_number<Real>(p.restitution, 0);
    if (written) return real_number<Real>(*written, 0);
    const Number* smallest = nullptr;
    for (const MaterialSpec& m : scene_.materials)
      if ((m.name == a || m.name == b) && (smallest == nullptr || m.restitution.value < smallest->value))
        smallest = &m.restitution;
    return real_number<Real>(smallest != nullptr ? *smallest : scene_.collision.restitution, 0);
  }

  void fill_restitution() {
    world_.restitution = RestitutionTable<Real>(materials_.size(), surfaces_.size());
    for (const auto& [a, row] : materials_) {
      for (const auto& [b, column] : materials_)
        world_.restitution.set_between(row, column, restitution_of(a, b, std::nullopt));
      for (std::size_t w = 0; w < surfaces_.size(); ++w)
        world_.restitution.set_at_wall(row, static_cast<std::uint32_t>(w),
                                       restitution_of(a, surfaces_[w].material, surfaces_[w].restitution));
    }
    if (world_.regularise != Regularise::viscoelastic) return;
    world_.viscoelastic = world_.restitution.mapped([](const Real& e) { return viscoelastic_argument(e); });
    world_.reference_speed = real_number<Real>(*scene_.collision.reference_speed, -world_.units.velocity());
  }

  void order_on_line() {
    if constexpr (D == 1) {
      std::vector<std::uint32_t> order(world_.balls.size());
      std::iota(order.begin(), order.end(), 0u);
      std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return world_.balls[a].position[0] < world_.balls[b].position[0];
      });
      // Counted on through the periods of balls that start outside the cell.
      for (std::size_t k = 0; k < order.size(); ++k) {
        BallDetail<Real, D>& detail = world_.details[order[k]];
        detail.rank = static_cast<std::int64_t>(k) + detail.image[0] * static_cast<std::int64_t>(order.size());
      }
    }
  }

  struct Surface {
    std::string material;
    std::optional<Number> restitution;
  };

  const Scene& scene_;
  Roster roster_;
  World<Real, D> world_;
  Vector upper_ = Vector::Zero();
  std::map<std::string, std::uint32_t> materials_;
  std::vector<Surface> surfaces_;
  std::vector<int> bits_, lines_;
  std::vector<Problem> problems_;
};

}  // namespace detail


template <int D>
WorldAndGases<D> build_apart(const Scene& scene) {
  return detail::WorldBuilder<double, D>(scene).build_apart();
}

template <int D>
World<double, D> join(WorldAndGases<D> parts) {
  World<double, D>& world = parts.world;
  const std::size_t size = parts.size();
  std::vector<std::size_t> ends;  // of each gas, in numbers of balls
  world.balls.reserve(size);
  for (GasBalls& gas : parts.gases) {
    for (std::size_t i = 0; i < gas.position.size(); i += D) {
      Ball<double, D>& ball = world.balls.emplace_back();
      ball.position = Vec<double, D>(gas.position.data() + i);
      ball.velocity = Vec<double, D>(gas.velocity.data() + i);
      ball.radius = gas.radius;
      ball.time = world.start;
    }
    ends.push_back(world.balls.size());
    give_back(gas.position);
    give_back(gas.velocity);
  }
  // Only now, when the arrays are gone: details are the larger part of a ball.
  world.details.reserve(size);
  for (std::size_t g = 0; g < ends.size(); ++g)
    while (world.details.size() < ends[g]) {
      BallDetail<double, D>& detail = world.details.emplace_back();
      detail.mass = parts.gases[g].mass;
      detail.material = parts.gases[g].material;
    }
  return std::move(world);
}

template <class Real, int D>
World<Real, D> build(const Scene& scene) {
  if constexpr (std::is_same_v<Real, double>) {
    return join<D>(build_apart<D>(scene));
  } else {
    return detail::WorldBuilder<Real, D>(scene).build();
  }
}

}  // namespace carom
