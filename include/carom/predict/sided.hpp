#pragma once
// Walls that balls may touch from either side, and what their predictions share.

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "carom/core/double_double.hpp"
#include "carom/core/vec.hpp"
#include "carom/shape/place_doubt.hpp"
#include "carom/solve/polynomial.hpp"

namespace carom {

/// A flight time to a two-sided wall, and the side of approach: +1 its left.
template <class Real>
struct SidedFlight {
  Real flight;
  std::int8_t side;
};

/// side_of_path where plain arithmetic is certain of it, else 0: five roundings are less than 4 u of the two products.
[[nodiscard]] inline int plain_side_of_path(const Vec<double, 2>& x, const Vec<double, 2>& v, const Vec<double, 2>& vertex) {
  const double p = (vertex[0] - x[0]) * v[1], q = (vertex[1] - x[1]) * v[0], cross = p - q;
  const double doubt = 0x1p-50 * (std::fabs(p) + std::fabs(q)) + 0x1p-960;
  return cross > doubt ? 1 : cross < -doubt ? -1 : 0;
}

/// Sign of (vertex - x) x v: on which side of a point's straight path a vertex lies; +1: to its right.
template <class Real>
[[nodiscard]] inline int side_of_path(const Vec<Real, 2>& x, const Vec<Real, 2>& v, const Vec<Real, 2>& vertex) {
  if constexpr (std::is_same_v<Real, double>)
    if (const int side = plain_side_of_path(x, v, vertex); side != 0) return side;
  const Wide<Real> rx = wide_difference<Real>(vertex[0], x[0]), ry = wide_difference<Real>(vertex[1], x[1]);
  const Real cross = narrow(Wide<Real>(rx * Wide<Real>(v[1]) - ry * Wide<Real>(v[0])));
  return cross > 0 ? 1 : cross < 0 ? -1 : 0;
}

/// The same for the end of a piece. Where the next piece goes on without a corner, a path straight through the joint counts
/// as one with the joint to its right, for both pieces alike: one of them is met.
template <class Real>
[[nodiscard]] inline int side_of_path(const Vec<Real, 2>& x, const Vec<Real, 2>& v, const Vec<Real, 2>& end, bool smooth) {
  const int side = side_of_path<Real>(x, v, end);
  return side == 0 && smooth ? 1 : side;
}

/// First time at which a polynomial f, positive to the left of a wall, changes its sign at a place that the wall `spans`.
/// `touched` (+1, -1, or 0: not): the side of a contact that has been resolved, f(0) = 0 by state; closing to higher order
/// is now. `only`: from this side alone; 0: from both.
template <class Real, class Spans>
[[nodiscard]] inline SidedFlight<Real> first_sided_crossing(std::array<Wide<Real>, 5> f, int touched, int only,
                                                            Spans&& spans) {
  if (touched != 0) {
    if (touched * detail::sign_of<Real>(narrow(f[1])) < 0) f[1] = Wide<Real>(Real(0));  // by rounding
    f = {f[1], f[2], f[3], f[4], Wide<Real>(Real(0))};
  }
  const Polynomial<Real> p = detail::polynomial<Real>(f);
  int side = detail::sign_at(p, detail::lowest(p));
  if (touched != 0 && side == -touched) return {Real(0), static_cast<std::int8_t>(touched)};
  const Crossings<Real> found = crossings(p);
  for (int i = 0; i < found.count; ++i, side = -side)
    if (only * side >= 0 && spans(found.t[i])) return {found.t[i], static_cast<std::int8_t>(side)};
  return {never<Real>(), 0};
}

}  // namespace carom
