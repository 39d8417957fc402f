#pragma once
// Ends of walls that nearly meet: a joint that was meant and is a gap.

#include <algorithm>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "carom/core/error.hpp"
#include "carom/world/world.hpp"

namespace carom::detail {

/// Two ends closer than this share of the smaller of their walls are one joint, or a mistake.
inline constexpr double nearly = 1e-6;

/// A problem for each pair of ends of two walls at rest to each other that are not the same point, but nearly. Ends and
/// vertices are the spheres of radius 0; they are sorted along x, so that each is compared with its neighbours alone.
template <class Real>
[[nodiscard]] std::vector<Problem> near_joints(const Scene& scene, const World<Real, 2>& world) {
  using std::abs;
  using std::sqrt;
  std::vector<const Sphere<Real, 2>*> ends;
  std::map<std::uint32_t, std::pair<Vec<Real, 2>, Vec<Real, 2>>> boxes;  // by wall: lower and upper corner
  for (const Sphere<Real, 2>& s : world.walls.spheres) {
    if (s.radius > 0) continue;
    ends.push_back(&s);
    auto& [low, high] = boxes.try_emplace(index(s.wall), s.centre, s.centre).first->second;
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min<Real>(low[k], s.centre[k]);
      high[k] = std::max<Real>(high[k], s.centre[k]);
    }
  }
  std::sort(ends.begin(), ends.end(), [](const auto* a, const auto* b) { return a->centre[0] < b->centre[0]; });
  const auto size = [&](const Sphere<Real, 2>& s) {
    const auto& [low, high] = boxes.at(index(s.wall));
    return std::max<Real>(high[0] - low[0], high[1] - low[1]);
  };
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const Sphere<Real, 2>&a = *ends[i], &b = *ends[j];
      const Real far = Real(nearly) * size(a);
      if (b.centre[0] - a.centre[0] > far) break;
      if (a.wall == b.wall || a.velocity != b.velocity || a.centre == b.centre) continue;
      const Vec<Real, 2> r = b.centre - a.centre;
      const Real gap = sqrt(dot<Real, 2>(r, r));
      if (gap > far || gap > Real(nearly) * size(b)) continue;
      const std::uint32_t first = std::min(index(a.wall), index(b.wall)), second = std::max(index(a.wall), index(b.wall));
      const double apart = static_cast<double>(scaled(gap, world.units.length));
      problems.push_back({scene.file, scene.walls[second].where.line,
                          fmt::format("wall {} and wall {} do not meet: their ends are {:.3g} apart", first, second, apart),
                          "two ends that near are meant to be one, and a point gets out between them",
                          "Give both ends the same numbers"});
    }
  return problems;
}

}  // namespace carom::detail
