#include "compose_swarm.hpp"

namespace carom {
template bool swarm_fits(const WorldAndGases<2>&);
template std::string swarm_obstacle(const WorldAndGases<2>&);
template std::unique_ptr<Simulation::Engine> make_swarm_engine(const Scene&, WorldAndGases<2>, Composition);
}  // namespace carom
