#pragma once
// The composition for many balls in free flight.

#include <fmt/format.h>

#include "composed_engine.hpp"
#include "engine.hpp"
#include "swarm_integrator.hpp"

namespace carom {

template <int D>
bool swarm_fits(const WorldAndGases<D>& parts) {
  const World<double, D>& world = parts.world;
  if (world.law != LawKind::restitution || world.simultaneous != Simultaneous::sequential || world.accelerated()) return false;
  const bool walls_of_its_own = world.walls.labels.size() > world.walls.faces.size();
  if (world.space.kind == SpaceKind::open || walls_of_its_own) return false;
  if (!is_swarm(parts)) return false;
  const BallSizes sizes = sizes_of(parts);
  const double cut = 2 * sizes.largest + shell_thickness(world.space, sizes, best_neighbours<D>);
  for (int k = 0; k < D; ++k)
    if (world.space.periodic() && world.space.edge[k] < 3 * cut) return false;
  return true;
}

template <int D>
std::unique_ptr<Simulation::Engine> make_swarm_engine(const Scene& scene, WorldAndGases<D> parts, Composition composition) {
  const double thickness = shell_thickness(parts.world.space, sizes_of(parts), best_neighbours<D>);
  composition.search = "neighbour lists";
  composition.queue = "calendar";
  composition.reasons.push_back(fmt::format("shells {:.3g} thick: a ball has about {:.1f} neighbours (measured best)",
                                            std::ldexp(thickness, parts.world.units.length), best_neighbours<D>));
  composition.reasons.push_back("calendar of fine buckets, its width set by the rate of events as the run goes");
  composition.reasons.push_back("balls kept in the order of a Morton curve, predictions four at a time where the processor can");
  return std::make_unique<ComposedEngine<SwarmIntegrator<D>>>(scene, make_swarm(std::move(parts)), FreeFlight<double, D>{},
                                                              std::move(composition), SwarmSetup{0, scene.engine.vectors});
}

}  // namespace carom
