#pragma once
// The impact of two bodies at one point: momentum along the line of centres, restitution, and nothing across it.

#include <array>

#include "carom/core/double_double.hpp"
#include "carom/core/vec.hpp"

namespace carom {

/// What an impact is computed from. Either mass may be infinite, not both.
template <class Real, int D>
struct Impact {
  std::array<Wide<Real>, D> r;  ///< from body a's centre towards body b's (or along a wall's normal); any length > 0
  Vec<Real, D> va, vb;          ///< [length unit / L] before
  Real ma, mb;                  ///< [mass unit]
  Real e;                       ///< coefficient of restitution [-]
};

template <class Real, int D>
struct Outcome {
  Vec<Real, D> va, vb;    ///< after
  Real impulse;           ///< [mass unit length unit / L] size of the impulse, >= 0
  Wide<Real> dissipated;  ///< [energy] mu (1 - e^2) g_n^2 / 2, from the values before
  Wide<Real> injected;    ///< [energy] J.V of the infinite mass, from the values before
};

namespace detail {
template <class Real>
[[nodiscard]] inline bool infinite(const Real& mass) {
  return mass == carom::infinity<Real>();
}

/// The share m_other / (m_own + m_other) of the change of relative velocity that a body takes.
template <class Real>
[[nodiscard]] inline Wide<Real> share(const Real& own, const Real& other) {
  using W = Wide<Real>;
  if (infinite(other)) return W(Real(1));
  if (infinite(own)) return W(Real(0));
  if (own == other) return W(Real(1) / 2);
  return W(other) / (W(own) + W(other));
}
}  // namespace detail

/// v_a' = v_a - s_a (1 + e) (g.r / r.r) r,  v_b' = v_b + s_b (1 + e) (g.r / r.r) r,  g = v_a - v_b
/// [papers/impact.md, eq. 4], with the actual r at the contact: an error in the gap costs no energy. All but the last
/// operation is carried out in twice the precision and each component of velocity is rounded once, so the error of the
/// energy is an unbiased walk. If g.r <= 0 after rounding (a grazing contact) there is no impulse: bodies never pull.
template <class Real, int D>
[[nodiscard]] inline Outcome<Real, D> resolve_impact(const Impact<Real, D>& in) {
  using W = Wide<Real>;
  using std::sqrt;
  Outcome<Real, D> out{in.va, in.vb, Real(0), W(Real(0)), W(Real(0))};

  std::array<W, D> g;
  W gr(Real(0)), rr(Real(0));
  for (int k = 0; k < D; ++k) {
    g[k] = wide_difference<Real>(in.va[k], in.vb[k]);
    gr = gr + g[k] * in.r[k];
    rr = rr + in.r[k] * in.r[k];
  }
  if (!(narrow(gr) > 0)) return out;

  const W sa = detail::share(in.ma, in.mb);
  const W sb = detail::share(in.mb, in.ma);
  const W k_r = (wide_sum<Real>(Real(1), in.e) * gr) / rr;
  if constexpr (D == 1) {
    if (in.ma == in.mb && in.e == 1) {  // equal masses exchange their velocities, bit for bit
      out.va = in.vb;
      out.vb = in.va;
    }
  }
  if (!(D == 1 && in.ma == in.mb && in.e == 1)) {
    for (int k = 0; k < D; ++k) {
      const W change = k_r * in.r[k];
      if (!detail::infinite(in.ma)) out.va[k] = narrow(W(in.va[k]) - sa * change);
      if (!detail::infinite(in.mb)) out.vb[k] = narrow(W(in.vb[k]) + sb * change);
    }
  }

  const W mu = detail::infinite(in.ma) ? W(in.mb) : sa * W(in.ma);  // m_a m_b / (m_a + m_b)
  const W per_length = mu * k_r;                                    // J / |r|
  out.impulse = narrow(per_length) * sqrt(narrow(rr));
  if (in.e != 1) {
    const W loss = W(Real(1)) - W(in.e) * W(in.e);
    out.dissipated = mu * loss * (gr * gr / rr) * W(Real(1) / 2);
  }
  // Work of the infinite mass, whose velocity V does not change: J.V with J the impulse on the finite body.
  if (detail::infinite(in.ma))
    for (int k = 0; k < D; ++k) out.injected = out.injected + per_length * in.r[k] * W(in.va[k]);
  if (detail::infinite(in.mb))
    for (int k = 0; k < D; ++k) out.injected = out.injected - per_length * in.r[k] * W(in.vb[k]);
  return out;
}

}  // namespace carom
