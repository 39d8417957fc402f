#pragma once
// Picks the loop for a kind of swarm. Included by the file of each instruction set alone.

#include "carom/sim/swarm_loop.hpp"
#include "swarm_targets.hpp"

namespace carom {

template <int D, class Target>
SwarmKernel<D> swarm_kernel_of(bool periodic, bool equal) {
  if (periodic && equal) return {SwarmLoop<D, Target, true, true>::start, SwarmLoop<D, Target, true, true>::advance};
  if (periodic) return {SwarmLoop<D, Target, true, false>::start, SwarmLoop<D, Target, true, false>::advance};
  if (equal) return {SwarmLoop<D, Target, false, true>::start, SwarmLoop<D, Target, false, true>::advance};
  return {SwarmLoop<D, Target, false, false>::start, SwarmLoop<D, Target, false, false>::advance};
}

}  // namespace carom
