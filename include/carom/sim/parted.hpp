#pragma once
// Whether balls in a periodic space can meet anything at all: a proof for motions that repeat, so that a run need not wait for ever.

#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/motion/motion.hpp"
#include "carom/predict/ball_ball.hpp"
#include "carom/world/state.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// True if it is certain that no two balls will ever meet, nor any ball a wall, given that none did between `since` and
/// `now`; walls are at rest, as fixed balls are. A pair at relative rest keeps its distance. A pair whose relative velocity v is along one axis is
/// where it was, up to whole periods, after every edge / |v|: what did not meet in such a time never will. (Twice that is
/// asked for, so that rounding cannot matter.) Balls on circles are all where they were after every turn. Other pairs are not
/// judged.
template <Motion M>
[[nodiscard]] bool parted(const M& motion, const World<typename M::Real, M::dimension>& world,
                          const Time<typename M::Real>& since, const Time<typename M::Real>& now) {
  using Real = typename M::Real;
  using std::abs;
  const Real waited = elapsed(since, now);
  if constexpr (M::circular) return waited > 2 * ArcGap<Real>{motion.speed(), {}, {}, {}}.turn();
  const std::uint32_t n = static_cast<std::uint32_t>(world.balls.size());
  // The same way again and again, or no way at all.
  const auto repeats = [&](const Vec<Real, M::dimension>& v) {
    int moving = 0;
    for (int k = 0; k < M::dimension; ++k) {
      const Real speed = abs(v[k]);
      moving += speed > 0;
      if (speed > 0 && waited * speed < 2 * world.space.edge[k]) return false;
    }
    return moving <= 1;
  };
  if (!world.walls.empty())
    for (const auto& ball : world.balls)
      if (ball.alive && !ball.fixed && (M::accelerated || !repeats(ball.velocity))) return false;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = i + 1; j < n; ++j) {
      const auto &a = world.balls[i], &b = world.balls[j];
      if (!a.alive || !b.alive || (a.fixed && b.fixed)) continue;
      if (M::accelerated && a.fixed != b.fixed) return false;
      // Not from the velocities now, which in a long fall have lost what they differ by.
      if (!repeats(relative_state(motion, world, a, b, Image<M::dimension>{}).v)) return false;
    }
  return true;
}

}  // namespace carom
