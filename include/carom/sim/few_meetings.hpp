#pragma once
// What all predictions of the loop of few balls share: contact times in lanes, and the first of a list of circles.

#include <cmath>
#include <cstdint>

#include "carom/predict/next_circles.hpp"
#include "carom/sim/few_run.hpp"
#include "carom/solve/quadratic.hpp"

namespace carom {

/// `Target` is the instruction set that this is compiled for: a name of its own keeps the versions apart.
template <int D, class Target>
class FewMeetings {
 public:
  using Run = FewRun<D>;
  using Ball = carom::Ball<double, D>;

  /// `since`: the moment now, from which the flight is.
  CAROM_INLINE static void set(Run& run, std::uint32_t s, double flight, double since) {
    run.flight[s] = flight;
    run.due[s] = since + flight;
  }
  CAROM_INLINE static double now_since_base(const Run& run) {
    return static_cast<double>(run.now.epoch - run.base) + run.now.offset;
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
    const Lanes ss = sigma * sigma, c = rr - ss, d = a * ss - cross, scale = a * rr;
    const Lanes root = sqrt(d), q = root - b, t = c / q;
    const LaneMask parting = (b >= 0.0) & (rr > carom::detail::apart * ss);
    const LaneMask far = c > carom::detail::near_meeting * ss;
    const LaneMask passing = far & (-d > carom::detail::no_root * scale + carom::detail::no_underflow);
    const LaneMask meeting = far & LaneMask(carom::detail::far_from_grazing(root, q, scale)) & ~parting;
    open = sign_bits(~(parting | passing | meeting));
    return meeting ? t : spread(never<double>());
  }

  /// What a ball that leaves a circle meets first.
  struct Found {
    double flight = never<double>();
    const FourCircles* four = nullptr;
    int at = 0;
  };

  /// The first of a list that a ball at x with velocity v meets; exact(four, n) is the flight to one that plain arithmetic
  /// leaves open. False if the list does not settle it.
  template <NextCircles::Of of, class Exact>
  CAROM_INLINE static bool first_of_list(const NextCircles::Range& list, const Ball& ball, Exact&& exact, Found& found) {
    const double aa = ball.velocity[0] * ball.velocity[0] + ball.velocity[1] * ball.velocity[1];
    const Lanes g[2] = {spread(-ball.velocity[0]), spread(-ball.velocity[1])};
    const FourShifts* shift = list.shift;
    for (const FourCircles* four = list.begin; four != list.end; ++four) {
      Lanes r[2] = {load(four->x) - ball.position[0], load(four->y) - ball.position[1]};
      if constexpr (of == NextCircles::Of::balls) {
        r[0] += load(shift->x);
        r[1] += load(shift->y);
        ++shift;
      }
      int open;
      Lanes t = flights(r, g, load(four->sigma), open);
      for (; open != 0; open &= open - 1) {
        const int n = __builtin_ctz(static_cast<unsigned>(open));
        t[n] = exact(*four, n);
      }
      const double least = least_of(t)[0];
      if (least < never<double>()) {
        // Two that may end at one tick of the clock are left to the order of events.
        const double doubt = 0x1p-51 + 0x1p-50 * least;
        const unsigned near = static_cast<unsigned>(sign_bits(t <= least + doubt));
        if ((near & (near - 1)) != 0 || std::fabs(found.flight - least) <= doubt) return false;
        if (least < found.flight) found = {least, four, __builtin_ctz(near)};
      }
      if (found.flight * found.flight * aa < four->within) return true;
    }
    return false;
  }
};

}  // namespace carom
