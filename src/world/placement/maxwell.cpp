#include "carom/world/placement/maxwell.hpp"

#include <bit>
#include <cmath>

#include "carom/core/random.hpp"

namespace carom {
namespace {

/// Sum of doubles with the rounding of every addition carried along [Neumaier1974].
class CompensatedSum {
 public:
  void add(double x) {
    const double t = sum_ + x;
    carry_ += std::abs(sum_) >= std::abs(x) ? (sum_ - t) + x : (x - t) + sum_;
    sum_ = t;
  }
  [[nodiscard]] double value() const { return sum_ + carry_; }

 private:
  double sum_ = 0.0, carry_ = 0.0;
};

void subtract_mean(PageVector<double>& v, int dimension, std::int64_t count) {
  for (int k = 0; k < dimension; ++k) {
    CompensatedSum sum;
    for (std::size_t i = k; i < v.size(); i += dimension) sum.add(v[i]);
    const double mean = sum.value() / static_cast<double>(count);
    for (std::size_t i = k; i < v.size(); i += dimension) v[i] -= mean;
  }
}

void scale_to(PageVector<double>& v, double sum_of_squares) {
  CompensatedSum sum;
  for (const double x : v) sum.add(x * x);
  if (sum.value() == 0.0) return;
  const double factor = std::sqrt(sum_of_squares / sum.value());
  for (double& x : v) x *= factor;
}

/// Twice the unit in the last place of the largest component, so that every component is fewer than 2^52 of it.
double common_grid(const PageVector<double>& v) {
  double largest = 0.0;
  for (const double x : v) largest = std::max(largest, std::abs(x));
  const auto exponent = std::bit_cast<std::uint64_t>(largest) >> 52;
  return exponent > 51 ? std::bit_cast<double>((exponent - 51) << 52) : 0.0;
}

/// Rounds every component to a common grid, on which sums are exact, and hands what is left of the momentum to the balls in
/// steps of the grid: an error of one rounding each.
void remove_last_bits_of_momentum(PageVector<double>& v, int dimension, std::int64_t count) {
  const double grid = common_grid(v);
  if (grid == 0.0) return;
  for (int k = 0; k < dimension; ++k) {
    const auto steps = [&](double x) { return static_cast<std::int64_t>(x / grid + (x < 0.0 ? -0.5 : 0.5)); };
    std::uint64_t wrapped = 0;  // the sum modulo 2^64; the true one is small
    for (std::size_t i = k; i < v.size(); i += dimension) wrapped += static_cast<std::uint64_t>(steps(v[i]));
    const auto left = static_cast<std::int64_t>(wrapped);
    const std::int64_t each = left / count, sign = left < 0 ? -1 : 1;
    std::int64_t single = sign * (left % count);  // so many balls take one step more
    for (std::size_t i = k; i < v.size(); i += dimension) {
      std::int64_t n = steps(v[i]) - each;
      if (single > 0) {
        n -= sign;
        --single;
      }
      v[i] = static_cast<double>(n) * grid;
    }
  }
}

}  // namespace

PageVector<double> maxwell_velocities(const Maxwell& m, SpaceKind space) {
  const auto size = static_cast<std::size_t>(m.count) * static_cast<std::size_t>(m.dimension);
  PageVector<double> v(size, 0.0);
  const bool periodic = space == SpaceKind::periodic;
  if (!(m.temperature > 0.0) || !std::isfinite(m.mass) || (periodic && m.count < 2)) return v;

  for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
    RandomStream draw(m.seed, i, use_for_velocity(m.entry));
    for (int k = 0; k < m.dimension; ++k) v[i * m.dimension + k] = draw.normal();
  }
  if (m.count > 1) subtract_mean(v, m.dimension, m.count);
  // First to unit temperature, then to the asked one, so that no square overflows.
  const double freedoms = static_cast<double>(m.dimension) * static_cast<double>(periodic ? m.count - 1 : m.count);
  scale_to(v, freedoms);
  const double speed = std::sqrt(m.temperature / m.mass);
  for (double& x : v) x *= speed;
  if (m.count > 1) remove_last_bits_of_momentum(v, m.dimension, m.count);
  return v;
}

}  // namespace carom
