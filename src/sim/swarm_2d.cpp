#include "compose_swarm.hpp"

namespace carom {
template bool swarm_fits(const World<double, 2>&);
template std::unique_ptr<Simulation::Engine> make_swarm_engine(const Scene&, World<double, 2>, Composition);
}  // namespace carom
