#include "compose_swarm.hpp"

namespace carom {
template bool swarm_fits(const WorldAndGases<3>&);
template std::string swarm_obstacle(const WorldAndGases<3>&);
template std::unique_ptr<Simulation::Engine> make_swarm_engine(const Scene&, WorldAndGases<3>, Composition);
}  // namespace carom
