#pragma once
// The composition for many balls in free flight.

#include <fmt/format.h>

#include "composed_engine.hpp"
#include "engine.hpp"
#include "swarm_integrator.hpp"

namespace carom {

template <int D>
bool swarm_fits(const World<double, D>& world) {
  if (world.law != LawKind::restitution || world.simultaneous != Simultaneous::sequential || world.accelerated()) return false;
  const bool walls_of_its_own = world.walls.labels.size() > world.walls.faces.size();
  if (world.space.kind == SpaceKind::open || walls_of_its_own) return false;
  if (!is_swarm(world)) return false;
  double largest = 0;
  for (const auto& ball : world.balls) largest = std::max(largest, ball.radius);
  const double cut = 2 * largest + shell_thickness(world, best_neighbours<D>);
  for (int k = 0; k < D; ++k)
    if (world.space.periodic() && world.space.edge[k] < 3 * cut) return false;
  return true;
}

template <int D>
std::unique_ptr<Simulation::Engine> make_swarm_engine(const Scene& scene, World<double, D> world, Composition composition) {
  composition.search = "neighbour lists";
  composition.queue = "calendar";
  composition.reasons.push_back(fmt::format("shells {:.3g} thick: a ball has about {:.1f} neighbours (measured best)",
                                            std::ldexp(shell_thickness(world, best_neighbours<D>), world.units.length),
                                            best_neighbours<D>));
  composition.reasons.push_back("calendar of fine buckets, its width set by the rate of events as the run goes");
  composition.reasons.push_back("balls kept in the order of a Morton curve, predictions four at a time where the processor can");
  return std::make_unique<ComposedEngine<SwarmIntegrator<D>>>(scene, std::move(world), FreeFlight<double, D>{},
                                                              std::move(composition), SwarmSetup{0, scene.engine.vectors});
}

}  // namespace carom
