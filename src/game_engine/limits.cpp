#include "limits.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "adapters.hpp"
#include "registry.hpp"
#include "sphere_mesh.hpp"

namespace carom::game_engine {

namespace {

/// Coordinates, speeds and masses whose squares, inverses and products stay within the range of floats.
constexpr double largest_extent = 0x1p40, largest_speed = 0x1p60, largest_mass = 0x1p60;

bool has(const Layout& layout, PieceKind kind) {
  return std::any_of(layout.pieces.begin(), layout.pieces.end(), [&](const Piece& p) { return p.kind == kind; });
}
bool has(const Layout& layout, BodyKind kind) {
  return std::any_of(layout.bodies.begin(), layout.bodies.end(), [&](const Body& b) { return b.kind == kind; });
}
bool bounces(const Layout& layout) {
  const std::vector<double> all = layout.restitution.values();
  return std::any_of(all.begin(), all.end(), [](double e) { return e > 0; });
}

/// Collects sentences; lengths and speeds are given in the engine's units and written in the user's.
class Sentences {
 public:
  explicit Sentences(const Layout& layout) : layout_(layout) {}

  template <class... Args>
  void say(fmt::format_string<Args...> text, Args&&... args) {
    all.push_back(fmt::format(text, std::forward<Args>(args)...));
  }
  [[nodiscard]] std::string user(double length) const { return fmt::format("{:.4g}", layout_.to_user_length(length)); }

  std::vector<std::string> all{};

 private:
  const Layout& layout_;
};

void sizes(Sentences& s, const Layout& layout, const EngineFacts& facts) {
  if (facts.floats) {
    s.say("{} computes in single precision: at this scene's largest coordinate, {}, positions are {} apart.", facts.title,
          s.user(layout.extent), s.user(layout.extent * 0x1p-23));
    if (layout.smallest_radius < 0.05 || layout.largest_radius > 5)
      s.say("{} is made for radii of 0.05 to 5 m; here they are {:.4g} to {:.4g} m after scaling.", facts.title,
            layout.smallest_radius, layout.largest_radius);
  }
  if (layout.acceleration != Point{})
    s.say("{} integrates the acceleration by semi-implicit Euler steps: v += a dt, then x += v dt.", facts.title);
  if (has(layout, BodyKind::driven))
    s.say("In {} balls of infinite mass are moved on their parabola, and pass through walls and each other.", facts.title);
}

void box2d(Sentences& s, const Layout& layout) {
  if (bounces(layout))
    s.say("Box2D gives restitution 0 to what approaches more slowly than {} (1 m/s), unless `threshold` is set.",
          s.user(1.0));
  s.say("Box2D leaves overlaps of up to {} (0.005 m).", s.user(0.005));
  s.say("Box2D moves no ball by more than {} (2 m) in a step, and slows down for good what is faster{}.", s.user(2.0),
        layout.fastest > 0 ? fmt::format(": the fastest of the start needs a step of at most {:.4g}", 2.0 / layout.fastest)
                           : "");
  if (layout.bodies.size() > 1)
    s.say(
        "Box2D has no continuous detection between two balls, unless `continuous` is set; against walls and fixed balls it "
        "always has.");
  s.say("In Box2D what is slower than {} (0.01 m/s) for 0.5 s falls asleep, unless `awake` is set.", s.user(0.01));
  if (has(layout, PieceKind::segment))
    s.say("In Box2D segments and polygons are thicker by {} (0.01 m) on all sides.", s.user(0.01));
}

void chipmunk(Sentences& s, const Layout& layout) {
  s.say("Chipmunk leaves overlaps of up to {} (0.1).", s.user(0.1));
  s.say("Chipmunk has no continuous detection: what moves by more than its size in a step may pass through.");
  if (has(layout, PieceKind::half_space))
    s.say("In Chipmunk the faces of the box and the planes are {} thick: what gets deeper goes through.",
          s.user(2 * layout.largest_radius));
}

void bullet(Sentences& s, const Layout& layout) {
  if (bounces(layout)) {
    s.say("Bullet gives restitution 0 to what approaches more slowly than {} (0.2 m/s), unless `threshold` is set.",
          s.user(0.2));
    s.say("With `continuous`, Bullet gives restitution 0 to the contacts that it predicts.");
  }
  s.say("Bullet takes back overlaps of up to {} (0.04 m) by adding 0.2 overlap / dt to the speed of the bounce.",
        s.user(0.04));
  if (has(layout, PieceKind::half_space) || has(layout, PieceKind::segment) || has(layout, PieceKind::ring))
    s.say(
        "Bullet acts from a distance of {} (0.02 m) at walls: a ball that a step leaves at a gap g within it loses the "
        "speed g / dt of its bounce.",
        s.user(0.02));
  s.say(
      "Bullet has no continuous detection, unless `continuous` is set; it then sweeps a sphere of 0.4 radii against all "
      "others as if they stood still.");
  s.say("In Bullet what is slower than {} (0.8 m/s) for 2 s falls asleep, even in free flight, unless `awake` is set.",
        s.user(0.8));
}

void shapes(Sentences& s, const Layout& layout, const EngineFacts& facts) {
  for (const Piece& p : layout.pieces) {
    if (p.kind == PieceKind::half_space && layout.dimension == 2 && facts.dimension == 2 && p.endless)
      s.say("Wall {} is a line in {} that ends {} to both sides of its point.", p.wall, facts.title, s.user(p.half_length));
    if (p.kind != PieceKind::ring) continue;
    if (layout.dimension == 3) {
      s.say("Wall {}, a sphere from inside, is {} triangles in {}, up to {} inside of it.", p.wall,
            20 << (2 * bullet_ring_levels), facts.title, s.user(p.radius * sphere_mesh_depth(bullet_ring_levels)));
    } else {
      const double depth = facts.dimension == 3 ? bullet_ring_depth : facts.floats ? box2d_ring_depth : chipmunk_ring_depth;
      const int n = ring_edges(p.radius, depth);
      s.say("Wall {}, a circle from inside, is {} straight edges in {}, up to {} inside of it.", p.wall, n, facts.title,
            s.user(ring_depth(p.radius, n)));
    }
  }
}

}  // namespace

std::vector<std::string> refusals(const Layout& layout, std::size_t number) {
  const EngineFacts& facts = engine_facts(number);
  Sentences s(layout);
  if (layout.dimension > facts.dimension)
    s.say("{} is {}-dimensional, and the scene has {} dimensions.", facts.title, facts.dimension, layout.dimension);
  if (layout.space == SpaceKind::periodic) s.say("{} has no periodic space.", facts.title);
  if (layout.law == LawKind::stick) s.say("{} has no law \"stick\".", facts.title);
  if (layout.law == LawKind::merge) s.say("{} has no law \"merge\".", facts.title);
  for (const std::string& wall : layout.foreign)
    s.say("{} has straight walls and whole circles, and nothing passes them: {}.", facts.title, wall);
  if (!layout.bodies.empty() && layout.smallest_radius == 0) s.say("{} has no balls of radius 0.", facts.title);
  if (layout.extent > largest_extent)
    s.say("Coordinates of {} are too large for {} beside such small balls.", s.user(layout.extent), facts.title);
  if (layout.fastest > largest_speed)
    s.say("Speeds of {} are too large for {} beside such small balls.", s.user(layout.fastest), facts.title);
  for (const Body& b : layout.bodies) {
    if (b.kind != BodyKind::dynamic || (b.mass < largest_mass && b.mass > 1 / largest_mass)) continue;
    s.say("A mass of {:.4g} is too far from the median mass for {}.", std::ldexp(b.mass, -layout.mass), facts.title);
    break;
  }
  return s.all;
}

std::vector<std::string> approximations(const Layout& layout, std::size_t number) {
  const EngineFacts& facts = engine_facts(number);
  Sentences s(layout);
  sizes(s, layout, facts);
  const std::string& name = game_engines()[number].name;
  name == "box2d" ? box2d(s, layout) : name == "chipmunk" ? chipmunk(s, layout) : bullet(s, layout);
  shapes(s, layout, facts);
  return s.all;
}

}  // namespace carom::game_engine
