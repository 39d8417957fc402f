#pragma once
// From a scene to the smallest composition that can run it.

#include <fmt/format.h>

#include "carom/motion/free_flight.hpp"
#include "carom/motion/uniform_acceleration.hpp"
#include "carom/queue/heap_queue.hpp"
#include "carom/queue/sorted_queue.hpp"
#include "carom/search/all_pairs.hpp"
#include "carom/search/cell_grid.hpp"
#include "composed_engine.hpp"
#include "engine.hpp"

namespace carom {

namespace detail {

template <class Search, Motion M>
std::unique_ptr<Simulation::Engine> make_composed(const Scene& scene, World<typename M::Real, M::dimension> world,
                                                  const M& motion, Composition composition, Search search) {
  using Queue = HeapQueue<typename M::Real, M::dimension>;
  composition.queue = Queue::name;
  composition.reasons.push_back("heap: O(log N) a change, nothing to tune");
  return std::make_unique<ComposedEngine<M, Search, Queue>>(scene, std::move(world), motion, std::move(composition),
                                                            std::move(search));
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
  return std::make_unique<ComposedEngine<M, Search, Queue>>(scene, std::move(world), motion, std::move(composition),
                                                            Search(one_cell ? Layout::one_cell : Layout::fitted));
}

}  // namespace detail

template <int D>
std::unique_ptr<Simulation::Engine> make_reference_engine(const Scene& scene) {
  World<double, D> world = build<double, D>(scene);
  if (world.accelerated() && world.regularise == Regularise::rest)
    return make_resting_reference<D>(scene, std::move(world));
  if (world.accelerated()) {
    const UniformAcceleration<double, D> motion{world.acceleration};
    return detail::make_reference(scene, std::move(world), motion);
  }
  return detail::make_reference(scene, std::move(world), FreeFlight<double, D>{});
}

template <int D>
std::unique_ptr<Simulation::Engine> make_engine(const Scene& scene) {
  Composition composition;
  World<double, D> world = build<double, D>(scene);
  if (world.accelerated()) {
    composition.reasons.push_back("uniform acceleration: every ball that is not fixed flies a parabola");
    if (world.regularise == Regularise::rest) {
      composition.reasons.push_back("rest: a ball that comes to rest on a flat wall keeps only the acceleration along it");
      return make_resting_engine<D>(scene, std::move(world), std::move(composition));
    }
    const UniformAcceleration<double, D> motion{world.acceleration};
    return detail::choose_search(scene, std::move(world), motion, std::move(composition));
  }
  composition.reasons.push_back("free flight: no acceleration, so paths are straight lines");
  if (world.regularise == Regularise::rest)
    composition.reasons.push_back("nothing comes to rest: no acceleration presses balls on a wall");
  return detail::choose_search(scene, std::move(world), FreeFlight<double, D>{}, std::move(composition));
}

}  // namespace carom
