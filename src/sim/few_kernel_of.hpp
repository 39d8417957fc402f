#pragma once
// Picks the loop for a kind of space. Included by the file of each instruction set alone.

#include "carom/sim/few_loop.hpp"
#include "few_targets.hpp"

namespace carom {

template <int D, class Target>
FewKernel<D> few_kernel_of(bool periodic) {
  return periodic ? FewLoop<D, Target, true>::advance : FewLoop<D, Target, false>::advance;
}

}  // namespace carom
