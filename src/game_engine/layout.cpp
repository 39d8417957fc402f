#include "layout.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "carom/world/build.hpp"

namespace carom::game_engine {

double dot(const Point& u, const Point& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
double norm(const Point& u) { return std::sqrt(dot(u, u)); }
Point along(const Point& x, double s, const Point& u) { return {x[0] + s * u[0], x[1] + s * u[1], x[2] + s * u[2]}; }

std::int32_t nearest_feature(const Piece& piece, const Point& x, const Point& drift) {
  if (piece.kind != PieceKind::segment) return piece.feature;
  const Point edge = along(piece.to, -1.0, piece.point), r = along(along(x, -1.0, piece.point), -1.0, drift);
  const double place = dot(edge, r);
  return place < 0 ? piece.point_feature : place > dot(edge, edge) ? piece.to_feature : piece.feature;
}

double Layout::restitution_of(const Party& a, const Party& b) const {
  if (a.piece != nullptr) return restitution_of(b, a);
  const std::uint32_t material = bodies[a.ball].material;
  return b.piece != nullptr ? restitution.at_wall(material, b.piece->wall)
                            : restitution.between(material, bodies[b.ball].material);
}
double Layout::to_user_length(double x) const { return std::ldexp(x, -length); }
double Layout::to_user_momentum(double p) const { return std::ldexp(p, -(length + mass)); }

int ring_edges(double radius, double depth) {
  if (depth >= radius) return 64;
  const double edges = std::ceil(std::numbers::pi / std::acos(1 - depth / radius));
  return static_cast<int>(std::clamp(edges, 64.0, 4096.0));
}
double ring_depth(double radius, int edges) {
  const double s = std::sin(std::numbers::pi / (2 * edges));
  return 2 * radius * s * s;  // 1 - cos a = 2 sin^2(a/2)
}

namespace {

/// Exponent of two of the median of positive numbers, x 2^-exponent in [1/2, 1); 0 if there are none.
int median_exponent(std::vector<double> values) {
  std::erase_if(values, [](double x) { return !(x > 0) || std::isinf(x); });
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  int exponent = 0;
  (void)std::frexp(*middle, &exponent);
  return exponent;
}

/// Copies a world into a layout; all its factors are powers of two.
template <int D>
class LayoutMaker {
 public:
  LayoutMaker(const Scene& scene, const World<double, D>& world, int size) : world_(world) {
    layout_.dimension = D;
    layout_.space = world.space.kind;
    layout_.law = world.law;
    layout_.start = scene.run.start.value;
    layout_.restitution = world.restitution;
    std::vector<double> radii, masses;
    for (std::size_t i = 0; i < world.balls.size(); ++i) {
      radii.push_back(world.balls[i].radius);
      masses.push_back(world.details[i].mass);
    }
    layout_.length = size - (median_exponent(radii) + world.units.length);
    layout_.mass = -(median_exponent(masses) + world.units.mass);
  }

  Layout make() {
    layout_.acceleration = point(world_.acceleration, world_.units.acceleration());
    for (std::size_t i = 0; i < world_.balls.size(); ++i) add_body(i);
    for (const auto& f : world_.walls.faces) add_face(f);
    for (const auto& p : world_.walls.planes) add_plane(p);
    if constexpr (D == 2) {
      add_segments();
      for (const auto& s : world_.walls.arcs) add_foreign(s, "an arc");
      for (const auto& s : world_.walls.ellipses) add_foreign(s, "an ellipse");
      for (const auto& s : world_.walls.parabolas) add_foreign(s, "a parabola");
      for (const auto& s : world_.walls.curves) add_foreign(s, "a curve r(theta)");
    }
    world_.walls.for_each([&](const auto& s) {
      if (world_.walls.opens(index(s.wall)) && s.feature == 0) add_foreign(s, "an opening");
    });
    if constexpr (D > 1)
      for (const auto& s : world_.walls.spheres)
        if (s.radius > 0) add_sphere(s);  // radius 0: an end of a segment
    finish();
    return std::move(layout_);
  }

 private:
  using Vector = Vec<double, D>;

  double length(double x) const { return std::ldexp(x, world_.units.length + layout_.length); }
  Point point(const Vector& x, int unit) const {
    Point p{};
    for (int k = 0; k < D; ++k) p[static_cast<std::size_t>(k)] = std::ldexp(x[k], unit + layout_.length);
    return p;
  }
  Point place(const Vector& x) const { return point(x, world_.units.length); }
  Point speed(const Vector& v) const { return point(v, world_.units.velocity()); }

  void add_body(std::size_t i) {
    const Ball<double, D>& ball = world_.balls[i];
    const BallDetail<double, D>& detail = world_.details[i];
    Body body;
    body.name = detail.name;
    body.kind = ball.fixed ? BodyKind::fixed : std::isinf(detail.mass) ? BodyKind::driven : BodyKind::dynamic;
    body.position = place(ball.position);
    body.velocity = speed(ball.velocity);
    body.radius = length(ball.radius);
    body.mass = std::ldexp(detail.mass, world_.units.mass + layout_.mass);
    body.material = detail.material;
    layout_.bodies.push_back(body);
  }

  template <class Shape>
  Piece piece(PieceKind kind, const Shape& shape) const {
    Piece p;
    p.kind = kind;
    p.wall = index(shape.wall);
    p.feature = shape.feature;
    return p;
  }

  /// Its point is the middle of the face.
  void add_face(const Face<double, D>& face) {
    Vector middle = world_.space.lower + world_.space.edge / 2;
    middle[face.axis] = face.coordinate;
    Piece p = piece(PieceKind::half_space, face);
    p.point = place(middle);
    p.normal[static_cast<std::size_t>(face.axis)] = face.sign;
    for (int k = 0; k < D; ++k)
      if (k != face.axis) p.half_length = length(world_.space.edge[k] / 2);
    layout_.pieces.push_back(p);
  }
  void add_plane(const Plane<double, D>& plane) {
    Piece p = piece(PieceKind::half_space, plane);
    p.point = place(plane.point);
    p.velocity = speed(plane.velocity);
    for (int k = 0; k < D; ++k) p.normal[static_cast<std::size_t>(k)] = plane.direction[k];
    p.endless = true;
    layout_.pieces.push_back(p);
  }
  /// The ends of edge e of a wall of n edges are its features n + e and n + e + 1, the last being n again in a closed one.
  void add_segments() requires(D == 2) {
    std::map<std::uint32_t, std::int32_t> edges;
    for (const auto& s : world_.walls.segments) ++edges[index(s.wall)];
    for (const auto& s : world_.walls.segments) {
      const std::int32_t n = edges.at(index(s.wall));
      Piece p = piece(PieceKind::segment, s);
      p.point = place(s.from);
      p.to = place(s.to);
      p.velocity = speed(s.velocity);
      p.point_feature = n + s.feature;
      p.to_feature = n == 1 ? n + 1 : n + (s.feature + 1) % n;
      layout_.pieces.push_back(p);
    }
  }
  void add_sphere(const Sphere<double, D>& sphere) {
    Piece p = piece(sphere.inside ? PieceKind::ring : PieceKind::disc, sphere);
    p.point = place(sphere.centre);
    p.velocity = speed(sphere.velocity);
    p.radius = length(sphere.radius);
    layout_.pieces.push_back(p);
  }

  template <class Shape>
  void add_foreign(const Shape& shape, const char* what) {
    layout_.foreign.push_back("wall " + world_.walls.labels[index(shape.wall)] + " is " + what);
  }

  void reach(const Point& x, double beyond) {
    for (const double c : x) layout_.extent = std::max(layout_.extent, std::abs(c) + beyond);
  }

  void finish() {
    layout_.smallest_radius = layout_.bodies.empty() ? 0.0 : layout_.bodies[0].radius;
    for (const Body& b : layout_.bodies) {
      layout_.largest_radius = std::max(layout_.largest_radius, b.radius);
      layout_.smallest_radius = std::min(layout_.smallest_radius, b.radius);
      layout_.fastest = std::max(layout_.fastest, norm(b.velocity));
      reach(b.position, b.radius);
    }
    if (world_.space.kind != SpaceKind::open) {
      reach(place(world_.space.lower), 0.0);
      reach(place(world_.space.lower + world_.space.edge), 0.0);
    }
    for (const Piece& p : layout_.pieces) {
      layout_.fastest = std::max(layout_.fastest, norm(p.velocity));
      reach(p.point, p.radius);
      if (p.kind == PieceKind::segment) reach(p.to, 0.0);
    }
    for (Piece& p : layout_.pieces)
      p.half_length += p.endless ? layout_.extent + 1024 * layout_.largest_radius : 4 * layout_.largest_radius;
  }

  const World<double, D>& world_;
  Layout layout_;
};

template <int D>
Layout layout_in(const Scene& scene, int size) {
  const World<double, D> world = build<double, D>(scene);
  return LayoutMaker<D>(scene, world, size).make();
}

}  // namespace

Layout make_layout(const Scene& scene, int size) {
  switch (scene.dimension) {
    case 1:
      return layout_in<1>(scene, size);
    case 2:
      return layout_in<2>(scene, size);
    default:
      return layout_in<3>(scene, size);
  }
}

}  // namespace carom::game_engine
