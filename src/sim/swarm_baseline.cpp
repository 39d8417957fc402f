#include "swarm_kernel_of.hpp"

namespace carom {
template SwarmKernel<2> swarm_kernel_of<2, Baseline>(bool, bool);
template SwarmKernel<3> swarm_kernel_of<3, Baseline>(bool, bool);
}  // namespace carom
