#include "swarm_kernel_of.hpp"

namespace carom {
template SwarmKernel<2> swarm_kernel_of<2, Avx2>(bool, bool);
template SwarmKernel<3> swarm_kernel_of<3, Avx2>(bool, bool);
}  // namespace carom
