#pragma once
// Shells of balls on their way: where they are put, and when the balls leave them.

#include <cstdint>

#include "carom/core/lanes.hpp"
#include "carom/sim/swarm_run.hpp"

namespace carom {

/// `Target`: see SwarmLoop.
template <int D, class Target, bool periodic, bool equal>
class SwarmExits {
 public:
  using Run = SwarmRun<D>;

  /// The centre of a shell for ball i at t, set ahead of it on its way: by 1.2 mean free times, at most by 3/4 of its
  /// radius.
  CAROM_INLINE static void find_centre(const Run& run, std::uint32_t i, const Time<double>& t, double (&x)[D]) {
    const Flight<D>& ball = run.swarm.flights[i];
    const double flown = elapsed(ball.time(), t);
    double square = 0;
    for (int k = 0; k < D; ++k) square += ball.v[k] * ball.v[k];
    double ahead = 1.2 * run.mean_free_time;
    const double most = 0.75 * run.shells.template radius<equal>(run.swarm, i);
    if (ahead * ahead * square > most * most) ahead = most / __builtin_sqrt(square);
    for (int k = 0; k < D; ++k) x[k] = ball.x[k] + ball.v[k] * flown + ball.v[k] * ahead;
  }

  /// A shell for ball i.
  [[gnu::noinline, gnu::flatten]] static void place(Run& run, std::uint32_t i) {
    double x[D];
    find_centre(run, i, run.clock, x);
    run.shells.template place<equal>(run.swarm, i, x);
    if constexpr (!periodic)
      if (run.near_walls.size() != 0)
        run.near_walls[i] = detail::reaches_walls(run, i, x, run.shells.template radius<equal>(run.swarm, i));
  }

  /// When balls i and j leave their shells.
  CAROM_INLINE static void set_exits(Run& run, std::uint32_t i, std::uint32_t j) {
    const Flight<D>&a = run.swarm.flights[i], &b = run.swarm.flights[j];
    const Lanes va = load_vector<D>(a.v), vb = load_vector<D>(b.v);
    const Lanes ua = run.shells.template from_centre<equal>(i, load_vector<D>(a.x) + va * elapsed(a.time(), run.clock));
    const Lanes ub = run.shells.template from_centre<equal>(j, load_vector<D>(b.x) + vb * elapsed(b.time(), run.clock));
    // |u + v t|^2 = radius^2, of both: q t^2 + 2 p t = c.
    const Lanes pq = sums(va * va, vb * vb, ua * va, ub * vb), uu = sums(ua * ua, ub * ub, ua, ub);
    const Lanes q = __builtin_shufflevector(pq, pq, 0, 1, 0, 1), p = __builtin_shufflevector(pq, pq, 2, 3, 2, 3);
    const double radius_a = run.shells.template radius<equal>(run.swarm, i);
    const double radius_b = equal ? radius_a : run.shells.template radius<equal>(run.swarm, j);
    const double square_a = radius_a * radius_a, square_b = radius_b * radius_b;
    const Lanes c = Lanes{square_a, square_b, square_a, square_b} - uu, root = sqrt(p * p + q * c);
    const LaneMask outward = p > 0.0;
    const Lanes flight = (outward ? c : root - p) / (outward ? p + root : q);
    for (int k = 0; k < 2; ++k) {
      constexpr double far = 0x1p60;
      const double t = run.clock.offset + flight[k];
      std::int64_t& exit = run.shells.slots[k == 0 ? i : j].exit;
      exit = run.clock.epoch + static_cast<std::int64_t>(t < far ? t : far);  // at rest it is a NaN
      if (!(c[k] > 0)) exit = run.clock.epoch;
    }
  }
};

}  // namespace carom
