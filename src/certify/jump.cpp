#include "jump.hpp"

namespace carom::certify {

namespace {

/// Normal, relative velocity and normal velocity at the contact, s later.
struct Touch {
  Triple<Enclosure> n, u;
  Enclosure nu;
};

Touch touch(const Relative<Enclosure>& r, const Enclosure& sigma, const Enclosure& s, std::size_t d) {
  Touch t;
  t.u = r.u;
  for (std::size_t k = 0; k < d; ++k) {
    Enclosure y = r.y[k] + r.u[k] * s;
    if (r.curved) {
      y = y + half(r.a[k]) * square(s);
      t.u[k] = t.u[k] + r.a[k] * s;
    }
    t.n[k] = y / sigma;
    t.nu = t.nu + t.n[k] * t.u[k];
  }
  return t;
}

}  // namespace

Jump::Jump(const Gaps<Enclosure>& gaps, std::size_t d, const Relative<Enclosure>& r, const Relative<Enclosure>& middle,
           const Enclosure& sigma, const Enclosure& offset) {
  // f(s) = 0 = f(0) + f'(somewhere between 0 and s) s.
  const Polynomial<Enclosure> gap = gaps.round_gap(middle, sigma);
  const Enclosure s = -(gap[0] / slope(gap, offset.with_zero()));
  const Touch at = touch(middle, sigma, s, d);
  for (std::size_t k = 0; k < d; ++k) {
    h[k] = at.n[k] * at.nu;
    g[k] = h[k] * s;
  }

  // With w = dy + s du: ds = -(n.w) / nu, dn = p w / sigma, p = 1 - u n^T / nu.
  const Touch box = touch(r, sigma, offset, d);
  Matrix p;
  Triple<Enclosure> up;  // u^T p
  for (std::size_t k = 0; k < d; ++k)
    for (std::size_t l = 0; l < d; ++l) {
      p[k][l] = Enclosure(k == l ? 1.0 : 0.0) - box.u[k] * box.n[l] / box.nu;
      up[l] = up[l] + box.u[k] * p[k][l];
    }
  Enclosure pull;  // (n.a) / nu
  if (r.curved) {
    for (std::size_t k = 0; k < d; ++k) pull = pull + box.n[k] * r.a[k];
    pull = pull / box.nu;
  }
  for (std::size_t k = 0; k < d; ++k)
    for (std::size_t l = 0; l < d; ++l) {
      const Enclosure nn = k == l ? square(box.n[k]) : box.n[k] * box.n[l];
      Enclosure turn = (box.nu * p[k][l] + box.n[k] * up[l]) / sigma;
      if (r.curved) turn = turn - nn * pull;
      h_y[k][l] = turn;
      h_u[k][l] = nn + offset * turn;
      g_y[k][l] = offset * turn - nn;
      g_u[k][l] = square(offset) * turn;
    }
}

State<Enclosure> middle_of(const State<Enclosure>& state, std::size_t d) {
  State<Enclosure> m;
  for (std::size_t k = 0; k < d; ++k) {
    m.x[k] = state.x[k].middle();
    m.v[k] = state.v[k].middle();
  }
  return m;
}

State<Enclosure> difference(const State<Enclosure>& a, const State<Enclosure>& b, std::size_t d) {
  State<Enclosure> c;
  for (std::size_t k = 0; k < d; ++k) {
    c.x[k] = a.x[k] - b.x[k];
    c.v[k] = a.v[k] - b.v[k];
  }
  return c;
}

}  // namespace carom::certify
