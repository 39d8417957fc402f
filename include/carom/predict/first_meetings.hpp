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

  static constexpr double no_flight = 0x1p100;  ///< beyond the clock

  double flight[3] = {no_flight, no_flight, no_flight};
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
};

/// Flights in order that may end at one tick of the clock, so that the order of events must say which is first: ticks are
/// 2^-53 apart, and rounding to them is monotone. Flights that differ in their last two bits alone may be here in any order.
[[nodiscard]] CAROM_INLINE bool undecided(double first, double second, double third) {
  constexpr double two_ticks = 0x1p-52, last_bits = 0x1p-50, none = FirstMeetings::no_flight;
  return ((second < none) & !(second - first > two_ticks + last_bits * second)) |
         ((third < none) & !(third - second > two_ticks + last_bits * third));
}

/// What decides whether a ball meets those in its list, for each of them, from the moment that the ball was written:
/// |r + g t|^2 = sigma^2 in the terms of solve/quadratic.hpp.
template <bool equal>
struct PairTermsOfList {
  static constexpr std::uint32_t most = 60;  ///< rows at a time

  alignas(32) double b[most + 4];  ///< r.g
  alignas(32) double rr[most + 4], a[most + 4], cross[most + 4];  ///< r.r, g.g, |r x g|^2
  alignas(32) double sigma[equal ? 4 : most + 4];                 ///< sums of the radii
  std::uint64_t candidates;  ///< bit k: near[k] comes nearer, or touches, and does not pass by
};

/// The terms of ball i with near[0 .. count), where no stored time is later than that of ball i; what follows them up to a
/// multiple of four (`groups` of them) are rows too, whichever. `reach` [length unit]: nobody in the list is further off than that.
template <int D, bool periodic, bool equal>
CAROM_INLINE void find_candidates(const Swarm<D>& swarm, std::uint32_t i, const std::uint32_t* near, std::uint32_t count,
                                  std::uint32_t groups, double reach, PairTermsOfList<equal>& terms) {
  const Flight<D>& own = swarm.flights[i];
  const Flight<D>* const flights = swarm.flights.data();
  Lanes x[D], v[D], edge[D], per_edge[D];
  for (int k = 0; k < D; ++k) {
    edge[k] = spread(swarm.edge[k]);
    per_edge[k] = spread(-swarm.per_edge[k]);
    x[k] = spread(own.x[k]);
    v[k] = spread(own.v[k]);
  }
  const LaneMask own_epoch = LaneMask{} + own.epoch;
  const Lanes own_offset = spread(own.offset);
  const double own_radius = swarm.template radius_of<equal>(i);
  // Rounding puts d off by no_root a r.r at most: what is further below 0 passes by.
  const double doubt = 4 * detail::no_root * (reach * reach);
  Lanes sigma = spread(own_radius + own_radius), ss = sigma * sigma;
  Lanes touching = detail::apart * ss, wide_ss = ss + doubt;
  std::uint64_t bits = 0;
  for (std::uint32_t group = 0; group < groups; ++group) {
    const std::uint32_t from = lanes * group;
    const std::uint32_t* const j = near + from;
    const double* const at[lanes] = {flights[j[0]].x, flights[j[1]].x, flights[j[2]].x, flights[j[3]].x};
    Lanes r[D], g[D];
    Lanes c0, c1, c2, c3, c4, c5, c6, c7;
    load_columns(at[0], at[1], at[2], at[3], c0, c1, c2, c3);
    load_columns(at[0] + lanes, at[1] + lanes, at[2] + lanes, at[3] + lanes, c4, c5, c6, c7);
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
    if constexpr (!equal) {
      for (int k = 0; k < lanes; ++k) sigma[k] = own_radius + swarm.radius[j[k]];
      ss = sigma * sigma;
      touching = detail::apart * ss;
      wide_ss = ss + doubt;
      *reinterpret_cast<Lanes*>(terms.sigma + from) = sigma;
    }
    const Lanes lag = to_double(own_epoch - __builtin_bit_cast(LaneMask, epoch_bits)) + (own_offset - offset);
    for (int k = 0; k < D; ++k) {
      r[k] = (r[k] + g[k] * lag) - x[k];
      if constexpr (periodic) r[k] = r[k] + nearest_integer(r[k] * per_edge[k]) * edge[k];
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
    *reinterpret_cast<Lanes*>(terms.b + from) = b;
    *reinterpret_cast<Lanes*>(terms.rr + from) = rr;
    *reinterpret_cast<Lanes*>(terms.a + from) = a;
    *reinterpret_cast<Lanes*>(terms.cross + from) = cross;
    const LaneMask nearing = std::bit_cast<LaneMask>(b) | (rr <= touching);
    const LaneMask hitting = cross <= a * wide_ss + detail::no_underflow;
    bits |= static_cast<std::uint64_t>(sign_bits(nearing & hitting)) << from;
  }
  terms.candidates = bits & ((std::uint64_t{1} << count) - 1);
}

/// The first meetings of some candidates, in order: four, of which the last is there to say what the third may be.
struct FirstFew {
  Lanes flight;        ///< no_flight: none
  LaneMask row;        ///< of the candidate; nobody where there is none
  LaneMask doubt;      ///< set: plain arithmetic does not settle this one, and `flight` is a bound below
  std::uint64_t left;  ///< bits of the candidates that have not been looked at

  CAROM_INLINE void put_in_order() {
    const LaneMask order = in_order(flight);
    flight = permuted(flight, order);
    row = permuted(row, order);
    doubt = permuted(doubt, order);
  }
  /// The first four of these and others.
  CAROM_INLINE void merge(const FirstFew& other) {
    const Lanes from_behind = __builtin_shufflevector(other.flight, other.flight, 3, 2, 1, 0);
    const LaneMask mine = flight <= from_behind;
    row = mine ? row : __builtin_shufflevector(other.row, other.row, 3, 2, 1, 0);
    doubt = mine ? doubt : __builtin_shufflevector(other.doubt, other.doubt, 3, 2, 1, 0);
    flight = mine ? flight : from_behind;
    left = other.left;
    put_in_order();
  }
};

/// The first four of the candidates whose bits are set. What plain arithmetic settles (solve/quadratic.hpp: neither near
/// contact nor grazing) is settled. `sigma`: the sum of two radii, where all are equal.
template <bool equal>
CAROM_INLINE FirstFew meet_four(const PairTermsOfList<equal>& terms, std::uint64_t candidates, const std::uint32_t* near,
                                double sigma) {
  constexpr std::uint32_t nothing = PairTermsOfList<equal>::most;
  std::uint32_t at[lanes];
  LaneMask row;
  std::uint64_t left = candidates;
  for (int k = 0; k < lanes; ++k) {
    at[k] = static_cast<std::uint32_t>(__builtin_ctzll(left | std::uint64_t{1} << nothing));
    row[k] = near[at[k] & (0U - (at[k] != nothing ? 1U : 0U))];
    left &= left - 1;
  }
  const auto chosen = [&at](const double* from) __attribute__((always_inline)) { return Lanes{from[at[0]], from[at[1]], from[at[2]], from[at[3]]}; };
  const LaneMask there = LaneMask{0, 1, 2, 3} < LaneMask{} + static_cast<long long>(__builtin_popcountll(candidates));
  const Lanes b = chosen(terms.b), rr = chosen(terms.rr), a = chosen(terms.a), cross = chosen(terms.cross);
  const Lanes sum = equal ? spread(sigma) : chosen(terms.sigma);
  const Lanes ss = sum * sum, c = rr - ss, d = a * ss - cross, scale = a * rr;
  // As meet_plainly. Where d is in doubt, more is put in its place than rounding can have taken from it; below so small a
  // share of the scale root * q never passes.
  const Lanes least_d = 0x1p-13 * scale + detail::no_underflow;
  const Lanes root = sqrt(d > least_d ? d : least_d), q = root - b, t = c / q;
  const LaneMask sure = (c > detail::near_meeting * ss) & LaneMask(detail::far_from_grazing(root, q, scale));
  const LaneMask coming = (b < 0.0) & there, parting = (b >= 0.0) & (rr > detail::apart * ss);
  const Lanes bound = coming & (c > 0x1p-40 * ss) ? 0.99 * t : Lanes{};  // c is off by 2^-11 of itself at most there
  const LaneMask none = parting | ~there, exact = sure & coming;
  FirstFew few;
  few.flight = none ? spread(FirstMeetings::no_flight) : exact ? t : bound;
  few.row = none ? LaneMask{} + FirstMeetings::nobody : row;
  few.doubt = ~(none | exact);
  few.left = left;
  few.put_in_order();
  return few;
}

/// All of these flights, none beyond 2^51, after t, as `after` in core/clock.hpp; no_flight: never.
CAROM_INLINE void after(const Time<double>& t, const Lanes& flight, LaneMask& epoch, Lanes& offset) {
  const LaneMask ends = flight < FirstMeetings::no_flight;
  const Lanes go = ends ? flight : Lanes{};
  const Lanes whole = floor(go), part = go - whole, past = part + (t.offset - 1), sum = t.offset + part;
  const LaneMask over = past >= 0.0, next = over | (sum >= 1.0);
  const Lanes off = over ? past : next ? Lanes{} : sum, on_grid = (off + 0.5) - 0.5;
  offset = off < 0.5 ? on_grid : off;
  const LaneMask sum_epoch = to_integer(whole) + t.epoch - next;
  epoch = ends ? sum_epoch : LaneMask{} + Time<double>::never().epoch;
  offset = ends ? offset : Lanes{};
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
