#include "compose_growing.hpp"

namespace carom {

template std::unique_ptr<Simulation::Engine> make_growing_engine<2>(const Scene&, World<double, 2>, Composition);
template std::unique_ptr<Simulation::Engine> make_growing_reference<2>(const Scene&, World<double, 2>);

}  // namespace carom
