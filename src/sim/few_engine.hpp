#pragma once
// The composition for few balls in free flight: what it fits, and how to make it.

#include "engine.hpp"

namespace carom {

/// True if the integrator for few balls can move this world: lone balls in free flight, law "restitution", contacts one by
/// one, infinite masses at rest, no openings and no walls that swing; in a periodic space walls stand still, and columns of
/// images of a ball lie apart.
template <int D>
[[nodiscard]] bool few_fits(const World<double, D>& world);
template <int D>
[[nodiscard]] std::unique_ptr<Simulation::Engine> make_few_engine(const Scene& scene, World<double, D> world,
                                                                  Composition composition);

extern template bool few_fits(const World<double, 2>&);
extern template bool few_fits(const World<double, 3>&);
extern template std::unique_ptr<Simulation::Engine> make_few_engine(const Scene&, World<double, 2>, Composition);
extern template std::unique_ptr<Simulation::Engine> make_few_engine(const Scene&, World<double, 3>, Composition);

}  // namespace carom
