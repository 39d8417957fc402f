#pragma once
// Energy, momentum and angular momentum of all balls of finite mass at one moment, in sums of twice the precision.

#include <array>
#include <limits>

#include "carom/core/double_double.hpp"
#include "carom/law/impact.hpp"
#include "carom/world/state.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// In the world's units. Angular momentum about the origin: one component in 2-D, three in 3-D, none in 1-D.
template <class Real, int D>
struct Totals {
  static constexpr int rotations = D == 3 ? 3 : D - 1;

  Wide<Real> kinetic{Real(0)};
  Wide<Real> potential{Real(0)};  ///< -m a.x
  std::array<Wide<Real>, D> momentum{};
  std::array<Wide<Real>, 3> angular_momentum{};
  Real momentum_size{0};          ///< sum of m |v|
  Real angular_momentum_size{0};  ///< sum of m |x| |v|
  Wide<Real> mass{Real(0)};
  Real lowest_potential = infinity<Real>();  ///< per mass, of all balls
  bool all_finite = true;                    ///< no ball, left or not, has an infinite mass
};

/// Position counted through all periods, in wide arithmetic.
template <class W, class Real, int D>
[[nodiscard]] inline std::array<Wide<Real>, D> unwrapped(const W& world, std::uint32_t i, const Vec<Real, D>& x) {
  std::array<Wide<Real>, D> u;
  for (int k = 0; k < D; ++k) u[k] = Wide<Real>(x[k]);
  if (!world.space.periodic()) return u;
  const auto& detail = world.details[i];
  for (int k = 0; k < D; ++k) u[k] = u[k] + wide_product<Real>(Real(detail.image[k]), world.space.edge[k]);
  return u;
}

/// WorldLike: World, or a view with its members.
template <Motion M, class WorldLike>
[[nodiscard]] Totals<typename M::Real, M::dimension> totals_at(const M& motion, const WorldLike& world,
                                                               const Time<typename M::Real>& t) {
  using Real = typename M::Real;
  using W = Wide<Real>;
  using std::sqrt;
  constexpr int D = M::dimension;
  Totals<Real, D> sum;
  const bool accelerated = world.accelerated();
  for (std::uint32_t i = 0; i < world.balls.size(); ++i) {
    const Real mass = world.details[i].mass;
    if (detail::infinite(mass)) sum.all_finite = false;
    if (detail::infinite(mass) || !world.balls[i].alive) continue;
    const W m(mass);
    // The stored velocity itself where the motion is free: looking adds no rounding.
    const Vec<Real, D> v = velocity_at(motion, world, i, t);
    const std::array<W, D> x = unwrapped(world, i, position_at(motion, world, i, t));
    W vv(Real(0)), xx(Real(0)), potential(Real(0));
    for (int k = 0; k < D; ++k) {
      vv = vv + wide_product<Real>(v[k], v[k]);
      xx = xx + x[k] * x[k];
      sum.momentum[k] = sum.momentum[k] + m * W(v[k]);
      if (accelerated) potential = potential - x[k] * W(world.acceleration[k]);
    }
    sum.potential = sum.potential + m * potential;
    if (narrow(potential) < sum.lowest_potential) sum.lowest_potential = narrow(potential);
    sum.kinetic = sum.kinetic + m * vv * W(Real(1) / 2);
    if constexpr (D == 2) sum.angular_momentum[0] = sum.angular_momentum[0] + m * (x[0] * W(v[1]) - x[1] * W(v[0]));
    if constexpr (D == 3)
      for (int k = 0; k < 3; ++k) {
        const int p = (k + 1) % 3, q = (k + 2) % 3;
        sum.angular_momentum[k] = sum.angular_momentum[k] + m * (x[p] * W(v[q]) - x[q] * W(v[p]));
      }
    const Real speed = sqrt(narrow(vv));
    sum.momentum_size += narrow(m) * speed;
    sum.angular_momentum_size += narrow(m) * speed * sqrt(narrow(xx));
    sum.mass = sum.mass + m;
  }
  return sum;
}

}  // namespace carom
