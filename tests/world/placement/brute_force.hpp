#pragma once
// What placements are judged by: every pair in every image, in long double.

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "carom/world/placement/region.hpp"

namespace carom::test {

struct TestBall {
  std::array<double, 3> x{};
  double radius = 0.0;
};

inline std::vector<TestBall> balls_of(const std::vector<PlacedBalls>& all) {
  std::vector<TestBall> balls;
  for (const PlacedBalls& p : all) {
    const auto d = static_cast<std::size_t>(p.region.dimension);
    for (std::size_t i = 0; i < p.position.size() / d; ++i) {
      TestBall& b = balls.emplace_back();
      b.radius = p.radius;
      for (std::size_t k = 0; k < d; ++k) b.x[k] = p.position[i * d + k];
    }
  }
  return balls;
}

/// Smallest (distance - contact distance) / contact distance over pairs and images, and over faces of a box (there over the
/// radius).
inline double smallest_gap(const std::vector<TestBall>& balls, const Region& region) {
  const int d = region.dimension;
  const bool periodic = region.kind == SpaceKind::periodic;
  long double smallest = INFINITY;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (int k = 0; region.kind == SpaceKind::box && k < d; ++k) {
      const long double r = balls[i].radius;
      smallest = std::min({smallest, (balls[i].x[k] - static_cast<long double>(region.lower[k]) - r) / r,
                           (static_cast<long double>(region.upper[k]) - balls[i].x[k] - r) / r});
    }
    for (std::size_t j = i; j < balls.size(); ++j) {
      const long double contact = static_cast<long double>(balls[i].radius) + balls[j].radius;
      for (int code = 0; code < (periodic ? (d == 1 ? 3 : d == 2 ? 9 : 27) : 1); ++code) {
        const std::array<int, 3> image =
            periodic ? std::array{code % 3 - 1, code / 3 % 3 - (d > 1), code / 9 - (d > 2)} : std::array{0, 0, 0};
        if (i == j && image == std::array{0, 0, 0}) continue;
        long double square = 0;
        for (int k = 0; k < d; ++k) {
          const long double edge = static_cast<long double>(region.upper[k]) - region.lower[k];
          const long double dx = static_cast<long double>(balls[j].x[k]) - balls[i].x[k] + image[k] * edge;
          square += dx * dx;
        }
        if (square < contact * contact * (1 + smallest) * (1 + smallest)) smallest = std::sqrt(square) / contact - 1;
      }
    }
  }
  return static_cast<double>(smallest);
}

/// FNV-1a over the bits.
inline std::uint64_t hash_of(std::span<const double> values, std::uint64_t hash = 0xcbf29ce484222325u) {
  for (const double v : values) {
    const auto bits = std::bit_cast<std::uint64_t>(v);
    for (int k = 0; k < 64; k += 8) hash = (hash ^ ((bits >> k) & 0xff)) * 0x100000001b3u;
  }
  return hash;
}

inline Region cube(SpaceKind kind, int dimension, double edge, double lower = 0.0) {
  Region region{kind, dimension, {}, {}};
  for (int k = 0; k < dimension; ++k) region.lower[k] = lower, region.upper[k] = lower + edge;
  return region;
}

}  // namespace carom::test
