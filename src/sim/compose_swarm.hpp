#pragma once
// The composition for many balls in free flight.

#include <string>

#include <fmt/format.h>

#include "carom/world/wall_pieces.hpp"
#include "composed_engine.hpp"
#include "engine.hpp"
#include "swarm_integrator.hpp"

namespace carom {

template <int D>
std::string swarm_obstacle(const WorldAndGases<D>& parts) {
  const World<double, D>& world = parts.world;
  if (world.accelerated()) return "the balls are accelerated, and lists are for free flight";
  if (world.law != LawKind::restitution) return "only law = \"restitution\" goes with lists";
  if (world.simultaneous != Simultaneous::sequential) return "only simultaneous = \"sequential\" goes with lists";
  if (world.space.periodic() && !world.walls.empty()) return "there is a wall in a periodic space";
  if (!all_stand_still(world.walls)) return "a wall moves, lets balls out, or is curved other than as an arc";
  const Space<double, D> frame = frame_of(world);
  for (int k = 0; k < D; ++k)
    if (!(frame.edge[k] > 0)) return "the space is open, and no segment, arc or circle bounds it";
  if (!is_swarm(parts)) return "a ball is a point, or starts in contact";
  if (world.space.kind == SpaceKind::open)
    for (const auto& ball : world.balls)
      for (int k = 0; k < D; ++k)
        if (!(ball.position[k] >= frame.lower[k] && ball.position[k] <= frame.lower[k] + frame.edge[k]))
          return "a ball starts outside of all walls in open space";
  const BallSizes sizes = sizes_of(parts);
  const double thickness = shell_thickness<D>(frame, sizes), reach = 2 * sizes.largest + thickness;
  bool narrow = !(thickness >= least_thickness(sizes));
  for (int k = 0; k < D; ++k) narrow = narrow || (world.space.periodic() && sizes.equal() && world.space.edge[k] < 3 * reach);
  return narrow ? "a period is too short for lists: neighbours could meet in two images" : "";
}

template <int D>
bool swarm_fits(const WorldAndGases<D>& parts) {
  return swarm_obstacle(parts).empty();
}

template <int D>
std::unique_ptr<Simulation::Engine> make_swarm_engine(const Scene& scene, WorldAndGases<D> parts, Composition composition) {
  const World<double, D>& world = parts.world;
  composition.search = "neighbour lists";
  composition.queue = "calendar";
  const BallSizes sizes = sizes_of(parts);
  composition.reasons.push_back(fmt::format("shells {:.3g} thick: a ball has about {:.1f} neighbours (measured best)",
                                            std::ldexp(shell_thickness<D>(frame_of(world), sizes), world.units.length),
                                            best_neighbours<D>(sizes.equal())));
  if (!sizes.equal())
    composition.reasons.push_back(
        fmt::format("radii {:.3g} to {:.3g}: balls up to twice as large as each other share a grid of cells",
                    std::ldexp(sizes.smallest, world.units.length), std::ldexp(sizes.largest, world.units.length)));
  const std::size_t pieces = numbered_pieces(world.walls) - world.walls.faces.size();
  if (pieces > 0)
    composition.reasons.push_back(
        fmt::format("{} piece{} of walls inside: looked at for balls whose shell reaches one", pieces, pieces == 1 ? "" : "s"));
  composition.reasons.push_back("calendar of fine buckets, its width set by the rate of events as the run goes");
  composition.reasons.push_back("balls kept in the order of a Morton curve, predictions four at a time where the processor can");
  return std::make_unique<ComposedEngine<SwarmIntegrator<D>>>(scene, make_swarm(std::move(parts)), FreeFlight<double, D>{},
                                                              std::move(composition), SwarmSetup{0, scene.engine.vectors});
}

}  // namespace carom
