#include "carom/observe/tangent_growth.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/random.hpp"

namespace carom {

namespace {

constexpr double large = 1e100;  // beyond it all displacements of a run are scaled down together

std::size_t coordinates(const Subject& s) {
  return static_cast<std::size_t>(s.free) * static_cast<std::size_t>(s.dimension);
}

}  // namespace

TangentGrowth::TangentGrowth(const Scene& scene, const Simulation& start)
    : TangentGrowth(scene, subject_of(scene, start)) {}

TangentGrowth::TangentGrowth(const Scene& scene, const Subject& subject)
    : dimension_(subject.dimension), flow_(scene, subject, std::min(coordinates(subject), most_vectors)) {
  const std::size_t d = static_cast<std::size_t>(dimension_);
  const bool all = coordinates(subject) <= most_vectors;
  for (std::uint32_t ball = 0; ball < subject.mass.size(); ++ball) {
    const std::size_t m = flow_.mover(ball);
    if (m >= flow_.movers()) continue;
    for (std::size_t vector = 0; vector < flow_.count(); ++vector) {
      RandomStream draws(vector, ball);
      for (std::size_t k = 0; k < d; ++k)
        flow_.row(m, k)[vector] = all ? (vector == m * d + k ? 1.0 : 0.0) : 2 * draws.uniform() - 1;
    }
  }
}

void TangentGrowth::collision(const Collision& c) {
  flow_.collision(c);
  if (!(flow_.largest_of_last() > large)) return;
  for (double& x : flow_.rows()) x /= large;
  scaled_out_ += 100;
}

double TangentGrowth::digits() const {
  TangentFlow now = flow_;
  now.advance_to(flow_.last());
  double largest = 0;
  for (std::size_t m = 0; m < now.movers(); ++m)
    for (std::size_t vector = 0; vector < now.count(); ++vector) {
      double square = 0;
      for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) square += std::pow(now.row(m, k)[vector], 2);
      largest = std::max(largest, square);
    }
  return largest > 0 ? 0.5 * std::log10(largest) + scaled_out_ : 0.0;
}

}  // namespace carom
