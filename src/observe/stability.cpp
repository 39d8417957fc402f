#include "stability.hpp"

#include <algorithm>
#include <complex>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include "return_map.hpp"

namespace carom {

namespace {

/// Of a symplectic 2 x 2 matrix: x^2 - t x + 1 = 0, the larger root without cancellation.
std::vector<Multiplier> pair_of(const Multi& trace, bool parabolic) {
  const Multi half = trace / 2, square = half * half - 1;
  if (parabolic) {
    const Number one(half < 0 ? -1.0 : 1.0);
    return {{one, 0.0}, {one, 0.0}};
  }
  if (square < 0) {
    const Multi imaginary = sqrt(Multi(-square));
    return {{number(half), number(imaginary)}, {number(half), number(Multi(-imaginary))}};
  }
  const Multi root = sqrt(square);
  const Multi large = half < 0 ? Multi(half - root) : Multi(half + root);
  return {{number(large), 0.0}, {number(Multi(1 / large)), 0.0}};
}

std::vector<Multiplier> eigenvalues(const Dense& m) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix a(m.rows(), m.columns());
  for (std::size_t i = 0; i < m.rows(); ++i)
    for (std::size_t j = 0; j < m.columns(); ++j)
      a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = static_cast<double>(m(i, j));
  const Eigen::EigenSolver<Matrix> solver(a, false);
  std::vector<std::complex<double>> values;
  for (Eigen::Index i = 0; i < a.rows(); ++i) values.push_back(solver.eigenvalues()[i]);
  std::sort(values.begin(), values.end(), [](const auto& x, const auto& y) {
    return std::abs(x) != std::abs(y) ? std::abs(x) > std::abs(y) : x.imag() > y.imag();
  });
  std::vector<Multiplier> list;
  for (const std::complex<double>& x : values) list.push_back({x.real(), x.imag()});
  return list;
}

/// Double eigenvalues of a matrix that is no diagonal are known to the root of the rounding only.
OrbitKind kind_of(const std::vector<Multiplier>& list) {
  constexpr double certain = 1e-6;
  const auto size = [](const Multiplier& m) { return std::abs(std::complex<double>(m.real, m.imaginary)); };
  if (std::any_of(list.begin(), list.end(), [&](const Multiplier& m) { return std::abs(size(m) - 1) > certain; }))
    return OrbitKind::hyperbolic;
  const bool real = std::all_of(list.begin(), list.end(), [&](const Multiplier& m) { return std::abs(m.imaginary.value) <= certain; });
  return real ? OrbitKind::parabolic : OrbitKind::elliptic;
}

}  // namespace

void judge_stability(const Dense& monodromy, const Multis& flow, const Multis& gradient, const Multi& certain, PeriodicOrbit& orbit) {
  const std::vector<Multis> across = orthogonal_complement({flow, gradient});
  const std::size_t n = across.size();
  Dense map(n, n);
  Multi trace(0);
  for (std::size_t j = 0; j < n; ++j) {
    Multis image(flow.size(), Multi(0));
    for (std::size_t r = 0; r < flow.size(); ++r)
      for (std::size_t c = 0; c < flow.size(); ++c) image[r] += monodromy(r, c) * across[j][c];
    for (std::size_t i = 0; i < n; ++i) map(i, j) = dot(across[i], image);
    trace += map(j, j);
  }
  orbit.trace = number(trace);
  if (n == 0) {  // one ball on a line: nothing is beside its orbit
    orbit.kind = OrbitKind::parabolic;
    return;
  }
  if (n != 2) {
    orbit.multipliers = eigenvalues(map);
    orbit.kind = kind_of(orbit.multipliers);
    return;
  }
  const Multi beyond = abs(trace) - 2;
  orbit.kind = abs(beyond) <= certain ? OrbitKind::parabolic : beyond > 0 ? OrbitKind::hyperbolic : OrbitKind::elliptic;
  orbit.multipliers = pair_of(trace, orbit.kind == OrbitKind::parabolic);
}

}  // namespace carom
