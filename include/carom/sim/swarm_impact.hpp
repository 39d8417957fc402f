#pragma once
// The elastic impact of two balls of a swarm: that of law/impact.hpp for e = 1 and finite masses, with the same bits.
//
// All components at a time. Between balls that are all alike the short way of law/elastic.hpp is certain, or else the whole
// evaluation follows, without what adding zero and scaling by powers of two would compute.

#include <algorithm>
#include <bit>
#include <cmath>

#include "carom/core/wide_lanes.hpp"
#include "carom/law/elastic.hpp"
#include "carom/sim/swarm_run.hpp"

namespace carom {

/// `Target`: see SwarmLoop.
template <int D, class Target, bool periodic, bool equal>
class SwarmImpact {
 public:
  using Run = SwarmRun<D>;

  [[gnu::noinline, gnu::flatten]] static void collide(Run& run, std::uint32_t i, std::uint32_t j, const Time<double>& t) {
    Flight<D>&a = run.swarm.flights[i], &b = run.swarm.flights[j];
    Past&pa = run.swarm.past[i], &pb = run.swarm.past[j];
    if (run.sink != nullptr) run.before = {a, b, (pa.flags & Past::hit) != 0, (pb.flags & Past::hit) != 0};
    const Lanes va = load_vector<D>(a.v), vb = load_vector<D>(b.v);
    const Lanes xa = load_vector<D>(a.x) + va * elapsed(a.time(), t), xb = load_vector<D>(b.x) + vb * elapsed(b.time(), t);
    WideLanes r = two_diff(xb, xa);
    Lanes image = {};
    if constexpr (periodic) {
      const Lanes edge = load_vector<D>(run.swarm.edge);
      image = nearest_integer((xa - xb) * load_vector<D>(run.swarm.per_edge));
      const LaneMask moved = image != 0.0;
      if (sign_bits(moved) != 0) {
        const WideLanes there = r + two_prod(image, edge);
        r = {moved ? there.hi : r.hi, moved ? there.lo : r.lo};
      }
    }
    Lanes ua, ub;
    double excess;
    const bool certain = equal && elastic_impact<D>(run.pair, r, va, vb, ua, ub, excess) && is_known(run, excess);
    if (!certain) [[unlikely]]
      resolve(run, i, j, r, va, vb, ua, ub);
    int turns[D] = {};
    write(run, i, xa, ua, t, turns, -1);
    write(run, j, xb, ub, t, turns, 1);
    int image_ab[D], image_ba[D];
    for (int k = 0; k < D; ++k) {
      image_ab[k] = static_cast<int>(image[k]) + turns[k];
      image_ba[k] = -image_ab[k];
    }
    remember(pa, pb.number, run.swarm.stamp[j], packed_image<D>(image_ab));
    remember(pb, pa.number, run.swarm.stamp[i], packed_image<D>(image_ba));
    ++run.counts.ball_ball;
    if (sign_bits(LaneMask(((ua - ua) == 0.0) & ((ub - ub) == 0.0))) != 15) run.verdict = Halt::non_finite;
    if (run.sink != nullptr) {
      alignas(32) double images[lanes];
      *reinterpret_cast<Lanes*>(images) = image;
      detail::report_collision(run, i, j, t, images);
    }
  }

 private:
  /// As resolve_impact in law/impact.hpp.
  [[gnu::noinline, gnu::flatten]] static void resolve(Run& run, std::uint32_t i, std::uint32_t j, const WideLanes& r,
                                                      const Lanes& va, const Lanes& vb, Lanes& ua, Lanes& ub) {
    const WideLanes dots = sums_in_order<D>(two_diff(va, vb) * r, r * r);  // g.r, r.r
    const DoubleDouble gr = dots[0], rr = dots[1];
    note_gap(run, rr, run.swarm.template radius_of<equal>(i) + run.swarm.template radius_of<equal>(j));
    ua = va;
    ub = vb;
    if (narrow(gr) > 0) {
      const double ma = run.swarm.template kind<equal>(i).mass, mb = run.swarm.template kind<equal>(j).mass;
      if (equal || ma == mb) {  // 2 gr / rr, and half of it for each
        const WideLanes change = spread(gr / rr) * r;
        ua = rounded_sum(va, -change);
        ub = rounded_sum(vb, change);
      } else {
        using W = DoubleDouble;
        const WideLanes change = spread(W(2 * gr.hi, 2 * gr.lo) / rr) * r;
        ua = rounded_sum(va, -(spread(W(mb) / (W(ma) + W(mb))) * change));
        ub = rounded_sum(vb, spread(W(ma) / (W(mb) + W(ma))) * change);
      }
    }
  }

  CAROM_INLINE static void remember(Past& past, std::uint32_t partner, std::uint32_t partner_stamp, std::uint8_t image) {
    past.flags = Past::hit | Past::in_contact;
    past.contact_image = image;
    past.last_partner = partner;
    past.last_feature = 0;
    past.partner_stamp = partner_stamp;
  }

  /// The motion of ball i changes at t: its place is stored, wrapped. Adds side * (periods taken out) to `turns`.
  CAROM_INLINE static void write(Run& run, std::uint32_t i, const Lanes& x, const Lanes& v, const Time<double>& t, int (&turns)[D],
                                 int side) {
    Flight<D>& ball = run.swarm.flights[i];
    // In two stores, of what the next predictions read at once: a load that must wait for several stores waits long.
    const Lanes time = {std::bit_cast<double>(t.epoch), t.offset, 0.0, 0.0};
    StoredLanes* const line = reinterpret_cast<StoredLanes*>(&ball);
    if constexpr (D == 3) {
      line[0] = __builtin_shufflevector(x, v, 0, 1, 2, 4);
      line[1] = __builtin_shufflevector(v, time, 1, 2, 4, 5);
    } else {
      line[0] = __builtin_shufflevector(x, v, 0, 1, 4, 5);
      line[1] = time;
    }
    ++run.swarm.stamp[i];
    if constexpr (periodic) {
      const Lanes share = (x - load_vector<D>(run.swarm.lower)) * load_vector<D>(run.swarm.per_edge);
      // Well within, the quotient's floor is 0 and nothing is to be done.
      const int within = sign_bits(LaneMask((share > 0x1p-50) & (share < 1 - 0x1p-50)));
      constexpr int all = (1 << D) - 1;
      if ((within & all) != all) [[unlikely]]
        for (int k = 0; k < D; ++k) {
          const int n = detail::wrap_coordinate(run.swarm.lower[k], run.swarm.edge[k], ball.x[k]);
          run.swarm.past[i].image[k] += n;
          turns[k] += side * n;
        }
    }
  }

  /// r.r - sigma^2 means no larger gap than has been noted: it is 2 sigma times the gap, and 1.96 is below what rounding
  /// leaves of the 2.
  CAROM_INLINE static bool is_known(const Run& run, double excess) {
    const double sigma = run.pair.sigma;
    return std::fabs(excess) <
           1.96 * sigma * std::min(run.exactness.max_gap_error, run.exactness.max_gap_error_relative * sigma);
  }

  /// The gap that was left, |r| - sigma, if it is the largest so far: (r.r - sigma^2) / (|r| + sigma), where |r| + sigma is
  /// close to 2 sigma.
  CAROM_INLINE static void note_gap(Run& run, const DoubleDouble& rr, double sigma) {
    const double excess = narrow(rr - two_prod(sigma, sigma));
    const double size = excess < 0 ? -excess : excess;
    if (size < run.exactness.max_gap_error * sigma && size < run.exactness.max_gap_error_relative * sigma * sigma) return;
    const double gap = size / (__builtin_sqrt(narrow(rr)) + sigma);
    if (gap > run.exactness.max_gap_error) run.exactness.max_gap_error = gap;
    if (gap > run.exactness.max_gap_error_relative * sigma) run.exactness.max_gap_error_relative = gap / sigma;
  }
};

}  // namespace carom
