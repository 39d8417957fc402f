#include "carom/certify/system.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "carom/core/error.hpp"
#include "carom/scene/exact_only.hpp"
#include "carom/scene/growing.hpp"
#include "carom/scene/validate.hpp"
#include "start.hpp"
#include "world/roster.hpp"

namespace carom::certify {

namespace {

Vector exact_vector(const Coordinates& c) {
  Vector v;
  for (std::size_t k = 0; k < c.size() && k < 3; ++k) v[k] = exact(c[k]);
  return v;
}

/// Everything in a scene that no proof is made for.
std::vector<Problem> outside_the_scope(const Scene& scene) {
  std::vector<Problem> problems;
  const auto refuse = [&](const Where& where, const std::string& what, const std::string& hint) {
    problems.push_back({scene.file, where.line, what + ": no proof is made for it",
                        "certify proves impacts with a constant restitution, in free flight or under a uniform acceleration", hint});
  };
  const CollisionSpec& c = scene.collision;
  if (c.law != LawKind::restitution) refuse(c.where, "a law that joins balls", "Use law = \"restitution\"");
  if (c.contact_time != 0) refuse(c.where, "contact_time", "Leave it out");
  if (c.regularise != Regularise::stop) refuse(c.where, "regularise", "Leave it out");
  if (is_magnetic(scene)) refuse(scene.motion.where, "motion.magnetic", "Leave it out");
  for (const WallSpec& w : scene.walls) {
    if (w.oscillation) refuse(w.where, "wall.oscillation", "Leave it out");
    if (w.kind == WallKind::arc || w.kind == WallKind::ellipse || w.kind == WallKind::parabola || w.kind == WallKind::curve)
      refuse(w.where, "a wall that is curved and no circle", "Use circles, segments and polygons");
  }
  if (balls_grow(scene)) refuse({}, "radius_growth", "Leave it out");
  for (const WallSpec& w : scene.walls)
    if (scene.space.kind == SpaceKind::periodic || w.opening)
      refuse(w.where, w.opening ? "an opening" : "a wall in a periodic space", "Use a box, or fixed balls");
  return problems;
}

class Maker {
 public:
  explicit Maker(const Scene& scene) : scene_(scene), roster_(make_roster(scene)) {}

  System operator()() {
    system_.dimension = scene_.dimension;
    system_.start = exact(scene_.run.start);
    system_.acceleration = exact_vector(scene_.motion.acceleration);
    if (roster_.region.kind == SpaceKind::periodic) {
      const Vector lower = corner(scene_.space.lower, roster_.region.lower), upper = corner(scene_.space.upper, roster_.region.upper);
      Vector period;
      for (std::size_t k = 0; k < dimension(); ++k) period[k] = upper[k] - lower[k];
      system_.period = period;
    }
    materials_[""] = 0;
    for (const MaterialSpec& m : scene_.materials) materials_.emplace(m.name, static_cast<std::uint32_t>(materials_.size()));
    add_balls();
    for (const WallSpec& w : scene_.walls) add_wall(w);
    add_faces();
    fill_restitution();
    return std::move(system_);
  }

 private:
  [[nodiscard]] std::size_t dimension() const { return static_cast<std::size_t>(scene_.dimension); }

  /// Of the space as written, else as a gas has set it.
  [[nodiscard]] Vector corner(const Coordinates& written, const std::array<double, 3>& set) const {
    if (scene_.space.kind != SpaceKind::open) return exact_vector(written);
    Vector v;
    for (std::size_t k = 0; k < dimension(); ++k) v[k] = exact(Number(set[k]));
    return v;
  }

  void add_balls() {
    for (const BallSpec& b : scene_.balls) {
      SystemBall ball{exact_vector(b.position), exact_vector(b.velocity), exact(b.radius), {}, b.fixed, materials_.at(b.material)};
      if (!b.fixed && std::isfinite(b.mass.value)) ball.mass = exact(b.mass);
      system_.balls.push_back(ball);
    }
    for (const PlacedGroup& g : roster_.groups)
      for (std::size_t i = 0; i * dimension() < g.balls.position.size(); ++i) {
        SystemBall ball;
        for (std::size_t k = 0; k < dimension(); ++k) {
          ball.position[k] = exact(Number(g.balls.position[i * dimension() + k]));
          if (!g.balls.velocity.empty()) ball.velocity[k] = exact(Number(g.balls.velocity[i * dimension() + k]));
        }
        ball.radius = exact(Number(g.balls.radius));
        if (std::isfinite(g.mass.value)) ball.mass = exact(g.mass);
        ball.material = materials_.at(g.material);
        system_.balls.push_back(ball);
      }
  }

  void add_wall(const WallSpec& spec) {
    Piece piece;
    piece.wall = static_cast<std::uint32_t>(system_.walls.size());
    piece.velocity = exact_vector(spec.velocity);
    if (spec.kind == WallKind::plane) {
      piece.point = exact_vector(spec.point);
      piece.direction = exact_vector(spec.normal);
      system_.pieces.push_back(piece);
    } else if (spec.kind == WallKind::circle) {
      piece.kind = PieceKind::sphere;
      piece.point = exact_vector(spec.centre);
      piece.radius = exact(spec.radius);
      piece.inside = spec.side == WallSide::inside;
      system_.pieces.push_back(piece);
    } else {
      const bool closed = spec.kind == WallKind::polygon;
      add_edges(closed ? spec.vertices : std::vector<Coordinates>{spec.from, spec.to}, closed, piece);
    }
    system_.walls.push_back(std::to_string(system_.walls.size()));
    surfaces_.push_back({spec.material, spec.restitution});
  }

  /// Edges are features from 0 on, then come the vertices.
  void add_edges(const std::vector<Coordinates>& corners, bool closed, Piece piece) {
    const std::size_t n = corners.size(), edges = closed ? n : 1;
    for (std::size_t i = 0; i < edges + n; ++i) {
      const bool edge = i < edges;
      piece.kind = edge ? PieceKind::edge : PieceKind::vertex;
      piece.feature = static_cast<std::int32_t>(i);
      piece.point = exact_vector(corners[edge ? i : i - edges]);
      piece.direction = {};
      if (edge) {
        const Vector to = exact_vector(corners[(i + 1) % n]);
        for (std::size_t k = 0; k < 2; ++k) piece.direction[k] = to[k] - piece.point[k];
      }
      system_.pieces.push_back(piece);
    }
  }

  void add_faces() {
    if (scene_.space.kind != SpaceKind::box) return;
    for (std::size_t k = 0; k < dimension(); ++k)
      for (const int sign : {1, -1}) {
        Piece piece;
        piece.wall = static_cast<std::uint32_t>(system_.walls.size());
        piece.point[k] = exact(sign > 0 ? scene_.space.lower[k] : scene_.space.upper[k]);
        piece.direction[k] = sign;
        system_.pieces.push_back(piece);
        system_.walls.push_back(std::string(1, "xyz"[k]) + (sign > 0 ? "-" : "+"));
        surfaces_.push_back({scene_.space.material, scene_.space.restitution});
      }
  }

  /// material_pair > written at the wall or space > smaller of the two materials > the one there is > [collision].
  [[nodiscard]] Rational restitution_of(const std::string& a, const std::string& b, const std::optional<Number>& written) const {
    for (const MaterialPairSpec& p : scene_.material_pairs)
      if ((p.first == a && p.second == b) || (p.first == b && p.second == a)) return exact(p.restitution);
    if (written) return exact(*written);
    std::optional<Rational> smallest;
    for (const MaterialSpec& m : scene_.materials)
      if (m.name == a || m.name == b) {
        const Rational e = exact(m.restitution);
        if (!smallest || e < *smallest) smallest = e;
      }
    return smallest ? *smallest : exact(scene_.collision.restitution);
  }

  void fill_restitution() {
    system_.restitution.assign(materials_.size(), std::vector<Rational>(materials_.size()));
    system_.at_wall.assign(materials_.size(), std::vector<Rational>(surfaces_.size()));
    for (const auto& [a, row] : materials_) {
      for (const auto& [b, column] : materials_) system_.restitution[row][column] = restitution_of(a, b, std::nullopt);
      for (std::size_t w = 0; w < surfaces_.size(); ++w)
        system_.at_wall[row][w] = restitution_of(a, surfaces_[w].material, surfaces_[w].restitution);
    }
  }

  struct Surface {
    std::string material;
    std::optional<Number> restitution;
  };

  const Scene& scene_;
  Roster roster_;
  System system_;
  std::map<std::string, std::uint32_t> materials_;
  std::vector<Surface> surfaces_;
};

/// Plastic impacts after which the bodies stay in contact: at walls, and between balls on a line.
std::string lasting_contact(const System& system) {
  for (const SystemBall& a : system.balls) {
    if (a.fixed) continue;
    for (std::size_t w = 0; w < system.walls.size(); ++w)
      if (system.at_wall[a.material][w] == 0) return fmt::format("restitution 0 at wall {}", system.walls[w]);
    for (const SystemBall& b : system.balls)
      if (system.dimension == 1 && system.restitution[a.material][b.material] == 0) return "restitution 0 on a line";
  }
  return "";
}

}  // namespace

bool is_zero(const Vector& v) {
  return std::all_of(v.begin(), v.end(), [](const Rational& c) { return c == 0; });
}

bool System::accelerated() const { return !is_zero(acceleration); }

System system_of(const Scene& scene) {
  std::vector<Problem> problems = validate(scene);
  if (problems.empty()) problems = outside_the_scope(scene);
  if (!problems.empty()) throw InputError(problems);
  System system = Maker(scene)();
  const std::string lasting = lasting_contact(system);
  if (!lasting.empty())
    throw InputError(Problem{scene.file, scene.collision.where.line, lasting + ": no proof is made for it",
                             "the bodies stay in contact after an impact", "Take a restitution above 0"});
  const std::string contact = contact_at_the_start(system, scene.balls.size());
  if (!contact.empty())
    throw InputError(Problem{scene.file, 0, contact, "a proof of the order of events begins with all balls apart",
                             "Move one of them by a little"});
  return system;
}

}  // namespace carom::certify
