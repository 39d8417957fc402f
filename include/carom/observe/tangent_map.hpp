#pragma once
// The derivative of flights and impacts: what they do to small displacements [papers/tangent_map.md].

#include <array>
#include <cmath>
#include <cstddef>

namespace carom {

/// An impact of the ball a with b (a ball or a wall), as far as its derivative needs it. D is the dimension.
template <int D>
struct TangentImpact {
  using Vector = std::array<double, static_cast<std::size_t>(D)>;

  Vector normal{};           ///< unit, from b to a
  Vector approach{};         ///< v_a - v_b before it [length/time]
  double bend = 0.0;         ///< 1 / sigma [1/length]: curvature of the surface that the centre of a is reflected by, 0 if flat
  Vector pull{};             ///< g_a - g_b before it [length/time^2]
  Vector drop_a{}, drop_b{}; ///< v - v' of each
  Vector ease_a{}, ease_b{}; ///< g - g' of each; 0 where accelerations do not depend on velocities
  double share_a = 1.0, share_b = 0.0;  ///< s (1 + e) of each; 0 for an infinite mass
};

/// 1 / sigma at a wall of curvature `curvature` (> 0: convex towards the ball; infinite: a corner), hit by a ball of radius
/// `radius`: the centre is reflected by the parallel curve.
[[nodiscard]] inline double bend_of_wall(double curvature, double radius) {
  if (curvature == 0) return 0.0;
  const double sigma = 1 / curvature + radius;
  return sigma == 0 ? 0.0 : 1 / sigma;
}

/// Displacements are kept in rows: those of a ball are 2 D rows of `count` numbers, component k of dx in row k, of dv in row
/// D + k, one column a displacement.

/// A flight for the time s under an acceleration that depends on neither place nor velocity [eq. 1].
template <int D>
void carry_along(double* ball, std::size_t count, double s) {
  const std::size_t half = static_cast<std::size_t>(D) * count;
  double* x = ball;
  const double* v = ball + half;
  for (std::size_t j = 0; j < half; ++j) x[j] += s * v[j];
}

/// A flight for the time s in two dimensions while the velocity turns at the rate omega [eq. 2].
inline void carry_round(double* ball, std::size_t count, double s, double omega) {
  const double angle = omega * s, c = std::cos(angle), sn = std::sin(angle), half = std::sin(angle / 2);
  const double along = sn / omega, across = 2 * half * half / omega;
  double *x = ball, *y = ball + count, *vx = ball + 2 * count, *vy = ball + 3 * count;
  for (std::size_t j = 0; j < count; ++j) {
    const double u = vx[j], w = vy[j];
    x[j] += along * u - across * w;
    y[j] += across * u + along * w;
    vx[j] = c * u - sn * w;
    vy[j] = sn * u + c * w;
  }
}

/// The impact [eq. 4, 5, 6, 7, 8]; `b` is null at a wall, and at a ball of infinite mass. Nothing is done at a grazing one,
/// which has no derivative.
template <int D>
void carry_through(const TangentImpact<D>& m, double* a, double* b, std::size_t count) {
  constexpr std::size_t d = static_cast<std::size_t>(D);
  double un = 0;
  for (std::size_t k = 0; k < d; ++k) un += m.approach[k] * m.normal[k];
  if (!(un < 0)) return;
  const double per_un = -1 / un;
  for (std::size_t j = 0; j < count; ++j) {
    std::array<double, d> r, w;
    double rn = 0;
    for (std::size_t k = 0; k < d; ++k) {
      r[k] = a[k * count + j];
      w[k] = a[(d + k) * count + j];
      if (b != nullptr) {
        r[k] -= b[k * count + j];
        w[k] -= b[(d + k) * count + j];
      }
      rn += r[k] * m.normal[k];
    }
    const double delay = rn * per_un;
    double change = 0;
    for (std::size_t k = 0; k < d; ++k) {
      r[k] = m.bend * (r[k] + delay * m.approach[k]);  // from here on the turn of the normal
      change += (w[k] + delay * m.pull[k]) * m.normal[k] + m.approach[k] * r[k];
    }
    for (std::size_t k = 0; k < d; ++k) {
      const double kick = change * m.normal[k] + un * r[k];
      a[k * count + j] += delay * m.drop_a[k];
      a[(d + k) * count + j] += delay * m.ease_a[k] - m.share_a * kick;
      if (b != nullptr) {
        b[k * count + j] += delay * m.drop_b[k];
        b[(d + k) * count + j] += delay * m.ease_b[k] + m.share_b * kick;
      }
    }
  }
}

}  // namespace carom
