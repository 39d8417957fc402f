#pragma once
// From a scene to a composition in an arithmetic other than double: one search for all, and a heap.

#include <fmt/format.h>

#include "carom/core/error.hpp"
#include "carom/core/multi.hpp"
#include "carom/motion/free_flight.hpp"
#include "carom/motion/magnetic_arc.hpp"
#include "carom/motion/uniform_acceleration.hpp"
#include "carom/queue/heap_queue.hpp"
#include "carom/search/cell_grid.hpp"
#include "carom/world/build.hpp"
#include "composed_engine.hpp"
#include "engine.hpp"

namespace carom {

namespace detail {

template <Motion M>
std::unique_ptr<Simulation::Engine> make_precise(const Scene& scene, World<typename M::Real, M::dimension> world,
                                                 const M& motion, const Precision& precision) {
  using Real = typename M::Real;
  constexpr int D = M::dimension;
  using Search = CellGrid<Real, D>;  // with one cell it is all pairs, and in a periodic space their images
  using Queue = HeapQueue<Real, D>;
  const std::size_t n = world.balls.size();
  const bool few = scene.engine.search == SearchKind::all_pairs || (scene.engine.search == SearchKind::automatic && n <= few_balls);
  Composition composition{M::name, few ? "all pairs" : Search::name, Queue::name, {}};
  composition.reasons.push_back(M::circular      ? "magnetic field: every ball that is not fixed flies circles of one frequency"
                                : M::accelerated ? "uniform acceleration: every ball that is not fixed flies a parabola"
                                               : "free flight: no acceleration, so paths are straight lines");
  composition.reasons.push_back(fmt::format("{} and a heap: {} balls in a precision other than double", composition.search, n));
  return std::make_unique<ComposedEngine<WorldIntegrator<M, Search, Queue>>>(scene, std::move(world), motion, std::move(composition),
                                                            Search(few ? Layout::one_cell : Layout::fitted), precision);
}

template <class Real, int D>
std::unique_ptr<Simulation::Engine> make_in(const Scene& scene, const Precision& precision) {
  const PrecisionScope<Real> scope(precision.digits);
  World<Real, D> world = build<Real, D>(scene);
  if (world.growth.any())
    throw InputError(Problem{scene.file, 0, "balls that grow in a precision other than double: not built yet",
                             "radii grow in double only", "Leave out --precision, or radius_growth"});
  if (world.accelerated() && world.regularise == Regularise::rest)
    throw InputError(Problem{scene.file, scene.collision.where.line,
                             "collision.regularise = \"rest\" in a precision other than double: not built yet",
                             "balls come to rest in double only", "Leave out --precision, or regularise"});
  if (world.accelerated()) {
    const UniformAcceleration<Real, D> motion{world.acceleration};
    return make_precise(scene, std::move(world), motion, precision);
  }
  if constexpr (D == 2)
    if (world.magnetic != 0) return make_precise(scene, std::move(world), MagneticArc<Real>{world.magnetic}, precision);
  return make_precise(scene, std::move(world), FreeFlight<Real, D>{}, precision);
}

}  // namespace detail

template <int D>
std::unique_ptr<Simulation::Engine> make_precise_engine(const Scene& scene, const Precision& precision) {
  return precision.kind == Precision::Kind::long_double ? detail::make_in<long double, D>(scene, precision)
                                                        : detail::make_in<Multi, D>(scene, precision);
}

}  // namespace carom
