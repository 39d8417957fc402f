#pragma once
// Small dense matrices of many digits: a solve, and the rest of a basis.

#include <algorithm>
#include <utility>
#include <vector>

#include "carom/core/multi.hpp"

namespace carom {

using Multis = std::vector<Multi>;

/// By rows.
class Dense {
 public:
  Dense(std::size_t rows, std::size_t columns) : columns_(columns), values_(rows * columns, Multi(0)) {}
  [[nodiscard]] Multi& operator()(std::size_t i, std::size_t j) { return values_[i * columns_ + j]; }
  [[nodiscard]] const Multi& operator()(std::size_t i, std::size_t j) const { return values_[i * columns_ + j]; }
  [[nodiscard]] std::size_t rows() const { return columns_ == 0 ? 0 : values_.size() / columns_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }

 private:
  std::size_t columns_;
  Multis values_;
};

[[nodiscard]] inline Multi dot(const Multis& a, const Multis& b) {
  Multi s(0);
  for (std::size_t i = 0; i < a.size(); ++i) s += a[i] * b[i];
  return s;
}

/// x with a x = b, by elimination with row pivots. a is not singular.
[[nodiscard]] inline Multis solve(Dense a, Multis b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (abs(a(i, k)) > abs(a(pivot, k))) pivot = i;
    for (std::size_t j = k; j < n; ++j) std::swap(a(k, j), a(pivot, j));
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Multi factor = a(i, k) / a(k, k);
      for (std::size_t j = k; j < n; ++j) a(i, j) -= factor * a(k, j);
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a(k, j) * b[j];
    b[k] /= a(k, k);
  }
  return b;
}

/// Orthonormal vectors that span what is orthogonal to all of `given`, which are independent.
[[nodiscard]] inline std::vector<Multis> orthogonal_complement(const std::vector<Multis>& given) {
  const std::size_t n = given.front().size();
  std::vector<Multis> basis;
  const auto rest = [&](Multis v) {
    for (int twice = 0; twice < 2; ++twice)  // once more, for what rounding left
      for (const Multis& q : basis) {
        const Multi along = dot(q, v);
        for (std::size_t i = 0; i < n; ++i) v[i] -= along * q[i];
      }
    return v;
  };
  const auto take = [&](Multis v) {
    const Multi size = sqrt(dot(v, v));
    for (Multi& x : v) x /= size;
    basis.push_back(std::move(v));
  };
  for (const Multis& v : given) take(rest(v));
  while (basis.size() < n) {
    Multis best;
    for (std::size_t i = 0; i < n; ++i) {
      Multis unit(n, Multi(0));
      unit[i] = 1;
      Multis left = rest(std::move(unit));
      if (best.empty() || dot(left, left) > dot(best, best)) best = std::move(left);
    }
    take(std::move(best));
  }
  return {basis.begin() + static_cast<std::ptrdiff_t>(given.size()), basis.end()};
}

}  // namespace carom
