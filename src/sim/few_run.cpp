#include "carom/sim/few_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/predict/ball_ball.hpp"
#include "carom/predict/ball_wall.hpp"
#include "carom/predict/lattice_ray.hpp"
#include "carom/world/wall_motion.hpp"
#include "few_targets.hpp"

namespace carom {

namespace detail {

namespace {

/// Spheres that the loop knows: at rest, and no vertices.
template <int D>
bool is_plain(const World<double, D>& world, const Sphere<double, D>& sphere) {
  return sphere.radius > 0 && !moves(world.walls, sphere);
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
  for_each_other(world, 1.0, [&](const auto&) { run.other_walls = true; });
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    run.sphere_pair[i].clear();
    for (const std::uint32_t s : run.spheres) {
      const auto& sphere = world.walls.spheres[s];
      const double radius = world.balls[i].radius, sigma = sphere.inside ? sphere.radius - radius : sphere.radius + radius;
      run.sphere_pair[i].push_back(elastic_pair(sigma, world.details[i].mass, infinity<double>(), 0));
    }
  }
}

template <int D>
void plan_slots(FewRun<D>& run, const World<double, D>& world) {
  const std::uint32_t n = static_cast<std::uint32_t>(world.balls.size());
  double longest = 0;
  for (int k = 0; k < D; ++k) {
    run.edge[k] = world.space.edge[k];
    run.per_edge[k] = world.space.periodic() ? 1 / world.space.edge[k] : 0;
    if (world.space.periodic()) longest = std::max(longest, run.edge[k]);
  }
  run.slots = 0;
  for (auto& row : run.slot_of) row.fill(FewRun<D>::no_slot);
  run.other_count.fill(0);
  for (auto& row : run.sigma) row.fill(0.0);
  for (std::uint32_t i = 0; i < n; ++i) run.others[i].fill(i);
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = i; j < n; ++j) {
      const auto &a = world.balls[i], &b = world.balls[j];
      const double sigma = a.radius + b.radius;
      if (i == j ? a.fixed || world.walls.empty() : (a.fixed && b.fixed) || sigma == 0) continue;
      typename FewRun<D>::Slot& slot = run.slot[run.slots];
      slot = {};
      slot.low = i;
      slot.high = j;
      run.slot_of[i][j] = run.slot_of[j][i] = run.slots++;
      if (i == j) continue;
      slot.pair = elastic_pair(sigma, world.details[i].mass, world.details[j].mass, 65 * longest);
      for (const auto& [own, other] : {std::pair{i, j}, std::pair{j, i}}) {
        run.sigma[own][run.other_count[own]] = sigma;
        run.others[own][run.other_count[own]++] = other;
      }
    }
  run.flight.fill(never<double>());
  run.due.fill(never<double>());
}

/// Sets the flight of a slot that is counted from `since`.
template <int D>
void set(FewRun<D>& run, std::uint32_t slot, double flight, const Time<double>& since) {
  run.flight[slot] = flight;
  run.due[slot] = (static_cast<double>(since.epoch - run.base) + since.offset) + flight;
}

template <int D>
Event<double, D> event_of(const FewRun<D>& run, std::uint32_t i, const Time<double>& t) {
  Event<double, D> event;
  event.time = t;
  event.ball = i;
  event.stamp = run.world->balls[i].stamp;
  return event;
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
  set(run, run.slot_of[i][i], any ? elapsed(ball.time, wall.event.time) : never<double>(), ball.time);
  if (!any || wall.tied) return;
  for (std::uint32_t row = 0; row < run.spheres.size(); ++row) {
    const auto& sphere = world.walls.spheres[run.spheres[row]];
    if (index(sphere.wall) != wall.event.partner || sphere.feature != wall.event.feature) continue;
    wall.which = 2 * D + row;
    wall.image = wall.event.image;
    const auto placed = wall.image == Image<D>{} ? sphere : moved_by(world.space, sphere, wall.image);
    for (int k = 0; k < D; ++k) wall.centre[k] = placed.centre[k];
    const Touch touch = touch_of_wall(wall_contact(world, i, wall.event.partner, wall.event.feature, wall.image), ball);
    set(run, run.slot_of[i][i], flight_to_wall(FreeFlight<double, D>{}, world, ball, placed, touch), ball.time);
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
  set(run, run.slot_of[i][i], std::max(0.0, leaves), ball.time);
}

}  // namespace

template <int D>
void survey_walls(FewRun<D>& run, const World<double, D>& world) {
  if (!world.space.periodic() || world.walls.empty()) return;
  std::array<std::int64_t, static_cast<std::size_t>(D)> one_cell;
  one_cell.fill(1);
  double largest = 0;
  for (const auto& ball : world.balls) largest = std::max(largest, ball.radius);
  run.near_walls.reset(world, world.space.lower, world.space.edge, one_cell, largest, 0x1p-10);
  if constexpr (D == 2) {
    std::vector<Sphere<double, 2>> circles;
    for (const auto& sphere : world.walls.spheres)
      if (is_plain(world, sphere)) circles.push_back(sphere);
    std::vector<double> radii;
    for (std::size_t i = 0; i < world.balls.size(); ++i) {
      const auto known = std::find(radii.begin(), radii.end(), world.balls[i].radius);
      run.circles_of[i] = static_cast<std::uint32_t>(known - radii.begin());
      if (known != radii.end()) continue;
      radii.push_back(world.balls[i].radius);
      run.next_circles.emplace_back(world.space, circles, radii.back());
    }
  }
}

template <int D>
void start_few(FewRun<D>& run, World<double, D>& world, Collider<FreeFlight<double, D>>& collider, const Time<double>& now) {
  run.world = &world;
  run.collider = &collider;
  run.now = now;
  run.base = now.epoch;
  run.passages = 0;
  plan_walls(run, world);
  plan_slots(run, world);
  for (std::uint32_t s = 0; s < run.slots; ++s) {
    if (run.slot[s].low == run.slot[s].high) {
      predict_walls(run, run.slot[s].low);
    } else {
      predict_pair(run, s);
    }
  }
}

template <int D>
void predict_pair(FewRun<D>& run, std::uint32_t s) {
  constexpr int columns = 8;
  const FreeFlight<double, D> motion;
  const World<double, D>& world = *run.world;
  typename FewRun<D>::Slot& slot = run.slot[s];
  const auto [r, g, since] = relative_state(motion, world, world.balls[slot.low], world.balls[slot.high], Image<D>{});
  if (!world.space.periodic()) return set(run, s, next_meeting(motion, world, slot.low, slot.high, Image<D>{}).flight, *since);
  if (g == Vec<double, D>::Zero()) return set(run, s, never<double>(), *since);
  const LatticeRay<D> ray(r.data(), g.data(), slot.pair.sigma, run.edge, run.per_edge);
  double column = slot.settled ? ray.first() : slot.column;
  slot.settled = true;
  for (int m = 0; m < columns; ++m, column += 1) {
    double first = never<double>();
    for (int corner = 0; corner < 1 << (D - 1); ++corner) {
      Image<D> image;
      int bit = 0;
      for (int k = 0; k < D; ++k) {
        const double n = k == ray.axis ? ray.sense * column : ray.row(k, column) + (corner >> bit++ & 1);
        image[k] = static_cast<std::int32_t>(n);
      }
      const double flight = next_meeting(motion, world, slot.low, slot.high, image).flight;
      if (!(flight < first)) continue;
      first = flight;
      slot.image = image;
    }
    if (first < never<double>()) return set(run, s, first, *since);
  }
  slot.settled = false;
  slot.column = column;
  set(run, s, std::max(0.0, ray.entry(column)), *since);
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
Event<double, D> first_other_wall(const FewRun<D>& run, std::uint32_t i) {
  Event<double, D> first;
  for_each_other(*run.world, run.world->balls[i].radius, [&](const auto& shape) {
    const Event<double, D> e = predict_wall(FreeFlight<double, D>{}, *run.world, i, shape);
    if (e.kind != EventKind::none && precedes(e, first)) first = e;
  });
  return first;
}

template <int D>
std::uint32_t first_of_close(const FewRun<D>& run, double limit, bool& tied) {
  const double latest = limit + (0x1p-50 * std::fabs(limit) + 0x1p-50);
  std::uint32_t at = 0;
  Time<double> first = Time<double>::never();
  for (std::uint32_t s = 0; s < run.slots; ++s) {
    if (!(run.due[s] <= latest)) continue;
    const Time<double> t = time_of(run, s);
    if (t > first || t.is_never()) continue;
    tied = t == first;
    if (t < first) at = s;
    first = t;
  }
  return at;
}

template <int D>
Verdict collide_slot(FewRun<D>& run, std::uint32_t s, const Time<double>& t) {
  const typename FewRun<D>::Slot& slot = run.slot[s];
  Event<double, D> event = event_of(run, slot.low, t);
  if (slot.low != slot.high) {
    event.kind = EventKind::ball_ball;
    event.partner = slot.high;
    event.partner_stamp = run.world->balls[slot.high].stamp;
    event.image = slot.image;
    return run.collide(run, event);
  }
  const std::uint32_t which = run.wall[slot.low].which;
  if (which == FewRun<D>::some_wall) return run.collide(run, run.wall[slot.low].event);
  event.kind = EventKind::ball_wall;
  const auto take = [&](const auto& shape) {
    event.partner = index(shape.wall);
    event.feature = shape.feature;
  };
  if (which < 2 * D) {
    take(run.world->walls.faces[static_cast<std::size_t>(run.face_row[which])]);
  } else {
    if (run.world->space.periodic()) event.image = run.wall[slot.low].image;
    take(run.world->walls.spheres[run.spheres[which - 2 * D]]);
  }
  return run.collide(run, event);
}

template <int D>
void rebase(FewRun<D>& run) {
  const double gone = static_cast<double>(run.now.epoch - run.base);
  run.base = run.now.epoch;
  for (double& due : run.due) due -= gone;
}

template <int D>
void one_contact(BallDetail<double, D>& detail) {
  detail.contacts.resize(1);
}

}  // namespace detail

namespace {
bool machine_has_avx2() {
#if defined(CAROM_HAVE_AVX2_TARGET)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
  return false;
#endif
}
}  // namespace

template <int D>
FewKernel<D> few_kernel(const World<double, D>& world, [[maybe_unused]] bool vectors) {
#if defined(CAROM_HAVE_AVX2_TARGET)
  if (vectors && machine_has_avx2()) return few_kernel_of<D, Avx2>(world.space.periodic());
#endif
  return few_kernel_of<D, Baseline>(world.space.periodic());
}

#define CAROM_INSTANTIATE(D)                                                                                              \
  template FewKernel<D> few_kernel(const World<double, D>&, bool);                                                        \
  template void detail::survey_walls(FewRun<D>&, const World<double, D>&);                                                \
  template void detail::start_few(FewRun<D>&, World<double, D>&, Collider<FreeFlight<double, D>>&, const Time<double>&);   \
  template void detail::predict_pair(FewRun<D>&, std::uint32_t);                                                          \
  template void detail::predict_walls(FewRun<D>&, std::uint32_t);                                                         \
  template double detail::flight_to_sphere(const FewRun<D>&, std::uint32_t, std::uint32_t);                               \
  template Event<double, D> detail::first_other_wall(const FewRun<D>&, std::uint32_t);                                    \
  template std::uint32_t detail::first_of_close(const FewRun<D>&, double, bool&);                                         \
  template Verdict detail::collide_slot(FewRun<D>&, std::uint32_t, const Time<double>&);                                  \
  template void detail::rebase(FewRun<D>&);                                                                               \
  template void detail::one_contact(BallDetail<double, D>&);
CAROM_INSTANTIATE(2)
CAROM_INSTANTIATE(3)
#undef CAROM_INSTANTIATE

}  // namespace carom
