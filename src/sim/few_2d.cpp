#include "compose_few.hpp"

namespace carom {
template bool few_fits(const World<double, 2>&);
template std::unique_ptr<Simulation::Engine> make_few_engine(const Scene&, World<double, 2>, Composition);
}  // namespace carom
