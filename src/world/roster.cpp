#include "roster.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/error.hpp"
#include "carom/world/placement/gas.hpp"
#include "carom/world/placement/lattice.hpp"
#include "curved_walls.hpp"
#include "outline.hpp"

namespace carom {
namespace {

Region region_of(const Scene& scene) {
  Region region;
  region.kind = scene.space.kind;
  region.dimension = scene.dimension;
  if (region.kind == SpaceKind::open) return region;
  for (int k = 0; k < scene.dimension; ++k) {
    region.lower[k] = scene.space.lower[k];
    region.upper[k] = scene.space.upper[k];
  }
  return region;
}

double distance_to_segment(const double* x, const Coordinates& a, const Coordinates& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double u = std::clamp(((x[0] - a[0]) * dx + (x[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const double ex = x[0] - (a[0] + u * dx), ey = x[1] - (a[1] + u * dy);
  return std::sqrt(ex * ex + ey * ey);
}

double value_of(const Number& n) { return n.value; }

/// The box around all closed tables of an open space: where its gases are placed.
Region region_of_tables(const std::vector<Outline>& tables) {
  Region region{SpaceKind::box, 2, {}, {}};
  for (std::size_t k = 0; k < 2; ++k) {
    region.lower[k] = region.upper[k] = tables.front().lower()[k];
    for (const Outline& t : tables) {
      region.lower[k] = std::min(region.lower[k], t.lower()[k]);
      region.upper[k] = std::max(region.upper[k], t.upper()[k]);
    }
  }
  return region;
}

/// Free distance from the point x to a wall; negative on its wrong side.
double clearance(const WallSpec& wall, const double* x, int dimension) {
  switch (wall.kind) {
    case WallKind::plane: {
      double along = 0, length = 0;
      for (int k = 0; k < dimension; ++k) {
        along += wall.normal[k] * (x[k] - wall.point[k]);
        length += wall.normal[k] * wall.normal[k];
      }
      return along / std::sqrt(length);
    }
    case WallKind::circle: {
      double rr = 0;
      for (int k = 0; k < dimension; ++k) rr += (x[k] - wall.centre[k]) * (x[k] - wall.centre[k]);
      const double distance = std::sqrt(rr);
      return wall.side == WallSide::inside ? wall.radius - distance : distance - wall.radius;
    }
    case WallKind::segment:
      return distance_to_segment(x, wall.from, wall.to);
    case WallKind::polygon: {
      double nearest = HUGE_VAL;
      for (std::size_t i = 0; i < wall.vertices.size(); ++i)
        nearest =
            std::min(nearest, distance_to_segment(x, wall.vertices[i], wall.vertices[(i + 1) % wall.vertices.size()]));
      return nearest;
    }
    case WallKind::arc:
      return detail::make_arc<double>(wall, value_of).gap({x[0], x[1]});
    case WallKind::ellipse:
      return detail::make_ellipse<double>(wall, value_of).gap({x[0], x[1]});
    case WallKind::parabola:
      return detail::make_parabola<double>(wall, value_of).gap({x[0], x[1]});
    case WallKind::curve:
      return detail::make_polar_curve<double>(wall, value_of).gap({x[0], x[1]});
  }
  return HUGE_VAL;
}

/// The same in a periodic space, where it stands in every period: those within two periods are looked at.
double clearance_in_periods(const WallSpec& wall, const double* x, const Region& region) {
  double least = HUGE_VAL;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = region.dimension == 3 ? -2 : 0; k <= (region.dimension == 3 ? 2 : 0); ++k) {
        const double at[3] = {x[0] + i * region.length(0), x[1] + j * region.length(1),
                              region.dimension == 3 ? x[2] + k * region.length(2) : 0};
        least = std::min(least, clearance(wall, at, region.dimension));
      }
  return least;
}

}  // namespace

std::size_t Roster::placed() const {
  std::size_t n = 0;
  for (const PlacedGroup& g : groups)
    n += g.balls.position.size() / static_cast<std::size_t>(std::max(1, g.balls.region.dimension));
  return n;
}

Roster make_roster(const Scene& scene) {
  Roster roster;
  roster.region = region_of(scene);
  std::vector<Problem> problems;
  const auto collect = [&](const InputError& e) {
    for (Problem p : e.problems()) {
      if (p.file.empty()) p.file = scene.file;
      problems.push_back(std::move(p));
    }
  };

  std::vector<Obstacle> obstacles;
  for (const BallSpec& ball : scene.balls) {
    Obstacle o;
    for (int k = 0; k < scene.dimension; ++k) o.position[k] = ball.position[k];
    o.radius = ball.radius;
    obstacles.push_back(o);
  }
  for (const LatticeSpec& spec : scene.lattices) {
    try {
      roster.groups.push_back({place_lattice(spec, roster.region), spec.mass, spec.material, spec.where.line, spec.radius_growth});
    } catch (const InputError& e) {
      collect(e);
    }
  }
  if (!problems.empty()) throw InputError(problems);
  if (scene.gases.empty()) return roster;

  for (const PlacedGroup& g : roster.groups)
    for (std::size_t i = 0; i < g.balls.position.size(); i += static_cast<std::size_t>(scene.dimension)) {
      Obstacle o;
      for (int k = 0; k < scene.dimension; ++k) o.position[k] = g.balls.position[i + static_cast<std::size_t>(k)];
      o.radius = g.balls.radius;
      obstacles.push_back(o);
    }
  const std::vector<Outline> tables = outlines(scene);
  const bool in_tables = roster.region.kind == SpaceKind::open && !tables.empty();
  ClearOfWalls clear;
  if (!scene.walls.empty())
    clear = [&](const double* x, double radius) {
      return std::all_of(scene.walls.begin(), scene.walls.end(),
                         [&](const WallSpec& w) {
                           const bool periodic = roster.region.kind == SpaceKind::periodic;
                           return (periodic ? clearance_in_periods(w, x, roster.region) : clearance(w, x, scene.dimension)) >
                                  radius;
                         }) &&
             (tables.empty() || std::any_of(tables.begin(), tables.end(), [&](const Outline& t) { return t.inside(x); }));
    };
  try {
    std::vector<PlacedBalls> gases =
        place_gases(scene.gases, in_tables ? region_of_tables(tables) : roster.region, obstacles, clear);
    for (std::size_t i = 0; i < gases.size(); ++i) {
      if (!in_tables) roster.region = gases[i].region;
      const GasSpec& spec = scene.gases[i];
      roster.groups.push_back({std::move(gases[i]), spec.mass, spec.material, spec.where.line, spec.radius_growth});
    }
  } catch (const InputError& e) {
    collect(e);
    throw InputError(problems);
  }
  return roster;
}

}  // namespace carom
