#pragma once
// Which images of a partner a straight path can meet: column by column of a lattice, in the order in which it comes to them.

#include <cmath>
#include <cstdint>

#include "carom/core/lanes.hpp"

namespace carom {

/// Images of a partner stand at r + n * edge, n integer, and move past with g; those that come within sigma of the origin are
/// sought, for 2 sigma < every edge. Along the axis in which periods pass fastest, images stand in columns, which are passed
/// one after the other; in each at most two rows along every other axis can come near. What is told are all images that
/// meet, and others: which do meet is decided by their contact times.
template <int D>
struct LatticeRay {
  static constexpr double slack = 0x1p-20;  ///< [periods] far more than rounding, up to 2^30 periods

  int axis = 0;
  double sense;        ///< +-1: columns come in the order of sense * n[axis]
  double period;       ///< [L] from column to column
  double origin;       ///< [columns]
  double reach;        ///< [columns] sigma
  double place[D], slope[D], half[D];  ///< [rows] where the path is at the origin, what it gains a column, half of what it sweeps

  CAROM_INLINE LatticeRay(const double* r, const double* g, double sigma, const double* edge, const double* per_edge) {
    for (int k = 1; k < D; ++k)  // not to be foreseen: without a branch
      axis += (k - axis) * static_cast<int>(std::fabs(g[k]) * per_edge[k] > std::fabs(g[axis]) * per_edge[axis]);
    sense = -std::copysign(1.0, g[axis]);
    const double per_speed = 1 / std::fabs(g[axis]);
    period = edge[axis] * per_speed;
    origin = -(sense * r[axis]) * per_edge[axis];
    reach = sigma * per_edge[axis];
    for (int k = 0; k < D; ++k) {
      const double drift = g[k] * per_speed;
      place[k] = -r[k] * per_edge[k];
      slope[k] = -drift * edge[axis] * per_edge[k];
      half[k] = (std::fabs(drift) * sigma + sigma) * per_edge[k] + slack;
    }
  }

  /// The column that is near first.
  [[nodiscard]] CAROM_INLINE double first() const { return up(origin - reach - slack); }
  /// Nothing in this column and those after it is met before this time [L].
  [[nodiscard]] CAROM_INLINE double entry(double column) const { return (column - reach - slack - origin) * period; }
  /// The first of two rows along axis k in which a column can be met. T: double or Lanes.
  template <class T>
  [[nodiscard]] CAROM_INLINE T row(int k, const T& column) const {
    return up((column - origin) * slope[k] + (place[k] - half[k]));
  }

 private:
  /// x < result <= x + 1, up to a rounding of x.
  template <class T>
  [[nodiscard]] CAROM_INLINE static T up(const T& x) {
    return nearest_integer(x + 0.5);
  }
};

}  // namespace carom
