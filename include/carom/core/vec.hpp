#pragma once
// Vectors of one to three components, with products in written order: the same bits on every vector unit.

#include <Eigen/Core>

#include "carom/core/double_double.hpp"
#include "carom/core/real.hpp"

namespace carom {

/// Unaligned, so that it can be a member anywhere and be passed by value.
template <class T, int D>
using Vec = Eigen::Matrix<T, D, 1, Eigen::DontAlign>;

/// u.v = ((u0 v0 + u1 v1) + u2 v2). Absolute error <= D u sum |u_i v_i|.
template <Real T, int D>
[[nodiscard]] constexpr T dot(const Vec<T, D>& u, const Vec<T, D>& v) {
  T s = u[0] * v[0];
  for (int i = 1; i < D; ++i) s += u[i] * v[i];
  return s;
}

/// The same in wide arithmetic. For double the absolute error is <= 8 u^2 sum |u_i v_i|: the products are exact.
template <Real T, int D>
[[nodiscard]] constexpr Wide<T> wide_dot(const Vec<T, D>& u, const Vec<T, D>& v) {
  Wide<T> s = wide_product<T>(u[0], v[0]);
  for (int i = 1; i < D; ++i) s = s + wide_product<T>(u[i], v[i]);
  return s;
}

/// The component of u x v out of the plane: u0 v1 - u1 v0. Absolute error <= 2 u (1 + u) (|u0 v1| + |u1 v0|).
template <Real T>
[[nodiscard]] constexpr T cross2(const Vec<T, 2>& u, const Vec<T, 2>& v) {
  return T(u[0] * v[1] - u[1] * v[0]);
}

/// u x v in three dimensions.
template <Real T>
[[nodiscard]] constexpr Vec<T, 3> cross3(const Vec<T, 3>& u, const Vec<T, 3>& v) {
  return Vec<T, 3>(T(u[1] * v[2] - u[2] * v[1]), T(u[2] * v[0] - u[0] * v[2]), T(u[0] * v[1] - u[1] * v[0]));
}

/// |u x v|^2 in written order.
template <Real T, int D>
[[nodiscard]] constexpr T cross_squared(const Vec<T, D>& u, const Vec<T, D>& v) {
  static_assert(D == 2 || D == 3);
  if constexpr (D == 2) {
    const T z = u[0] * v[1] - u[1] * v[0];
    return T(z * z);
  } else {
    const T x = u[1] * v[2] - u[2] * v[1];
    const T y = u[2] * v[0] - u[0] * v[2];
    const T z = u[0] * v[1] - u[1] * v[0];
    return T(x * x + y * y + z * z);
  }
}

}  // namespace carom
