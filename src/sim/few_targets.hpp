#pragma once
// The loop of few balls, compiled once for each instruction set (few_baseline.cpp, few_avx2.cpp).

#include "carom/sim/few_run.hpp"

namespace carom {

template <int D, class Target>
[[nodiscard]] FewKernel<D> few_kernel_of(bool periodic);

extern template FewKernel<2> few_kernel_of<2, Baseline>(bool);
extern template FewKernel<3> few_kernel_of<3, Baseline>(bool);
extern template FewKernel<2> few_kernel_of<2, Avx2>(bool);
extern template FewKernel<3> few_kernel_of<3, Avx2>(bool);

}  // namespace carom
