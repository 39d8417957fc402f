#pragma once
// From a scene to the smallest composition that can run it.

#include <algorithm>

#include <fmt/format.h>

#include "carom/motion/free_flight.hpp"
#include "carom/motion/uniform_acceleration.hpp"
#include "carom/core/error.hpp"
#include "carom/queue/calendar_queue.hpp"
#include "carom/queue/heap_queue.hpp"
#include "carom/queue/sorted_queue.hpp"
#include "carom/search/all_pairs.hpp"
#include "carom/search/cell_grid.hpp"
#include "carom/world/gases.hpp"
#include "composed_engine.hpp"
#include "engine.hpp"
#include "few_engine.hpp"

namespace carom {

namespace detail {

template <class Search, Motion M>
std::unique_ptr<Simulation::Engine> make_composed(const Scene& scene, World<typename M::Real, M::dimension> world,
                                                  const M& motion, Composition composition, Search search) {
  const auto make = [&]<class Queue>() -> std::unique_ptr<Simulation::Engine> {
    composition.queue = Queue::name;
    return std::make_unique<ComposedEngine<WorldIntegrator<M, Search, Queue>>>(scene, std::move(world), motion,
                                                                               std::move(composition), std::move(search));
  };
  if (scene.engine.queue == QueueKind::calendar) {
    composition.reasons.push_back("calendar (as [engine] asks): constant time a change, tuned as the run goes");
    return make.template operator()<CalendarQueue<typename M::Real, M::dimension>>();
  }
  composition.reasons.push_back("heap: O(log N) a change, nothing to tune");
  return make.template operator()<HeapQueue<typename M::Real, M::dimension>>();
}

template <Motion M>
std::unique_ptr<Simulation::Engine> choose_search(const Scene& scene, World<typename M::Real, M::dimension> world,
                                                  const M& motion, Composition composition) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  composition.motion = M::name;
  const std::size_t n = world.balls.size();
  SearchKind search = scene.engine.search;
  const bool chosen = search == SearchKind::automatic;
  if constexpr (std::is_same_v<M, FreeFlight<double, D>> && D > 1) {
    if (chosen && scene.engine.queue == QueueKind::automatic && few_fits(world))
      return make_few_engine<D>(scene, std::move(world), std::move(composition));
  }
  if (search == SearchKind::neighbour_list) {
    std::string why;
    if constexpr (D == 1) {
      why = "in one dimension a ball has two neighbours";
    } else if constexpr (std::is_same_v<M, FreeFlight<double, D>>) {
      why = scene.engine.queue == QueueKind::heap ? "lists have a calendar as queue" : swarm_obstacle(WorldAndGases<D>{world, {}});
    } else {
      why = "the balls do not fly freely at constant sizes";
    }
    const char* hint = scene.engine.queue == QueueKind::heap ? "Leave engine.queue out, or use search = \"cells\""
                                                            : "Leave engine.search out, or use \"cells\"";
    throw InputError(Problem{scene.file, scene.engine.where.line, "engine.search = \"neighbour_list\" does not fit this scene",
                             why, hint});
  }
  if (chosen && D > 1 && std::all_of(world.balls.begin(), world.balls.end(), [](const auto& b) { return b.radius == 0; })) {
    composition.search = "walls alone";
    composition.reasons.push_back(fmt::format("walls alone: {} points, which never meet each other", n));
    return make_composed(scene, std::move(world), motion, std::move(composition), CellGrid<Real, D>(Layout::one_cell));
  }
  if (chosen) search = n <= few_balls ? SearchKind::all_pairs : SearchKind::cells;
  const char* who = chosen ? "" : " (as [engine] asks)";
  if (search == SearchKind::all_pairs && !world.space.periodic()) {
    composition.search = AllPairs<Real, D>::name;
    composition.reasons.push_back(fmt::format("all pairs{}: {} balls, nothing to keep", who, n));
    return make_composed(scene, std::move(world), motion, std::move(composition), AllPairs<Real, D>());
  }
  if (search == SearchKind::all_pairs) {
    composition.search = "all pairs and their images";
    composition.reasons.push_back(
        fmt::format("all pairs{}: {} balls, and their images in the neighbouring periods", who, n));
    return make_composed(scene, std::move(world), motion, std::move(composition), CellGrid<Real, D>(Layout::one_cell));
  }
  composition.search = CellGrid<Real, D>::name;
  composition.reasons.push_back(
      fmt::format("cells{}: {} balls, each meets only those in the cells around its own", who, n));
  return make_composed(scene, std::move(world), motion, std::move(composition), CellGrid<Real, D>(Layout::fitted));
}

/// Balls in free flight are left to the integrator for many: it is wanted and can move them.
template <int D>
bool takes_many(const Scene& scene, const WorldAndGases<D>& parts) {
  const EngineSpec& wanted = scene.engine;
  const bool asked = wanted.search == SearchKind::neighbour_list;
  const bool enough = asked || wanted.queue == QueueKind::calendar || parts.size() >= many_balls;
  return (asked || wanted.search == SearchKind::automatic) && wanted.queue != QueueKind::heap && enough && swarm_fits(parts);
}

/// Up to this many balls the reference is searched by all pairs: some hundred collisions a second at this size.
inline constexpr std::size_t bearable_pairs = 4000;

template <Motion M>
std::unique_ptr<Simulation::Engine> make_reference(const Scene& scene, World<typename M::Real, M::dimension> world,
                                                   const M& motion) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  using Search = CellGrid<Real, D>;
  using Queue = SortedQueue<Real, D>;
  // The search that make_engine does not take: one cell where that takes several, several where it takes one or none.
  const bool few = world.balls.size() <= few_balls && scene.engine.search != SearchKind::cells;
  const bool one_cell = !few && world.balls.size() <= bearable_pairs;
  Composition composition{M::name, one_cell ? "one cell" : Search::name, Queue::name, {}};
  return std::make_unique<ComposedEngine<WorldIntegrator<M, Search, Queue>>>(scene, std::move(world), motion, std::move(composition),
                                                            Search(one_cell ? Layout::one_cell : Layout::fitted));
}

}  // namespace detail

template <int D>
std::unique_ptr<Simulation::Engine> make_reference_engine(const Scene& scene) {
  World<double, D> world = build<double, D>(scene);
  if (world.growth.any()) return make_growing_reference<D>(scene, std::move(world));
  if (world.accelerated() && world.regularise == Regularise::rest)
    return make_resting_reference<D>(scene, std::move(world));
  if constexpr (D == 2)
    if (world.magnetic != 0) return make_magnetic_reference(scene, std::move(world));
  if (world.accelerated()) {
    const UniformAcceleration<double, D> motion{world.acceleration};
    return detail::make_reference(scene, std::move(world), motion);
  }
  return detail::make_reference(scene, std::move(world), FreeFlight<double, D>{});
}

template <int D>
std::unique_ptr<Simulation::Engine> make_engine(const Scene& scene) {
  Composition composition;
  WorldAndGases<D> parts = build_apart<D>(scene);
  const bool rests = parts.world.regularise == Regularise::rest;
  if (parts.world.accelerated()) {
    composition.reasons.push_back("uniform acceleration: every ball that is not fixed flies a parabola");
    World<double, D> world = join(std::move(parts));
    if (rests) {
      composition.reasons.push_back("rest: a ball that comes to rest on a flat wall keeps only the acceleration along it");
      return make_resting_engine<D>(scene, std::move(world), std::move(composition));
    }
    const UniformAcceleration<double, D> motion{world.acceleration};
    return detail::choose_search(scene, std::move(world), motion, std::move(composition));
  }
  if constexpr (D == 2)
    if (parts.world.magnetic != 0) {
      composition.reasons.push_back("magnetic field: every ball that is not fixed flies circles of one frequency");
      return make_magnetic_engine(scene, join(std::move(parts)), std::move(composition));
    }
  composition.reasons.push_back("free flight: no acceleration, so paths are straight lines");
  if (parts.world.growth.any()) return make_growing_engine<D>(scene, join(std::move(parts)), std::move(composition));
  if (rests) composition.reasons.push_back("nothing comes to rest: no acceleration presses balls on a wall");
  if constexpr (D > 1)
    if (detail::takes_many(scene, parts)) {
      const bool asked = scene.engine.search == SearchKind::neighbour_list;
      composition.motion = FreeFlight<double, D>::name;
      composition.reasons.push_back(
          fmt::format("neighbour lists{}: {} balls", asked ? " (as [engine] asks)" : "", parts.size()));
      return make_swarm_engine<D>(scene, std::move(parts), std::move(composition));
    }
  return detail::choose_search(scene, join(std::move(parts)), FreeFlight<double, D>{}, std::move(composition));
}

}  // namespace carom
