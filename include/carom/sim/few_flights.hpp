#pragma once
// What comes next in the loop of few balls: by plain arithmetic where that settles it.

#include <cmath>
#include <cstdint>

#include "carom/predict/lattice_ray.hpp"
#include "carom/sim/few_wall_flights.hpp"

namespace carom {

/// `Target` is the instruction set that this is compiled for: a name of its own keeps the versions apart.
template <int D, class Target, bool periodic>
class FewFlights : FewMeetings<D, Target> {
  using Meetings = FewMeetings<D, Target>;
  using Walls = FewWallFlights<D, Target>;
  using Meetings::flights;
  using Meetings::set;

 public:
  using Run = FewRun<D>;
  using Ball = carom::Ball<double, D>;

  /// All that may happen to ball i, which has just hit `hit` (itself: a wall).
  CAROM_INLINE static void look(Run& run, std::uint32_t i, std::uint32_t hit) {
    const double now = Meetings::now_since_base(run);
    if constexpr (periodic) {
      const Ball* const balls = run.world->balls.data();
      if (run.slot_of[i][i] != Run::no_slot) Walls::look_at_walls_of_periods(run, i, i == hit, now);
      bool fixed_done = false;
      if constexpr (D == 2) fixed_done = balls[hit].fixed && look_from_fixed(run, i, hit, now);
      for (std::uint32_t k = 0; k < run.other_count[i]; ++k) {
        const std::uint32_t j = run.others[i][k];
        if (fixed_done && balls[j].fixed) continue;
        if (j == hit && (balls[i].fixed || (i > hit && !balls[hit].fixed))) continue;  // seen from the other
        look_along(run, run.slot_of[i][j], i, j, j == hit, now);
      }
    } else {
      if (run.slot_of[i][i] != Run::no_slot) Walls::look_at_walls(run, i, i == hit, now);
      for (std::uint32_t k = 0; k < run.other_count[i]; k += lanes) look_at_four(run, i, k, hit, now);
    }
  }

 private:
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

  /// Ball i leaves a fixed ball. Of all fixed balls it is certain which it meets first, and the others wait until then; or
  /// false.
  CAROM_INLINE static bool look_from_fixed(Run& run, std::uint32_t i, std::uint32_t hit, double now) {
    if (run.next_fixed.empty()) {
      detail::miss_fixed(run);
      return false;
    }
    const Ball& ball = run.world->balls[i];
    const NextCircles& next = run.next_fixed[run.circles_of[i]];
    const Contact<D>& contact = run.world->details[i].contacts[0];
    if (contact.party != Party::ball || contact.partner != hit) return false;
    const auto image_of = [&run, i](const FourCircles& four, int n) {
      const std::int32_t sign = i < run.fixed[four.row[n]] ? 1 : -1;
      Image<2> image;
      for (int k = 0; k < 2; ++k) image[k] = sign * four.image[n][k];
      return image;
    };
    const auto exact = [&](const FourCircles& four, int n) {
      return detail::flight_to_image(run, run.slot_of[i][run.fixed[four.row[n]]], image_of(four, n));
    };
    typename Meetings::Found found;
    if (!Meetings::template first_of_list<NextCircles::Of::balls>(next.from(run.fixed_row[hit], contact.image, ball.velocity), ball,
                                               exact, found))
      return false;
    for (const std::uint32_t j : run.fixed) set(run, run.slot_of[i][j], never<double>(), now);
    const std::uint32_t s = run.slot_of[i][run.fixed[found.four->row[found.at]]];
    run.slot[s].image = image_of(*found.four, found.at);
    run.slot[s].settled = true;
    set(run, s, found.flight, now);
    return true;
  }

};

}  // namespace carom
