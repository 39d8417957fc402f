#pragma once
// From a scene to the smallest composition that can run it.

#include "carom/motion/free_flight.hpp"
#include "carom/queue/heap_queue.hpp"
#include "carom/search/all_pairs.hpp"
#include "composed_engine.hpp"
#include "engine.hpp"

namespace carom {

template <int D>
std::unique_ptr<Simulation::Engine> make_engine(const Scene& scene) {
  Composition composition;
  World<double, D> world = build<double, D>(scene);
  using M = FreeFlight<double, D>;
  composition.motion = M::name;
  composition.reasons.push_back("free flight: the scene has no acceleration, so paths are straight lines");
  composition.search = AllPairs<double, D>::name;
  composition.reasons.push_back("all pairs: nothing to keep for few balls");
  composition.queue = HeapQueue<double, D>::name;
  composition.reasons.push_back("heap: O(log N) a change, nothing to tune");
  return std::make_unique<ComposedEngine<M, AllPairs<double, D>, HeapQueue<double, D>>>(scene, std::move(world), M{},
                                                                                       std::move(composition));
}

}  // namespace carom
