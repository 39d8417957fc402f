#pragma once
// Which wall comes next in the loop of few balls: by plain arithmetic where that settles it.

#include <cmath>
#include <cstdint>

#include "carom/sim/few_meetings.hpp"

namespace carom {

/// `Target` is the instruction set that this is compiled for: a name of its own keeps the versions apart.
template <int D, class Target>
class FewWallFlights : FewMeetings<D, Target> {
  using Meetings = FewMeetings<D, Target>;
  using Meetings::set;

 public:
  using Run = FewRun<D>;
  using Ball = carom::Ball<double, D>;

  /// `hit`: ball i has just hit the wall that stands in its entry.
  CAROM_INLINE static void look_at_walls(Run& run, std::uint32_t i, bool hit, double now) {
    const Ball& ball = run.world->balls[i];
    typename Run::Wall& wall = run.wall[i];
    const std::uint32_t s = run.slot_of[i][i], last = wall.which;
    double first = never<double>(), second = never<double>();
    std::uint32_t which = 0;
    const auto offer = [&](double t, std::uint32_t w) {
      const bool less = t < first;
      const double loser = less ? first : t;
      second = loser < second ? loser : second;
      which = less ? w : which;
      first = less ? t : first;
    };
    for (int k = 0; k < D; ++k) {
      const double v = ball.velocity[k];
      const int side = v > 0;
      const double face = run.face[static_cast<std::size_t>(2 * k + side)];
      const double gap = (side != 0 ? face - ball.position[k] : ball.position[k] - face) - ball.radius;
      const double speed = std::fabs(v), flight = gap > 0 ? gap / speed : 0.0;
      offer(speed > 0 ? flight : never<double>(), static_cast<std::uint32_t>(2 * k + side));
    }
    for (std::uint32_t n = 0; n < run.spheres.size(); ++n)
      offer(flight_to_sphere(run, i, n, hit && last == 2 * D + n), 2 * D + n);
    if (run.other_walls) {
      detail::find_other_wall(run, i);
      if (wall.event.kind != EventKind::none) {
        offer(elapsed(ball.time, wall.event.time), Run::some_wall);
      }
    }
    // Two that may end at one tick of the clock are left to the order of events.
    if (second < never<double>() && !(second - first > 0x1p-51 + 0x1p-50 * first)) return detail::predict_walls(run, i);
    wall.which = which;
    wall.tied = false;
    set(run, s, first, now);
  }

  /// `hit`: ball i has just hit the wall that stands in its entry, of a periodic space.
  CAROM_INLINE static void look_at_walls_of_periods(Run& run, std::uint32_t i, bool hit, double now) {
    run.slot[run.slot_of[i][i]].settled = true;
    if constexpr (D == 2) {
      if (hit && look_from_circle(run, i, now)) return;
    }
    detail::predict_walls(run, i);
  }

 private:
  /// Ball i leaves the circle that stands in its entry. False if that does not settle which wall it meets first.
  CAROM_INLINE static bool look_from_circle(Run& run, std::uint32_t i, double now) {
    typename Run::Wall& wall = run.wall[i];
    if (run.next_circles.empty()) {
      detail::miss_circles(run);
      return false;
    }
    if (wall.which == Run::some_wall || run.other_walls) return false;
    const Ball& ball = run.world->balls[i];
    const NextCircles& next = run.next_circles[run.circles_of[i]];
    const auto exact = [&ball](const FourCircles& four, int n) {
      return detail::flight_to_circle(ball, four.x[n], four.y[n], four.sigma[n]);
    };
    typename Meetings::Found found;
    if (!Meetings::template first_of_list<NextCircles::Of::walls>(
            next.from(wall.which - 2 * D, run.world->details[i].contacts[0].image, ball.velocity), ball, exact, found))
      return false;
    wall.which = 2 * D + found.four->row[found.at];
    for (int k = 0; k < 2; ++k) wall.image[k] = found.four->image[found.at][k];
    wall.centre[0] = found.four->x[found.at];
    wall.centre[1] = found.four->y[found.at];
    wall.tied = false;
    set(run, run.slot_of[i][i], found.flight, now);
    return true;
  }

  CAROM_INLINE static double flight_to_sphere(const Run& run, std::uint32_t i, std::uint32_t n, bool hit) {
    const Ball& ball = run.world->balls[i];
    const auto& sphere = run.world->walls.spheres[run.spheres[n]];
    Vec<double, D> r, v;
    for (int k = 0; k < D; ++k) {
      r[k] = ball.position[k] - sphere.centre[k];
      v[k] = ball.velocity[k];
    }
    const double b = dot<double, D>(r, v), rr = dot<double, D>(r, r);
    if (sphere.inside) {
      const double rho = sphere.radius - ball.radius, a = dot<double, D>(v, v), ss = rho * rho, depth = ss - rr;
      const double d = a * ss - cross_squared<double, D>(r, v);
      if (d > carom::detail::near_grazing * (a * ss) + carom::detail::no_underflow) {
        if (b < 0.0 && depth > -ss) return (__builtin_sqrt(d) - b) / a;
        if (!hit && !(b < 0.0) && depth > carom::detail::near_contact * ss) return depth / (b + __builtin_sqrt(d));
      }
      return detail::flight_to_sphere(run, i, n);
    }
    if (hit) return never<double>();
    const double sigma = sphere.radius + ball.radius, ss = sigma * sigma, c = rr - ss;
    if (b >= 0.0 && rr > carom::detail::apart * ss) return never<double>();
    const double a = dot<double, D>(v, v), d = a * ss - cross_squared<double, D>(r, v);
    double t;
    return carom::detail::meet_plainly(b, c, ss, d, a * rr, t) ? t : detail::flight_to_sphere(run, i, n);
  }
};

}  // namespace carom
