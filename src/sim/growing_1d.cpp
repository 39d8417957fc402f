#include "compose_growing.hpp"

namespace carom {

template std::unique_ptr<Simulation::Engine> make_growing_engine<1>(const Scene&, World<double, 1>, Composition);
template std::unique_ptr<Simulation::Engine> make_growing_reference<1>(const Scene&, World<double, 1>);

}  // namespace carom
