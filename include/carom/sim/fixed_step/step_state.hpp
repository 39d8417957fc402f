#pragma once
// The balls of a scene between two steps: all at one time, apart from the world that they were built from.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/law/impact.hpp"
#include "carom/world/state.hpp"
#include "carom/world/world.hpp"

namespace carom {

/// In the world's units. In a periodic space a position may run out of the cell until `wrap_all` takes it back.
template <int D>
struct StepState {
  using Vector = Vec<double, D>;

  World<double, D> world;    ///< space, walls, laws, units; its balls are those of the start
  double dt;                 ///< [L]
  std::int64_t steps = 0;    ///< done
  std::vector<Vector> x, v;  ///< by ball number
  std::vector<Turns<D>> turns;
  std::vector<double> radius, inverse_mass;

  /// `step` [time] in the user's unit.
  StepState(World<double, D> built, double step) : world(std::move(built)), dt(std::ldexp(step, -world.units.time)) {
    for (std::uint32_t i = 0; i < world.balls.size(); ++i) {
      x.push_back(world.balls[i].position);
      v.push_back(world.balls[i].velocity);
      turns.push_back(world.details[i].image);
      radius.push_back(world.balls[i].radius);
      inverse_mass.push_back(1 / world.details[i].mass);
    }
  }

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(x.size()); }
  [[nodiscard]] bool fixed(std::uint32_t i) const { return world.balls[i].fixed; }
  [[nodiscard]] bool immovable(std::uint32_t i) const { return inverse_mass[i] == 0; }
  /// [L] since the world's start, when the walls were where the scene puts them.
  [[nodiscard]] double since_start() const { return static_cast<double>(steps) * dt; }

  /// v += a dt.
  void accelerate() {
    if (!world.accelerated()) return;
    for (std::uint32_t i = 0; i < size(); ++i)
      if (!fixed(i)) v[i] += world.acceleration * dt;
  }
  /// x += v dt.
  void move() {
    for (std::uint32_t i = 0; i < size(); ++i) x[i] += v[i] * dt;
  }

  /// From ball i to an image of ball j.
  [[nodiscard]] Vector separation(std::uint32_t i, std::uint32_t j, const Image<D>& image) const {
    Vector r = x[j] - x[i];
    if (world.space.periodic())
      for (int k = 0; k < D; ++k) r[k] += image[k] * world.space.edge[k];
    return r;
  }

  [[nodiscard]] double fastest() const {
    double most = 0;
    for (const Vector& u : v) most = std::max(most, dot<double, D>(u, u));
    return std::sqrt(most);
  }

  /// False for a position that is no number or 2^52 cells away.
  [[nodiscard]] bool within_reach(std::uint32_t i) const {
    for (int k = 0; k < D; ++k)
      if (world.space.periodic() && !(std::abs(x[i][k]) < 0x1p52 * world.space.edge[k])) return false;
    return true;
  }
  /// Every position within reach back into the cell.
  void wrap_all() {
    if (!world.space.periodic()) return;
    for (std::uint32_t i = 0; i < size(); ++i) {
      if (!within_reach(i)) continue;
      const Turns<D> taken = wrap(world.space, x[i]);
      for (int k = 0; k < D; ++k) turns[i][k] += taken[k];
    }
  }
  /// The image of ball j relative to ball i that no wrapping changes.
  [[nodiscard]] Image<D> lasting_image(std::uint32_t i, std::uint32_t j, const Image<D>& image) const {
    Image<D> lasting;
    for (int k = 0; k < D; ++k) lasting[k] = static_cast<std::int32_t>(image[k] + turns[i][k] - turns[j][k]);
    return lasting;
  }
};

/// Restitution of an impact at `approach` [length unit / L]: 0 below the threshold.
[[nodiscard]] inline double restitution_at(double e, double approach, double threshold) {
  return approach < threshold ? 0.0 : e;
}

struct StepImpact {
  double impulse = 0;      ///< [momentum unit] size
  double restitution = 1;  ///< [-] that was taken
};

/// The impulse of balls i and j, if they approach along r, from i to j (any length > 0).
template <int D>
inline StepImpact collide_balls(StepState<D>& s, std::uint32_t i, std::uint32_t j, const Vec<double, D>& r,
                                double threshold) {
  if (s.immovable(i) && s.immovable(j)) return {};
  const double approach = dot<double, D>(Vec<double, D>(s.v[i] - s.v[j]), r);
  if (!(approach > 0)) return {};
  const auto& details = s.world.details;
  Impact<double, D> impact{{}, s.v[i], s.v[j], details[i].mass, details[j].mass, 0};
  for (int k = 0; k < D; ++k) impact.r[k] = r[k];
  impact.e = restitution_at(s.world.restitution.between(details[i].material, details[j].material),
                            approach / std::sqrt(dot<double, D>(r, r)), threshold);
  const Outcome<double, D> outcome = resolve_impact(impact);
  s.v[i] = outcome.va;
  s.v[j] = outcome.vb;
  return {outcome.impulse, impact.e};
}

/// The same of ball i and a wall with normal n (any length > 0), towards the ball, that moves with velocity u.
template <int D>
inline StepImpact collide_wall(StepState<D>& s, std::uint32_t i, std::uint32_t wall, const Vec<double, D>& n,
                               const Vec<double, D>& u, double threshold) {
  if (s.immovable(i)) return {};
  const double approach = dot<double, D>(Vec<double, D>(u - s.v[i]), n);
  if (!(approach > 0)) return {};
  const auto& detail = s.world.details[i];
  Impact<double, D> impact{{}, s.v[i], u, detail.mass, never<double>(), 0};
  for (int k = 0; k < D; ++k) impact.r[k] = -n[k];
  impact.e = restitution_at(s.world.restitution.at_wall(detail.material, wall), approach / std::sqrt(dot<double, D>(n, n)),
                            threshold);
  const Outcome<double, D> outcome = resolve_impact(impact);
  s.v[i] = outcome.va;
  return {outcome.impulse, impact.e};
}

}  // namespace carom
