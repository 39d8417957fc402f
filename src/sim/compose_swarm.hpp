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
  const double thickness = shell_thickness<D>(world.space, sizes);
  if (!(thickness >= least_thickness(sizes))) return false;
  if (world.space.periodic() && sizes.equal())
    for (int k = 0; k < D; ++k)
      if (world.space.edge[k] < 3 * (2 * sizes.largest + thickness)) return false;
  return true;
}

template <int D>
std::unique_ptr<Simulation::Engine> make_swarm_engine(const Scene& scene, WorldAndGases<D> parts, Composition composition) {
  const World<double, D>& world = parts.world;
  composition.search = "neighbour lists";
  composition.queue = "calendar";
  const BallSizes sizes = sizes_of(parts);
  composition.reasons.push_back(fmt::format("shells {:.3g} thick: a ball has about {:.1f} neighbours (measured best)",
                                            std::ldexp(shell_thickness<D>(world.space, sizes), world.units.length),
                                            best_neighbours<D>(sizes.equal())));
  if (!sizes.equal())
    composition.reasons.push_back(
        fmt::format("radii {:.3g} to {:.3g}: balls up to twice as large as each other share a grid of cells",
                    std::ldexp(sizes.smallest, world.units.length), std::ldexp(sizes.largest, world.units.length)));
  composition.reasons.push_back("calendar of fine buckets, its width set by the rate of events as the run goes");
  composition.reasons.push_back("balls kept in the order of a Morton curve, predictions four at a time where the processor can");
  return std::make_unique<ComposedEngine<SwarmIntegrator<D>>>(scene, make_swarm(std::move(parts)), FreeFlight<double, D>{},
                                                              std::move(composition), SwarmSetup{0, scene.engine.vectors});
}

}  // namespace carom
