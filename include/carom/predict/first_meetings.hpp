#pragma once
// The first two of all meetings of one ball with those around it: four pairs at a time, with the bits of a pair alone.

#include <cstdint>

#include "carom/core/lanes.hpp"
#include "carom/solve/quadratic.hpp"
#include "carom/world/swarm.hpp"

namespace carom {

/// Flights of a ball to its two first meetings, and to what comes third, from the moment that it was written.
struct FirstMeetings {
  static constexpr std::uint32_t nobody = ~std::uint32_t{0};

  double flight[3] = {never<double>(), never<double>(), never<double>()};
  std::uint32_t partner[2] = {nobody, nobody};

  CAROM_INLINE void offer(double t, std::uint32_t j) {
    if (!(t < flight[2])) return;
    if (t < flight[1]) {
      flight[2] = flight[1];
      if (t < flight[0]) {
        flight[1] = flight[0];
        partner[1] = partner[0];
        flight[0] = t;
        partner[0] = j;
      } else {
        flight[1] = t;
        partner[1] = j;
      }
    } else {
      flight[2] = t;
    }
  }

  /// Flights that may end at one tick of the clock, so that the order of events must say which is first: ticks are 2^-53
  /// apart, and rounding to them is monotone.
  [[nodiscard]] CAROM_INLINE bool undecided() const {
    constexpr double two_ticks = 0x1p-52;
    return (flight[1] < never<double>() && !(flight[1] - flight[0] > two_ticks)) ||
           (flight[2] < never<double>() && !(flight[2] - flight[1] > two_ticks));
  }
};

/// The flights of one ball to its meetings with a piece of its list; `never` for those that do not meet, and behind them.
struct MeetingTimes {
  static constexpr std::uint32_t most = 16;

  alignas(32) double flight[most];

  /// Offers the first two, and what is third, of flight[0 .. most) with the partners near[0 .. most).
  CAROM_INLINE void into(FirstMeetings& all, const std::uint32_t* near) const {
    const Lanes* const stored = reinterpret_cast<const Lanes*>(flight);
    Lanes t0 = stored[0], t1 = stored[1], t2 = stored[2], t3 = stored[3];
    const Lanes none = spread(never<double>());
    for (int turn = 0; turn < 3; ++turn) {
      const Lanes first = least_of(least(least(t0, t1), least(t2, t3)));
      if (!(first[0] < all.flight[2])) return;
      const int at = sign_bits(t0 == first) | sign_bits(t1 == first) << 4 | sign_bits(t2 == first) << 8 |
                     sign_bits(t3 == first) << 12;
      all.offer(first[0], near[__builtin_ctz(static_cast<unsigned>(at))]);
      if ((at & (at - 1)) != 0) all.offer(first[0], FirstMeetings::nobody);  // two at once
      t0 = t0 == first ? none : t0;
      t1 = t1 == first ? none : t1;
      t2 = t2 == first ? none : t2;
      t3 = t3 == first ? none : t3;
    }
  }
};

/// A pair that plain arithmetic does not settle (solve/quadratic.hpp: near contact, grazing).
template <int D>
struct OpenPair {
  double r[D], g[D];      ///< place and velocity of the partner relative to the ball
  double sigma;           ///< sum of the radii
  double bound;           ///< the flight to the meeting is at least so long
  std::uint32_t partner;
};

/// Looks at the pairs of ball i with near[0 .. count), where no stored time is later than that of ball i; what follows them
/// up to a multiple of four are rows too, whichever; `hit` is left out. The flights to the meetings are written; pairs that stay open are handed
/// to open(OpenPair) and have no meeting there.
template <int D, bool periodic, bool equal, class Open>
CAROM_INLINE void look_at(const Swarm<D>& swarm, std::uint32_t i, const std::uint32_t* near, std::uint32_t count,
                          std::uint32_t hit, double* flight, Open&& open) {
  const Flight<D>& own = swarm.flights[i];
  const Flight<D>* const flights = swarm.flights.data();
  Lanes x[D], v[D], edge[D], per_edge[D];
  for (int k = 0; k < D; ++k) {
    edge[k] = spread(swarm.edge[k]);
    per_edge[k] = spread(swarm.per_edge[k]);
    x[k] = spread(own.x[k]);
    v[k] = spread(own.v[k]);
  }
  const LaneMask own_epoch = LaneMask{} + own.epoch;
  const Lanes own_offset = spread(own.offset);
  const double own_radius = swarm.template kind<equal>(i).radius;
  Lanes sigma = spread(own_radius + own_radius);
  for (std::uint32_t from = 0; from < count; from += lanes) {
    const LaneMask place = LaneMask{0, 1, 2, 3} + static_cast<long long>(from);
    const LaneMask partner = {near[from], near[from + 1], near[from + 2], near[from + 3]};
    const LaneMask there = (place < static_cast<long long>(count)) & (partner != static_cast<long long>(hit));
    const std::uint32_t* const j = near + from;
    const double* const at[lanes] = {flights[j[0]].x, flights[j[1]].x, flights[j[2]].x, flights[j[3]].x};
    Lanes r[D], g[D];
    Lanes c0 = load(at[0]), c1 = load(at[1]), c2 = load(at[2]), c3 = load(at[3]);
    transpose(c0, c1, c2, c3);
    Lanes c4 = load(at[0] + lanes), c5 = load(at[1] + lanes), c6 = load(at[2] + lanes), c7 = load(at[3] + lanes);
    transpose(c4, c5, c6, c7);
    Lanes epoch_bits, offset;
    if constexpr (D == 3) {
      r[0] = c0, r[1] = c1, r[2] = c2;
      g[0] = c3, g[1] = c4, g[2] = c5;
      epoch_bits = c6, offset = c7;
    } else {
      r[0] = c0, r[1] = c1;
      g[0] = c2, g[1] = c3;
      epoch_bits = c4, offset = c5;
    }
    if constexpr (!equal)
      for (int k = 0; k < lanes; ++k) sigma[k] = own_radius + swarm.kind(j[k]).radius;

    const Lanes lag = to_double(own_epoch - __builtin_bit_cast(LaneMask, epoch_bits)) + (own_offset - offset);
    for (int k = 0; k < D; ++k) {
      r[k] = (r[k] + g[k] * lag) - x[k];
      if constexpr (periodic) {
        const Lanes image = nearest_integer(-r[k] * per_edge[k]);
        r[k] = r[k] + image * edge[k];
      }
      g[k] = g[k] - v[k];
    }
    Lanes b = r[0] * g[0], rr = r[0] * r[0], a = g[0] * g[0];
    for (int k = 1; k < D; ++k) {
      b += r[k] * g[k];
      rr += r[k] * r[k];
      a += g[k] * g[k];
    }
    Lanes cross;
    if constexpr (D == 2) {
      const Lanes z = r[0] * g[1] - r[1] * g[0];
      cross = z * z;
    } else {
      const Lanes cx = r[1] * g[2] - r[2] * g[1], cy = r[2] * g[0] - r[0] * g[2], cz = r[0] * g[1] - r[1] * g[0];
      cross = cx * cx + cy * cy + cz * cz;
    }
    const Lanes ss = sigma * sigma, ass = a * ss, c = rr - ss, d = ass - cross;
    const LaneMask parting = (b >= 0.0) & (rr > detail::apart * ss);
    const LaneMask far = c > detail::near_contact * ss;
    const LaneMask passing = far & (-d > detail::no_root * (a * rr) + detail::no_underflow);
    const LaneMask meeting = far & (d > detail::near_grazing * ass + detail::no_underflow) & ~parting & there;
    int left = sign_bits(there & ~(parting | passing | meeting));
    const Lanes t = c / (sqrt(d) - b);
    *reinterpret_cast<Lanes*>(flight + from) = meeting ? t : spread(never<double>());
    while (left != 0) {
      const int k = __builtin_ctz(static_cast<unsigned>(left));
      left &= left - 1;
      OpenPair<D> pair;
      for (int m = 0; m < D; ++m) {
        pair.r[m] = r[m][k];
        pair.g[m] = g[m][k];
      }
      pair.sigma = sigma[k];
      pair.partner = j[k];
      // c / (sqrt(d) - b) with more in the place of d than rounding can have taken from it, where c is far from rounding.
      pair.bound = c[k] > detail::near_contact * ss[k] && b[k] < 0
                       ? 0.99 * c[k] / (__builtin_sqrt(2 * detail::near_grazing * ass[k] + detail::no_underflow) - b[k])
                       : 0.0;
      open(pair);
    }
  }
}

/// Relative place of balls i and j at the later of their stored times, where `now` tells their images apart: they are
/// neighbours then.
template <int D, bool periodic>
CAROM_INLINE Time<double> pair_state(const Swarm<D>& swarm, std::uint32_t i, std::uint32_t j, const Time<double>& now,
                                     double (&r)[D], double (&g)[D], double (&image)[D]) {
  const Flight<D>&a = swarm.flights[i], &b = swarm.flights[j];
  const double lag = elapsed(a.time(), b.time());
  const double lag_a = lag > 0 ? lag : 0, lag_b = lag < 0 ? -lag : 0;
  const double to_now_a = elapsed(a.time(), now), to_now_b = elapsed(b.time(), now);
  for (int k = 0; k < D; ++k) {
    const double xa = lag > 0 ? a.x[k] + a.v[k] * lag_a : a.x[k], xb = lag < 0 ? b.x[k] + b.v[k] * lag_b : b.x[k];
    r[k] = xb - xa;
    if constexpr (periodic) {
      const double edge = swarm.edge[k];
      const double apart = (a.x[k] + a.v[k] * to_now_a) - (b.x[k] + b.v[k] * to_now_b);
      image[k] = nearest_integer(apart * swarm.per_edge[k]);
      r[k] = r[k] + image[k] * edge;
    } else {
      image[k] = 0;
    }
    g[k] = b.v[k] - a.v[k];
  }
  return lag > 0 ? b.time() : a.time();
}

}  // namespace carom
