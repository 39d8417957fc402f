#pragma once
// What comes next in the loop of few balls: flights to partners and walls, by plain arithmetic where that settles them.

#include <cmath>
#include <cstdint>

#include "carom/predict/lattice_ray.hpp"
#include "carom/sim/few_run.hpp"
#include "carom/solve/quadratic.hpp"

namespace carom {

/// `Target` is the instruction set that this is compiled for: a name of its own keeps the versions apart.
template <int D, class Target, bool periodic>
class FewFlights {
 public:
  using Run = FewRun<D>;
  using Ball = carom::Ball<double, D>;

  /// All that may happen to ball i, which has just hit `hit` (itself: a wall).
  CAROM_INLINE static void look(Run& run, std::uint32_t i, std::uint32_t hit) {
    const double now = now_since_base(run);
    if constexpr (periodic) {
      if (run.slot_of[i][i] != Run::no_slot) look_at_walls_of_periods(run, i, i == hit, now);
      for (std::uint32_t k = 0; k < run.other_count[i]; ++k) {
        const std::uint32_t j = run.others[i][k];
        if (j == hit && i > hit) continue;  // seen from the other
        look_along(run, run.slot_of[i][j], i, j, j == hit, now);
      }
    } else {
      if (run.slot_of[i][i] != Run::no_slot) look_at_walls(run, i, i == hit, now);
      for (std::uint32_t k = 0; k < run.other_count[i]; k += lanes) look_at_four(run, i, k, hit, now);
    }
  }

 private:
  /// `since`: the moment now, from which the flight is.
  CAROM_INLINE static void set(Run& run, std::uint32_t s, double flight, double since) {
    run.flight[s] = flight;
    run.due[s] = since + flight;
  }
  CAROM_INLINE static double now_since_base(const Run& run) {
    return static_cast<double>(run.now.epoch - run.base) + run.now.offset;
  }

  /// Four of the partners of ball i, none of which was written at the moment now but `hit`.
  CAROM_INLINE static void look_at_four(Run& run, std::uint32_t i, std::uint32_t from, std::uint32_t hit, double now) {
    const Ball* const balls = run.world->balls.data();
    const Ball& own = balls[i];
    const std::uint32_t* const j = run.others[i].data() + from;
    const Ball &b0 = balls[j[0]], &b1 = balls[j[1]], &b2 = balls[j[2]], &b3 = balls[j[3]];
    const auto epochs = [&own](const Ball& ball) { return static_cast<double>(own.time.epoch - ball.time.epoch); };
    const Lanes epoch = {epochs(b0), epochs(b1), epochs(b2), epochs(b3)};
    const Lanes offset = {b0.time.offset, b1.time.offset, b2.time.offset, b3.time.offset};
    Lanes r[D], g[D];
    for (int k = 0; k < D; ++k) {
      r[k] = Lanes{b0.position[k], b1.position[k], b2.position[k], b3.position[k]};
      g[k] = Lanes{b0.velocity[k], b1.velocity[k], b2.velocity[k], b3.velocity[k]};
    }
    const Lanes lag = epoch + (spread(own.time.offset) - offset);
    for (int k = 0; k < D; ++k) {
      r[k] = (r[k] + g[k] * lag) - own.position[k];
      g[k] = g[k] - own.velocity[k];
    }
    int open;
    const Lanes flight = flights(r, g, load(run.sigma[i].data() + from), open);
    for (int m = 0; m < lanes && from + static_cast<std::uint32_t>(m) < run.other_count[i]; ++m) {
      const std::uint32_t s = run.slot_of[i][j[m]];
      if (j[m] == hit) {  // not again before one of them is hit
        set(run, s, never<double>(), now);
      } else if ((open >> m & 1) != 0) {
        detail::predict_pair(run, s);
      } else {
        set(run, s, flight[m], now);
      }
    }
  }

  /// meet_time in every lane; the bits of `open` are those of lanes that plain arithmetic does not settle.
  CAROM_INLINE static Lanes flights(const Lanes (&r)[D], const Lanes (&g)[D], const Lanes& sigma, int& open) {
    Lanes b = r[0] * g[0], rr = r[0] * r[0], a = g[0] * g[0], cross;
    for (int k = 1; k < D; ++k) {
      b += r[k] * g[k];
      rr += r[k] * r[k];
      a += g[k] * g[k];
    }
    if constexpr (D == 2) {
      const Lanes z = r[0] * g[1] - r[1] * g[0];
      cross = z * z;
    } else {
      const Lanes cx = r[1] * g[2] - r[2] * g[1], cy = r[2] * g[0] - r[0] * g[2], cz = r[0] * g[1] - r[1] * g[0];
      cross = cx * cx + cy * cy + cz * cz;
    }
    const Lanes ss = sigma * sigma, ass = a * ss, c = rr - ss, d = ass - cross;
    const LaneMask parting = (b >= 0.0) & (rr > carom::detail::apart * ss);
    const LaneMask far = c > carom::detail::near_contact * ss;
    const LaneMask passing = far & (-d > carom::detail::no_root * (a * rr) + carom::detail::no_underflow);
    const LaneMask meeting = far & (d > carom::detail::near_grazing * ass + carom::detail::no_underflow) & ~parting;
    open = sign_bits(~(parting | passing | meeting));
    const Lanes t = c / (sqrt(d) - b);
    return meeting ? t : spread(never<double>());
  }

  /// Balls i and j in a periodic space, of which i was written just now: four columns of images at a time. `again`: so was j,
  /// and they are in contact.
  CAROM_INLINE static void look_along(Run& run, std::uint32_t s, std::uint32_t i, std::uint32_t j, bool again, double now) {
    const Ball* const balls = run.world->balls.data();
    typename Run::Slot& slot = run.slot[s];
    const Ball &own = balls[i], &other = balls[j];
    const double lag = elapsed(other.time, own.time), sign = i < j ? 1.0 : -1.0;
    double r[D], g[D], speed = 0;
    for (int k = 0; k < D; ++k) {
      r[k] = sign * ((other.position[k] + other.velocity[k] * lag) - own.position[k]);
      g[k] = sign * (other.velocity[k] - own.velocity[k]);
      speed += std::fabs(g[k]);
    }
    slot.settled = true;
    if (speed == 0) return set(run, s, never<double>(), now);
    const LatticeRay<D> ray(r, g, slot.pair.sigma, run.edge, run.per_edge);
    const Contact<D>* const contact = again ? run.world->details[i].contacts.data() : nullptr;
    double column = ray.first();
    for (int batch = 0; batch < 2; ++batch, column += lanes) {
      const Lanes columns = Lanes{0, 1, 2, 3} + column;
      Lanes row[D], best = spread(never<double>()), image[D];
      for (int k = 0; k < D; ++k) {
        row[k] = k == ray.axis ? ray.sense * columns : ray.row(k, columns);
        image[k] = spread(0);
      }
      int open = 0;  // columns with what is not settled
      for (int corner = 0; corner < 1 << (D - 1); ++corner) {
        Lanes n[D], at[D], v[D];
        int bit = 0, unsettled;
        LaneMask touching = LaneMask{} - 1;
        for (int k = 0; k < D; ++k) {
          n[k] = row[k] + (k == ray.axis ? 0.0 : static_cast<double>(corner >> bit & 1));
          bit += k != ray.axis;
          at[k] = r[k] + n[k] * run.edge[k];
          v[k] = spread(g[k]);
          if (again) touching = touching & (n[k] == static_cast<double>(i < j ? contact->image[k] : -contact->image[k]));
        }
        Lanes t = flights(at, v, spread(slot.pair.sigma), unsettled);
        if (again) {
          unsettled &= ~sign_bits(touching);
          t = touching ? spread(never<double>()) : t;
        }
        open |= unsettled;
        const LaneMask sooner = t < best;
        best = sooner ? t : best;
        for (int k = 0; k < D; ++k) image[k] = sooner ? n[k] : image[k];
      }
      // Columns do not overlap: what is met in a later one comes later.
      if (open != 0) {
        const unsigned meeting = static_cast<unsigned>(sign_bits(best < never<double>()));
        const unsigned until_then = (meeting & -meeting) * 2 - 1;
        if ((static_cast<unsigned>(open) & until_then) != 0) return detail::predict_pair(run, s);
      }
      const double flight = least_of(best)[0];
      if (flight < never<double>()) {
        const int m = __builtin_ctz(static_cast<unsigned>(sign_bits(best == flight)) | 16u) & 3;
        for (int k = 0; k < D; ++k) slot.image[k] = static_cast<std::int32_t>(image[k][m]);
        return set(run, s, flight, now);
      }
    }
    slot.settled = false;
    slot.column = column;
    set(run, s, ray.entry(slot.column), now);
  }

  /// `hit`: ball i has just hit the wall that stands in its entry, of a periodic space.
  CAROM_INLINE static void look_at_walls_of_periods(Run& run, std::uint32_t i, bool hit, double now) {
    run.slot[run.slot_of[i][i]].settled = true;
    if constexpr (D == 2) {
      if (hit && look_from_circle(run, i, now)) return;
    }
    detail::predict_walls(run, i);
  }

  /// Ball i leaves the circle that stands in its entry. False if plain arithmetic does not settle what it meets first.
  CAROM_INLINE static bool look_from_circle(Run& run, std::uint32_t i, double now) {
    typename Run::Wall& wall = run.wall[i];
    if (wall.which == Run::some_wall || run.other_walls) return false;
    const Ball& ball = run.world->balls[i];
    const NextCircles::Range range =
        run.next_circles[run.circles_of[i]].from(wall.which - 2 * D, run.world->details[i].contacts[0].image, ball.velocity);
    const double aa = ball.velocity[0] * ball.velocity[0] + ball.velocity[1] * ball.velocity[1];
    double first = never<double>();
    const FourCircles* of = nullptr;
    int at = 0;
    for (const FourCircles* four = range.begin; four != range.end; ++four) {
      const Lanes r[2] = {ball.position[0] - load(four->x), ball.position[1] - load(four->y)};
      const Lanes v[2] = {spread(ball.velocity[0]), spread(ball.velocity[1])};
      int open;
      Lanes t = flights(r, v, load(four->sigma), open);
      for (; open != 0; open &= open - 1) {
        const int m = __builtin_ctz(static_cast<unsigned>(open));
        t[m] = detail::flight_to_circle(ball, four->x[m], four->y[m], four->sigma[m]);
      }
      const double least = least_of(t)[0];
      if (least < never<double>()) {
        // Two that may end at one tick of the clock are left to the order of events.
        const double doubt = 0x1p-51 + 0x1p-50 * least;
        const unsigned near = static_cast<unsigned>(sign_bits(t <= least + doubt));
        if ((near & (near - 1)) != 0 || std::fabs(first - least) <= doubt) return false;
        if (least < first) {
          first = least;
          of = four;
          at = __builtin_ctz(near);
        }
      }
      if (first * first * aa < four->within) {
        wall.which = 2 * D + of->row[at];
        wall.image[0] = of->image[at][0];
        wall.image[1] = of->image[at][1];
        wall.centre[0] = of->x[at];
        wall.centre[1] = of->y[at];
        wall.tied = false;
        set(run, run.slot_of[i][i], first, now);
        return true;
      }
    }
    return false;
  }

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
      wall.event = detail::first_other_wall(run, i);
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
    const double a = dot<double, D>(v, v), ass = a * ss, d = ass - cross_squared<double, D>(r, v);
    if (c > carom::detail::near_contact * ss) {
      if (-d > carom::detail::no_root * (a * rr) + carom::detail::no_underflow) return never<double>();
      if (d > carom::detail::near_grazing * ass + carom::detail::no_underflow) return c / (__builtin_sqrt(d) - b);
    }
    return detail::flight_to_sphere(run, i, n);
  }
};

}  // namespace carom
