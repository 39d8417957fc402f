#pragma once
// The elastic impact of two bodies whose masses and distance at contact are known beforehand: the velocities of
// resolve_impact, by a shorter way.

#include "carom/core/double_double.hpp"
#include "carom/core/lanes.hpp"
#include "carom/core/wide_lanes.hpp"
#include "carom/law/impact.hpp"

namespace carom {

/// What two bodies bring to every impact of theirs. Either may be of infinite mass and at rest.
struct ElasticPair {
  double sigma = 0;             ///< [length unit] distance of the centres at contact
  DoubleDouble square;          ///< sigma^2
  double per_square = 0;        ///< 1 / sigma^2
  DoubleDouble push_a, push_b;  ///< 2 s / sigma^2, s the share of the change of relative velocity that a body takes
  double doubt = 0;             ///< what two evaluations of a velocity differ by at most, over the speeds before
  DoubleDouble push;            ///< [mass unit / length unit^2] 2 mu / sigma^2, mu the reduced mass
  double push_doubt = 0;        ///< [mass unit / length unit] of the impulse over sigma, over the speeds before
};

/// Places of partners are known to 2^-105 of the lengths that they are differences of, `extent` at most.
[[nodiscard]] inline ElasticPair elastic_pair(double sigma, double ma, double mb, double extent) {
  ElasticPair pair;
  pair.sigma = sigma;
  pair.square = two_prod(sigma, sigma);
  pair.per_square = 1 / pair.square.hi;
  pair.push_a = detail::share(ma, mb) * DoubleDouble(2.0) / pair.square;
  pair.push_b = detail::share(mb, ma) * DoubleDouble(2.0) / pair.square;
  pair.doubt = 0x1p-88 + 0x1p-100 * (extent / sigma);
  const bool by_b = detail::infinite(ma);
  pair.push = (by_b ? DoubleDouble(mb) : detail::share(ma, mb) * DoubleDouble(ma)) * DoubleDouble(2.0) / pair.square;
  pair.push_doubt = 2 * pair.doubt * (by_b ? mb : ma) / sigma;
  return pair;
}

namespace detail {
/// Sums over the components, their high and low parts apart, not normalised.
struct ImpactSums {
  DoubleDouble gr, rr;  ///< g.r, r.r
  double speeds = 0;
};
template <int D>
[[nodiscard]] CAROM_INLINE ImpactSums impact_sums(const double* high, const double* low, const double* va, const double* vb) {
  ImpactSums sums;
  double g[D], g_low[D];
  for (int k = 0; k < D; ++k) {
    const DoubleDouble difference = two_diff(va[k], vb[k]);
    g[k] = difference.hi;
    g_low[k] = difference.lo;
    sums.speeds += std::fabs(va[k]) + std::fabs(vb[k]);
  }
  DoubleDouble &gr = sums.gr, &rr = sums.rr;
  gr = two_prod(g[0], high[0]);
  rr = two_prod(high[0], high[0]);
  gr.lo += g[0] * low[0] + g_low[0] * high[0];
  rr.lo += low[0] * (2 * high[0] + low[0]);
  for (int k = 1; k < D; ++k) {
    const DoubleDouble p = two_prod(g[k], high[k]), q = two_prod(high[k], high[k]);
    const DoubleDouble s = two_sum(gr.hi, p.hi), t = two_sum(rr.hi, q.hi);
    gr = {s.hi, (gr.lo + s.lo) + (p.lo + (g[k] * low[k] + g_low[k] * high[k]))};
    rr = {t.hi, (rr.lo + t.lo) + (q.lo + low[k] * (2 * high[k] + low[k]))};
  }
  return sums;
}

/// hi + lo rounded, if `doubt` on either side makes no difference.
[[nodiscard]] CAROM_INLINE bool rounds_alike(const DoubleDouble& x, double doubt, double& rounded) {
  rounded = x.hi + x.lo;
  return x.hi + (x.lo - doubt) == x.hi + (x.lo + doubt);
}
}  // namespace detail

/// The velocities after an elastic impact, if they are certainly those of resolve_impact; else false, and nothing is known.
/// r = high + low is the way from a's centre to b's, |low| <= 2^-50 of what it is a difference of. `excess` is r.r -
/// sigma^2.
///
/// r.r differs from sigma^2 by rounding only, so 1 / r.r = (1 - d) / sigma^2 with d = excess / sigma^2, and nothing is
/// divided [papers/impact.md, eq. 12]. High and low parts are not normalised on the way; the sum is rounded once, and taken
/// if all that lies within the errors of this evaluation and of the other is rounded to the same double [Ziv1991].
template <int D>
[[nodiscard]] CAROM_INLINE bool elastic_impact(const ElasticPair& pair, const double* high, const double* low, const double* va,
                                               const double* vb, double* after_a, double* after_b, double& excess) {
  const auto [gr, rr, speeds] = detail::impact_sums<D>(high, low, va, vb);
  excess = (rr.hi - pair.square.hi) + (rr.lo - pair.square.lo);
  const double d = excess * pair.per_square;
  const double doubt = pair.doubt * speeds;
  bool certain = gr.hi > doubt * pair.sigma && std::fabs(d) < 0x1p-46;
  const auto change = [&](const DoubleDouble& push, const double* v, double sign, double* after) {
    if (push.hi == 0) {  // of infinite mass
      for (int k = 0; k < D; ++k) after[k] = v[k];
      return;
    }
    DoubleDouble f = two_prod(gr.hi, push.hi);
    f.lo += (gr.hi * push.lo + gr.lo * push.hi) - f.hi * d;
    for (int k = 0; k < D; ++k) {
      const DoubleDouble p = two_prod(f.hi, high[k]);
      const DoubleDouble sum = two_sum(v[k], sign * p.hi);
      const double rest = sum.lo + sign * (p.lo + (f.hi * low[k] + f.lo * high[k]));
      after[k] = sum.hi + rest;
      certain = certain & (sum.hi + (rest - doubt) == sum.hi + (rest + doubt));
    }
  };
  change(pair.push_a, va, -1.0, after_a);
  if (after_b != nullptr) change(pair.push_b, vb, 1.0, after_b);
  return certain;
}

/// The same for two bodies of one finite mass, all components at a time; lanes from D on are 0.
template <int D>
[[nodiscard]] CAROM_INLINE bool elastic_impact(const ElasticPair& pair, const WideLanes& r, const Lanes& va,
                                               const Lanes& vb, Lanes& after_a, Lanes& after_b, double& excess) {
  const WideLanes g = two_diff(va, vb), p = two_prod(g.hi, r.hi), q = two_prod(r.hi, r.hi);
  const Lanes p_low = p.lo + (g.hi * r.lo + g.lo * r.hi), q_low = q.lo + r.lo * (2.0 * r.hi + r.lo);
  const auto even = [](const Lanes& x, const Lanes& y) { return Lanes(__builtin_shufflevector(x, y, 0, 4, 2, 6)); };
  const auto odd = [](const Lanes& x, const Lanes& y) { return Lanes(__builtin_shufflevector(x, y, 1, 5, 3, 7)); };
  const auto behind = [](const Lanes& x) { return Lanes(__builtin_shufflevector(x, x, 2, 3, 0, 1)); };
  WideLanes sum = two_sum(even(p.hi, q.hi), odd(p.hi, q.hi));  // g.r, r.r
  sum.lo += even(p_low, q_low) + odd(p_low, q_low);
  if constexpr (D == 3) {
    const WideLanes all = two_sum(sum.hi, behind(sum.hi));
    sum = {all.hi, (sum.lo + behind(sum.lo)) + all.lo};
  }
  const Lanes sizes = most(va, -va) + most(vb, -vb);
  const double doubt = pair.doubt * ((sizes[0] + sizes[1]) + (sizes[2] + sizes[3]));
  const DoubleDouble gr = sum[0];
  excess = (sum.hi[1] - pair.square.hi) + (sum.lo[1] - pair.square.lo);
  const double d = excess * pair.per_square;
  DoubleDouble f = two_prod(gr.hi, pair.push_a.hi);
  f.lo += (gr.hi * pair.push_a.lo + gr.lo * pair.push_a.hi) - f.hi * d;
  const WideLanes push = two_prod(spread(f.hi), r.hi);
  const Lanes push_low = push.lo + (f.hi * r.lo + f.lo * r.hi);
  const WideLanes a = two_diff(va, push.hi), b = two_sum(vb, push.hi);
  const Lanes rest_a = a.lo - push_low, rest_b = b.lo + push_low;
  after_a = a.hi + rest_a;
  after_b = b.hi + rest_b;
  const LaneMask alike =
      (a.hi + (rest_a - doubt) == a.hi + (rest_a + doubt)) & (b.hi + (rest_b - doubt) == b.hi + (rest_b + doubt));
  constexpr int all = (1 << D) - 1;
  return (gr.hi > doubt * pair.sigma) & (std::fabs(d) < 0x1p-46) & ((sign_bits(alike) & all) == all);
}

/// The size of the impulse of an elastic impact, if it is certainly that of resolve_impact.
template <int D>
[[nodiscard]] CAROM_INLINE bool elastic_impulse(const ElasticPair& pair, const double* high, const double* low, const double* va,
                                                const double* vb, double& impulse) {
  const auto [gr, rr, speeds] = detail::impact_sums<D>(high, low, va, vb);
  const double d = ((rr.hi - pair.square.hi) + (rr.lo - pair.square.lo)) * pair.per_square;
  DoubleDouble f = two_prod(gr.hi, pair.push.hi);
  f.lo += (gr.hi * pair.push.lo + gr.lo * pair.push.hi) - f.hi * d;
  double per_length, square;
  const bool certain =
      detail::rounds_alike(f, pair.push_doubt * speeds, per_length) & detail::rounds_alike(rr, pair.doubt * rr.hi, square);
  impulse = per_length * __builtin_sqrt(square);
  return certain;
}

}  // namespace carom
