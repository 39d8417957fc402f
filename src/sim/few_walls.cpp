// What the loop of few balls knows of walls: which it can do itself, and the way of EventDriven to all others.

#include <algorithm>
#include <cmath>

#include "carom/predict/ball_wall.hpp"
#include "carom/sim/few_run.hpp"
#include "carom/world/wall_motion.hpp"

namespace carom {

namespace detail {

namespace {

/// Spheres that the loop knows: at rest, and no vertices.
template <int D>
bool is_plain(const World<double, D>& world, const Sphere<double, D>& sphere) {
  return sphere.radius > 0 && !moves(world.walls, sphere);
}

/// A point flies past a vertex, or past both ends of a segment on one side, for certain. (Touching one of them may be another
/// matter.)
template <int D, class Shape>
bool passes_by(const Ball<double, D>& ball, const Shape& shape) {
  if constexpr (std::is_same_v<Shape, Sphere<double, 2>>) {
    return shape.radius == 0 && plain_side_of_path(ball.position, ball.velocity, shape.centre) != 0;
  } else if constexpr (std::is_same_v<Shape, Segment<double>> && D == 2) {
    return plain_side_of_path(ball.position, ball.velocity, shape.from) * plain_side_of_path(ball.position, ball.velocity, shape.to) > 0;
  }
  return false;
}

/// Calls f for every piece of every wall that the loop does not know. Joints without a corner are nothing that points meet.
template <int D, class F>
void for_each_other(const World<double, D>& world, double radius, F&& f) {
  world.walls.for_each([&](const auto& shape) {
    using Shape = std::remove_cvref_t<decltype(shape)>;
    if constexpr (std::is_same_v<Shape, Sphere<double, D>>) {
      const bool joint = shape.smooth && shape.radius == 0 && radius == 0;
      if (!joint && !is_plain(world, shape)) f(shape);
    } else if constexpr (!std::is_same_v<Shape, Face<double, D>>) {
      f(shape);
    }
  });
}
/// Takes up an event of ball i if it is the first.
template <int D>
void offer(typename FewRun<D>::Wall& wall, const Event<double, D>& e) {
  if (e.kind == EventKind::none || e.time > wall.event.time) return;
  const bool before = precedes(e, wall.event);
  if (!before && !precedes(wall.event, e)) return;  // it is the same
  wall.tied = e.time == wall.event.time;
  if (before) wall.event = e;
}

/// The event of a wall that the loop knows becomes an entry of its own kind.
template <int D>
void set_walls(FewRun<D>& run, std::uint32_t i) {
  typename FewRun<D>::Wall& wall = run.wall[i];
  const World<double, D>& world = *run.world;
  const Ball<double, D>& ball = world.balls[i];
  const bool any = wall.event.kind != EventKind::none;
  wall.which = FewRun<D>::some_wall;
  wall.segment = nullptr;
  wall.arc = nullptr;
  set_flight(run, run.slot_of[i][i], any ? elapsed(ball.time, wall.event.time) : never<double>(), ball.time);
  if (!any || wall.tied) return;
  for (std::uint32_t row = 0; row < run.spheres.size(); ++row) {
    const auto& sphere = world.walls.spheres[run.spheres[row]];
    if (index(sphere.wall) != wall.event.partner || sphere.feature != wall.event.feature) continue;
    wall.which = 2 * D + row;
    wall.image = wall.event.image;
    const auto placed = wall.image == Image<D>{} ? sphere : moved_by(world.space, sphere, wall.image);
    for (int k = 0; k < D; ++k) wall.centre[k] = placed.centre[k];
    const Touch touch = touch_of_wall(wall_contact(world, i, wall.event.partner, wall.event.feature, wall.image), ball);
    set_flight(run, run.slot_of[i][i], flight_to_wall(FreeFlight<double, D>{}, world, ball, placed, touch), ball.time);
  }
}

/// Predicts the walls of ball i in a periodic space: those near each period that its path runs through, until what it meets
/// first is certain.
template <int D>
void predict_walls_of_periods(FewRun<D>& run, std::uint32_t i) {
  constexpr int most_tiles = 8;
  const World<double, D>& world = *run.world;
  const Ball<double, D>& ball = world.balls[i];
  typename FewRun<D>::Wall& wall = run.wall[i];
  bool& settled = run.slot[run.slot_of[i][i]].settled;
  if (settled) wall.tile = Image<D>{};
  settled = true;
  double leaves = never<double>();
  for (int m = 0; m < most_tiles; ++m) {
    const auto meet = [&](const auto& shape, const Image<D>& image) {
      offer(wall, predict_wall(FreeFlight<double, D>{}, world, i, shape, image));
    };
    run.near_walls.for_each(world, 0, wall.tile, meet);
    int axis = -1;
    leaves = never<double>();
    for (int k = 0; k < D; ++k) {
      const double v = ball.velocity[k];
      if (v == 0) continue;
      const double t = (world.space.lower[k] + (wall.tile[k] + (v > 0)) * world.space.edge[k] - ball.position[k]) / v;
      if (!(t < leaves)) continue;
      leaves = t;
      axis = k;
    }
    const bool met = wall.event.kind != EventKind::none && !(elapsed(ball.time, wall.event.time) > leaves);
    if (met || axis < 0) return set_walls(run, i);
    wall.tile[axis] += ball.velocity[axis] > 0 ? 1 : -1;
  }
  settled = false;
  wall.which = FewRun<D>::some_wall;
  wall.event = {};
  wall.event.time = after(ball.time, std::max(0.0, leaves));
  set_flight(run, run.slot_of[i][i], std::max(0.0, leaves), ball.time);
}

/// In the order of circles_of.
std::vector<NextCircles> lists_by_radius(const FewRun<2>& run, const std::vector<Sphere<double, 2>>& circles, NextCircles::Of of) {
  std::vector<NextCircles> lists;
  for (std::uint32_t i = 0; i < run.world->balls.size(); ++i)
    if (!run.world->balls[i].fixed && run.circles_of[i] == lists.size())
      lists.emplace_back(run.world->space, circles, run.world->balls[i].radius, of);
  return lists;
}

}  // namespace

template <int D>
void plan_walls(FewRun<D>& run, const World<double, D>& world) {
  for (int k = 0; k < D; ++k) {
    run.face[static_cast<std::size_t>(2 * k)] = -infinity<double>();
    run.face[static_cast<std::size_t>(2 * k + 1)] = infinity<double>();
  }
  run.face_row.fill(-1);
  for (std::size_t f = 0; f < world.walls.faces.size(); ++f) {
    const auto& face = world.walls.faces[f];
    const std::size_t which = static_cast<std::size_t>(2 * face.axis + (face.sign > 0 ? 0 : 1));
    run.face[which] = face.coordinate;
    run.face_row[which] = static_cast<std::int32_t>(f);
  }
  run.spheres.clear();
  for (std::size_t s = 0; s < world.walls.spheres.size(); ++s)
    if (is_plain(world, world.walls.spheres[s])) run.spheres.push_back(static_cast<std::uint32_t>(s));
  run.other_walls = false;
  run.flat_or_round = !world.space.periodic();
  for_each_other(world, 1.0, [&](const auto& shape) {
    using Shape = std::remove_cvref_t<decltype(shape)>;
    run.other_walls = true;
    run.flat_or_round = run.flat_or_round && !moves(world.walls, shape) &&
                        (std::is_same_v<Shape, Segment<double>> || std::is_same_v<Shape, Arc<double>> ||
                         std::is_same_v<Shape, Sphere<double, 2>>);
  });
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    const double radius = world.balls[i].radius, mass = world.details[i].mass;
    run.flat_pair[i] = elastic_pair(1.0, mass, infinity<double>(), 0);
    run.arc_pair[i].clear();
    for (const Arc<double>& arc : world.walls.arcs)
      run.arc_pair[i].push_back({elastic_pair(arc.radius + radius, mass, infinity<double>(), 0),
                                 elastic_pair(arc.radius - radius, mass, infinity<double>(), 0)});
    run.sphere_pair[i].clear();
    for (const std::uint32_t s : run.spheres) {
      const auto& sphere = world.walls.spheres[s];
      const double sigma = sphere.inside ? sphere.radius - radius : sphere.radius + radius;
      run.sphere_pair[i].push_back(elastic_pair(sigma, mass, infinity<double>(), 0));
    }
  }
}
template <int D>
void survey(FewRun<D>& run, const World<double, D>& world) {
  if (!world.space.periodic()) return;
  double largest = 0;
  for (const auto& ball : world.balls) largest = std::max(largest, ball.radius);
  std::array<std::int64_t, static_cast<std::size_t>(D)> one_cell;
  one_cell.fill(1);
  if (!world.walls.empty()) run.near_walls.reset(world, world.space.lower, world.space.edge, one_cell, largest, 0x1p-10);
  std::vector<double> radii;
  run.fixed_row.fill(~std::uint32_t{0});
  for (std::uint32_t i = 0; i < world.balls.size(); ++i) {
    if (world.balls[i].fixed) {
      run.fixed_row[i] = static_cast<std::uint32_t>(run.fixed.size());
      run.fixed.push_back(i);
      continue;
    }
    const auto known = std::find(radii.begin(), radii.end(), world.balls[i].radius);
    run.circles_of[i] = static_cast<std::uint32_t>(known - radii.begin());
    if (known == radii.end()) radii.push_back(world.balls[i].radius);
  }
}

void miss_circles(FewRun<2>& run) {
  if (++run.without_circles != 256 || run.other_walls) return;
  std::vector<Sphere<double, 2>> circles;
  for (const std::uint32_t row : run.spheres) circles.push_back(run.world->walls.spheres[row]);
  run.next_circles = lists_by_radius(run, circles, NextCircles::Of::walls);
}

void miss_fixed(FewRun<2>& run) {
  if (++run.without_fixed != 1024 || run.fixed.size() < 2) return;  // of one, the images in the order of the path do as well
  std::vector<Sphere<double, 2>> circles;
  for (const std::uint32_t i : run.fixed) {
    Sphere<double, 2>& circle = circles.emplace_back();
    circle.centre = run.world->balls[i].position;
    circle.radius = run.world->balls[i].radius;
    if (!(circle.radius > 0)) return;  // points do not meet it
  }
  run.next_fixed = lists_by_radius(run, circles, NextCircles::Of::balls);
}

template <int D>
void predict_walls(FewRun<D>& run, std::uint32_t i) {
  typename FewRun<D>::Wall& wall = run.wall[i];
  wall.event = {};
  wall.tied = false;
  if (run.world->space.periodic()) return predict_walls_of_periods(run, i);
  run.world->walls.for_each(
      [&](const auto& shape) { offer(wall, predict_wall(FreeFlight<double, D>{}, *run.world, i, shape)); });
  set_walls(run, i);
}

double flight_to_circle(const Ball<double, 2>& ball, double x, double y, double sigma) {
  return meet_time<double, 2>(ball.position - Vec<double, 2>(x, y), ball.velocity, sigma);
}

template <int D>
double flight_to_sphere(const FewRun<D>& run, std::uint32_t i, std::uint32_t row) {
  const World<double, D>& world = *run.world;
  const auto& sphere = world.walls.spheres[run.spheres[row]];
  const Touch touch = touch_of_wall(wall_contact(world, i, index(sphere.wall), sphere.feature), world.balls[i]);
  return flight_to_wall(FreeFlight<double, D>{}, world, world.balls[i], sphere, touch);
}

template <int D>
void find_other_wall(FewRun<D>& run, std::uint32_t i) {
  typename FewRun<D>::Wall& wall = run.wall[i];
  const World<double, D>& world = *run.world;
  const Ball<double, D>& ball = world.balls[i];
  wall.event = {};
  wall.segment = nullptr;
  wall.arc = nullptr;
  for_each_other(world, ball.radius, [&](const auto& shape) {
    using Shape = std::remove_cvref_t<decltype(shape)>;
    if (ball.radius == 0 && passes_by(ball, shape) && !moves(world.walls, shape) &&
        wall_contact(world, i, index(shape.wall), shape.feature) == nullptr)
      return;
    const Event<double, D> e = predict_wall(FreeFlight<double, D>{}, world, i, shape);
    if (e.kind == EventKind::none || !precedes(e, wall.event)) return;
    wall.event = e;
    wall.segment = nullptr;
    wall.arc = nullptr;
    if (!run.flat_or_round) return;
    if constexpr (std::is_same_v<Shape, Segment<double>>) wall.segment = &shape;
    if constexpr (std::is_same_v<Shape, Arc<double>>) wall.arc = &shape;
  });
}

template <int D>
bool stays_clear(const FewRun<D>& run, std::uint32_t i, const double* x) {
  if constexpr (D == 2) {
    if (!run.flat_or_round) return false;
    const World<double, D>& world = *run.world;
    const typename FewRun<D>::Wall& wall = run.wall[i];
    const Vec<double, 2> at(x[0], x[1]);
    const Ball<double, D>& ball = world.balls[i];
    double reach = world.details[i].reach;
    for (int k = 0; k < D; ++k) reach = std::max({reach, std::fabs(x[k]), std::fabs(ball.position[k])});
    // Twice what sides.hpp and curve_sides.hpp doubt.
    for (const Segment<double>& s : world.walls.segments) {
      if (&s == wall.segment) continue;
      const double doubt = 2 * (place_doubt<double>(at, s.from, s.to) + 8 * unit_roundoff<double>() * reach);
      if (std::fabs(s.height(at)) > doubt) continue;
      if (!(dot<double, 2>(s.along, at - s.from) < -doubt) && !(dot<double, 2>(s.along, at - s.to) > doubt)) return false;
    }
    for (const Arc<double>& arc : world.walls.arcs) {
      if (&arc == wall.arc) continue;
      const double doubt =
          2 * (place_doubt<double>(at, arc.from, arc.to) + 8 * unit_roundoff<double>() * (reach + 2 * arc.radius));
      if (!(std::fabs(arc.height(at)) > doubt)) return false;
    }
    return true;
  }
  return false;
}

#define CAROM_INSTANTIATE(D)                                                                                  \
  template void plan_walls(FewRun<D>&, const World<double, D>&);                                              \
  template void survey(FewRun<D>&, const World<double, D>&);                                                  \
  template void predict_walls(FewRun<D>&, std::uint32_t);                                                     \
  template double flight_to_sphere(const FewRun<D>&, std::uint32_t, std::uint32_t);                           \
  template void find_other_wall(FewRun<D>&, std::uint32_t);                                                   \
  template bool stays_clear(const FewRun<D>&, std::uint32_t, const double*);
CAROM_INSTANTIATE(2)
CAROM_INSTANTIATE(3)
#undef CAROM_INSTANTIATE

}  // namespace detail

}  // namespace carom
