#include "compose_resting.hpp"

namespace carom {

template std::unique_ptr<Simulation::Engine> make_resting_engine<2>(const Scene&, World<double, 2>, Composition);
template std::unique_ptr<Simulation::Engine> make_resting_reference<2>(const Scene&, World<double, 2>);

}  // namespace carom
