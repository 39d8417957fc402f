#pragma once
// The compositions in which balls come to rest on flat walls.

#include "carom/motion/resting.hpp"
#include "carom/world/flat_walls.hpp"
#include "compose.hpp"

namespace carom {

namespace detail {

template <int D>
[[nodiscard]] Resting<double, D> resting_motion(const World<double, D>& world) {
  Resting<double, D> motion;
  motion.a = world.acceleration;
  for (std::size_t k = 1; k <= flat_count(world.walls); ++k)
    with_flat(world.walls, k, [&](const auto& shape) {
      motion.along.push_back(along_wall<double, D>(world.acceleration, shape.normal(world.acceleration)));
    });
  return motion;
}

}  // namespace detail

template <int D>
std::unique_ptr<Simulation::Engine> make_resting_engine(const Scene& scene, World<double, D> world,
                                                        Composition composition) {
  const Resting<double, D> motion = detail::resting_motion(world);
  return detail::choose_search(scene, std::move(world), motion, std::move(composition));
}

template <int D>
std::unique_ptr<Simulation::Engine> make_resting_reference(const Scene& scene, World<double, D> world) {
  const Resting<double, D> motion = detail::resting_motion(world);
  return detail::make_reference(scene, std::move(world), motion);
}

}  // namespace carom
