#include "few_kernel_of.hpp"

namespace carom {
template FewKernel<2> few_kernel_of<2, Avx2>(bool);
template FewKernel<3> few_kernel_of<3, Avx2>(bool);
}  // namespace carom
