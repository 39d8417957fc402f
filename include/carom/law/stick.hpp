#pragma once
// Perfectly inelastic impact: both bodies move on with the common velocity (m1 u1 + m2 u2) / (m1 + m2) [papers/impact.md,
// eq. 9].

#include "carom/law/impact.hpp"

namespace carom {

template <class Real, int D>
struct Common {
  Vec<Real, D> velocity;
  Real impulse = Real(0);          ///< size
  Wide<Real> dissipated{Real(0)};  ///< mu |g|^2 / 2, normal and tangential
  Wide<Real> injected{Real(0)};    ///< J.V of an infinite mass
};

/// Not both masses infinite. An infinite mass keeps its velocity; each component is rounded once.
template <class Real, int D>
[[nodiscard]] inline Common<Real, D> common_velocity(const Real& ma, const Vec<Real, D>& va, const Real& mb,
                                                     const Vec<Real, D>& vb) {
  using W = Wide<Real>;
  using std::sqrt;
  Common<Real, D> out;
  const W sa = detail::share(ma, mb);  // v = v_a - s_a g
  const W mu = detail::infinite(ma) ? W(mb) : sa * W(ma);
  W gg(Real(0));
  for (int k = 0; k < D; ++k) {
    const W g = wide_difference<Real>(va[k], vb[k]);
    out.velocity[k] = detail::infinite(ma) ? va[k] : detail::infinite(mb) ? vb[k] : narrow(W(W(va[k]) - sa * g));
    gg = gg + g * g;
    if (detail::infinite(ma)) out.injected = out.injected + mu * g * W(va[k]);  // J on b is mu g
    if (detail::infinite(mb)) out.injected = out.injected - mu * g * W(vb[k]);  // J on a is -mu g
  }
  out.impulse = narrow(mu) * sqrt(narrow(gg));
  out.dissipated = mu * gg * W(Real(1) / 2);
  return out;
}

}  // namespace carom
