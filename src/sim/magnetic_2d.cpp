#include "carom/motion/magnetic_arc.hpp"
#include "compose.hpp"

namespace carom {

std::unique_ptr<Simulation::Engine> make_magnetic_engine(const Scene& scene, World<double, 2> world,
                                                         Composition composition) {
  const MagneticArc<double> motion{world.magnetic};
  return detail::choose_search(scene, std::move(world), motion, std::move(composition));
}

std::unique_ptr<Simulation::Engine> make_magnetic_reference(const Scene& scene, World<double, 2> world) {
  const MagneticArc<double> motion{world.magnetic};
  return detail::make_reference(scene, std::move(world), motion);
}

}  // namespace carom
