#pragma once
// The compositions in which balls grow.

#include "carom/motion/growing_flight.hpp"
#include "compose.hpp"

namespace carom {

template <int D>
std::unique_ptr<Simulation::Engine> make_growing_engine(const Scene& scene, World<double, D> world,
                                                        Composition composition) {
  composition.reasons.push_back(
      "growth: radii grow at constant rates, so contact times are roots of quadratics of their own");
  return detail::choose_search(scene, std::move(world), GrowingFlight<double, D>{}, std::move(composition));
}

template <int D>
std::unique_ptr<Simulation::Engine> make_growing_reference(const Scene& scene, World<double, D> world) {
  return detail::make_reference(scene, std::move(world), GrowingFlight<double, D>{});
}

}  // namespace carom
