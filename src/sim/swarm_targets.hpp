#pragma once
// The loop of many balls, compiled once for each instruction set (swarm_baseline.cpp, swarm_avx2.cpp).

#include "carom/sim/swarm_run.hpp"

namespace carom {

template <int D, class Target>
[[nodiscard]] SwarmKernel<D> swarm_kernel_of(bool periodic, bool equal);

extern template SwarmKernel<2> swarm_kernel_of<2, Baseline>(bool, bool);
extern template SwarmKernel<3> swarm_kernel_of<3, Baseline>(bool, bool);
extern template SwarmKernel<2> swarm_kernel_of<2, Avx2>(bool, bool);
extern template SwarmKernel<3> swarm_kernel_of<3, Avx2>(bool, bool);

}  // namespace carom
