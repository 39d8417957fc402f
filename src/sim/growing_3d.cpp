#include "compose_growing.hpp"

namespace carom {

template std::unique_ptr<Simulation::Engine> make_growing_engine<3>(const Scene&, World<double, 3>, Composition);
template std::unique_ptr<Simulation::Engine> make_growing_reference<3>(const Scene&, World<double, 3>);

}  // namespace carom
