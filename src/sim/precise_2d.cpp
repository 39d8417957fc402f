#include "compose_precise.hpp"

namespace carom {
template std::unique_ptr<Simulation::Engine> make_precise_engine<2>(const Scene&, const Precision&);
}  // namespace carom
