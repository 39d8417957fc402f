#include "compose.hpp"

namespace carom {

template std::unique_ptr<Simulation::Engine> make_reference_engine<2>(const Scene&);

}  // namespace carom
