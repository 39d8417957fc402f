#pragma once
// The composition for few balls in free flight.

#include <fmt/format.h>

#include "carom/search/all_pairs.hpp"
#include "carom/search/cell_grid.hpp"
#include "composed_engine.hpp"
#include "few_engine.hpp"
#include "few_integrator.hpp"

namespace carom {

template <int D>
bool few_fits(const World<double, D>& world) {
  if (world.law != LawKind::restitution || world.simultaneous != Simultaneous::sequential || world.accelerated()) return false;
  if (world.balls.size() > few_balls || !world.bodies.empty()) return false;
  if (!world.walls.openings.empty() || !world.walls.swings.empty()) return false;
  double largest = 0;  // distance at which two balls meet
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    if (!world.balls[i].alive) return false;
    if (detail::infinite(world.details[i].mass) && world.balls[i].velocity != Vec<double, D>::Zero()) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (!world.balls[i].fixed || !world.balls[j].fixed)
        largest = std::max(largest, world.balls[i].radius + world.balls[j].radius);
  }
  for (int k = 0; k < D; ++k)  // the columns of images lie apart
    if (world.space.periodic() && 2 * largest > world.space.edge[k] * (1 - 0x1p-10)) return false;
  return true;
}

template <int D>
std::unique_ptr<Simulation::Engine> make_few_engine(const Scene& scene, World<double, D> world, Composition composition) {
  const bool periodic = world.space.periodic();
  composition.search = periodic ? "all pairs and their images" : "all pairs";
  composition.queue = "table of meetings";
  composition.reasons.push_back(fmt::format("all pairs: {} balls, nothing to keep", world.balls.size()));
  if (periodic && world.balls.size() > 1)
    composition.reasons.push_back("images of a partner in the order in which its path comes to them");
  if (periodic && !world.walls.empty())
    composition.reasons.push_back("walls: after a circle the circles that lie that way, the nearest first; else period by period");
  composition.reasons.push_back("table of meetings: one entry a pair; the first is found by looking at all");
  const FreeFlight<double, D> motion;
  const auto make = [&]<class Search>(Search search) -> std::unique_ptr<Simulation::Engine> {
    using Integrator = FewIntegrator<D, Search>;
    return std::make_unique<ComposedEngine<Integrator>>(scene, std::move(world), motion, std::move(composition),
                                                        typename Integrator::Setup{std::move(search), scene.engine.vectors});
  };
  if (periodic) return make(CellGrid<double, D>(Layout::one_cell));
  return make(AllPairs<double, D>());
}

}  // namespace carom
