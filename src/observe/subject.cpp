#include "carom/observe/subject.hpp"

#include <algorithm>
#include <cmath>

#include "carom/world/placement/radius.hpp"

namespace carom {

namespace {

/// Edge of the periodic cell that a gas sets where the scene has no space; 0: no gas does.
double edge_set_by_gas(const Scene& scene) {
  for (const GasSpec& g : scene.gases)
    if (g.radius && g.packing_fraction && g.radius->value > 0)
      return dimensional_root(static_cast<double>(g.count) * ball_volume(*g.radius, scene.dimension) / *g.packing_fraction,
                              scene.dimension);
  return 0.0;
}

}  // namespace

bool Subject::moves_freely(std::uint32_t ball) const { return mass[ball] > 0 && std::isfinite(mass[ball]); }

bool Subject::has_obstacles() const {
  return walls > 0 || std::any_of(mass.begin(), mass.end(), [](double m) { return std::isinf(m); });
}

Time<double> moment_of(double t, double epoch_length) {
  const double epochs = t / epoch_length;  // a power of two: exact
  if (!(std::abs(epochs) < static_cast<double>(last_epoch))) return Time<double>::never();
  const double whole = std::floor(epochs);
  return {static_cast<std::int64_t>(whole), epochs - whole};
}

Subject subject_of(const Scene& scene, const Simulation& simulation) {
  Subject s;
  s.dimension = scene.dimension;
  s.space = scene.space.kind;
  s.epoch_length = simulation.epoch_length();
  s.merging = scene.collision.law == LawKind::merge;
  const double set_by_gas = s.space == SpaceKind::open ? edge_set_by_gas(scene) : 0.0;
  if (set_by_gas > 0) s.space = SpaceKind::periodic;
  for (int k = 0; k < scene.dimension; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    if (s.space != SpaceKind::open)
      s.edge[axis] = set_by_gas > 0 ? set_by_gas : scene.space.upper[axis] - scene.space.lower[axis];
    if (!scene.motion.acceleration.empty()) s.acceleration[axis] = scene.motion.acceleration[axis];
  }
  if (scene.motion.magnetic) s.magnetic = *scene.motion.magnetic;
  s.moment = moment_of(simulation.time(), s.epoch_length);
  const std::uint32_t faces = s.space == SpaceKind::box ? 2 * static_cast<std::uint32_t>(s.dimension) : 0;
  s.walls = simulation.wall_count() - faces;
  const std::uint32_t count = simulation.ball_count();
  s.mass.resize(count, 0.0);
  s.radius.resize(count, 0.0);
  s.position.resize(count);
  s.velocity.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!simulation.alive(i)) continue;
    const Glimpse ball = simulation.glimpse(i);
    s.mass[i] = ball.mass;
    s.radius[i] = ball.radius;
    s.position[i] = ball.position;
    s.velocity[i] = ball.velocity;
    if (std::isfinite(ball.mass)) ++s.free;
  }
  return s;
}

}  // namespace carom
