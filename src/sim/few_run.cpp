#include "carom/sim/few_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/predict/ball_ball.hpp"
#include "carom/predict/lattice_ray.hpp"
#include "few_targets.hpp"
#include "machine.hpp"

namespace carom {

namespace detail {

namespace {

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

template <int D>
Event<double, D> event_of(const FewRun<D>& run, std::uint32_t i, const Time<double>& t) {
  Event<double, D> event;
  event.time = t;
  event.ball = i;
  event.stamp = run.world->balls[i].stamp;
  return event;
}

}  // namespace

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
double flight_to_image(const FewRun<D>& run, std::uint32_t s, const Image<D>& image) {
  return next_meeting(FreeFlight<double, D>{}, *run.world, run.slot[s].low, run.slot[s].high, image).flight;
}

template <int D>
void predict_pair(FewRun<D>& run, std::uint32_t s) {
  constexpr int columns = 8;
  const FreeFlight<double, D> motion;
  const World<double, D>& world = *run.world;
  typename FewRun<D>::Slot& slot = run.slot[s];
  const auto [r, g, since] = relative_state(motion, world, world.balls[slot.low], world.balls[slot.high], Image<D>{});
  if (!world.space.periodic()) return set_flight(run, s, next_meeting(motion, world, slot.low, slot.high, Image<D>{}).flight, *since);
  if (g == Vec<double, D>::Zero()) return set_flight(run, s, never<double>(), *since);
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
    if (first < never<double>()) return set_flight(run, s, first, *since);
  }
  slot.settled = false;
  slot.column = column;
  set_flight(run, s, std::max(0.0, ray.entry(column)), *since);
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

template <int D>
FewKernel<D> few_kernel(const World<double, D>& world, [[maybe_unused]] bool vectors) {
#if defined(CAROM_HAVE_AVX2_TARGET)
  if (vectors && machine_has_avx2()) return few_kernel_of<D, Avx2>(world.space.periodic());
#endif
  return few_kernel_of<D, Baseline>(world.space.periodic());
}

#define CAROM_INSTANTIATE(D)                                                                                              \
  template FewKernel<D> few_kernel(const World<double, D>&, bool);                                                        \
  template void detail::start_few(FewRun<D>&, World<double, D>&, Collider<FreeFlight<double, D>>&, const Time<double>&);   \
  template void detail::predict_pair(FewRun<D>&, std::uint32_t);                                                          \
  template double detail::flight_to_image(const FewRun<D>&, std::uint32_t, const Image<D>&);                              \
  template std::uint32_t detail::first_of_close(const FewRun<D>&, double, bool&);                                         \
  template Verdict detail::collide_slot(FewRun<D>&, std::uint32_t, const Time<double>&);                                  \
  template void detail::rebase(FewRun<D>&);                                                                               \
  template void detail::one_contact(BallDetail<double, D>&);
CAROM_INSTANTIATE(2)
CAROM_INSTANTIATE(3)
#undef CAROM_INSTANTIATE

}  // namespace carom
