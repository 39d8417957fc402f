#pragma once
// The impact of two bodies whose surfaces come closer by growth: the law of impact.hpp in the speed of the surfaces.

#include "carom/law/impact.hpp"

namespace carom {

/// v_a' = v_a - s_a k r,  v_b' = v_b + s_b k r,  k = (1 + e) (g.r + G |r|) / r.r,  g = v_a - v_b
/// [papers/impact.md, eq. 10], G = gamma_a + gamma_b [length unit / L] the rate at which the gap shrinks by growth. The
/// growth does the work J G, which is booked as injected [eq. 11]. No impulse where the surfaces do not approach.
template <class Real, int D>
[[nodiscard]] inline Outcome<Real, D> resolve_growing_impact(const Impact<Real, D>& in, const Real& growth) {
  using W = Wide<Real>;
  using std::sqrt;
  if (growth == 0) return resolve_impact(in);
  Outcome<Real, D> out{in.va, in.vb, Real(0), W(Real(0)), W(Real(0))};

  W gr(Real(0)), rr(Real(0));
  for (int k = 0; k < D; ++k) {
    gr = gr + wide_difference<Real>(in.va[k], in.vb[k]) * in.r[k];
    rr = rr + in.r[k] * in.r[k];
  }
  const W by_growth = W(growth) * sqrt(rr);
  const W approach = gr + by_growth;
  if (!(narrow(approach) > 0)) return out;

  const W sa = detail::share(in.ma, in.mb), sb = detail::share(in.mb, in.ma);
  const W k_r = (wide_sum<Real>(Real(1), in.e) * approach) / rr;
  for (int k = 0; k < D; ++k) {
    const W change = k_r * in.r[k];
    if (!detail::infinite(in.ma)) out.va[k] = narrow(W(in.va[k]) - sa * change);
    if (!detail::infinite(in.mb)) out.vb[k] = narrow(W(in.vb[k]) + sb * change);
  }

  const W mu = detail::infinite(in.ma) ? W(in.mb) : sa * W(in.ma);
  const W per_length = mu * k_r;  // J / |r|
  out.impulse = narrow(per_length) * sqrt(narrow(rr));
  if (in.e != 1) {
    const W loss = W(Real(1)) - W(in.e) * W(in.e);
    out.dissipated = mu * loss * (approach * approach / rr) * W(Real(1) / 2);
  }
  out.injected = per_length * by_growth;
  if (detail::infinite(in.ma))
    for (int k = 0; k < D; ++k) out.injected = out.injected + per_length * in.r[k] * W(in.va[k]);
  if (detail::infinite(in.mb))
    for (int k = 0; k < D; ++k) out.injected = out.injected - per_length * in.r[k] * W(in.vb[k]);
  return out;
}

}  // namespace carom
