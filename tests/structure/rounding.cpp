// a * b + c, to be compiled with and without contraction into one fused multiply-add.

#include "structure/rounding.hpp"

namespace rounding::CAROM_VARIANT {

double multiply_add(double a, double b, double c) { return a * b + c; }

void add_product(double* sum, const double* x, const double* y, int n) {
  for (int i = 0; i < n; ++i) sum[i] += x[i] * y[i];
}

}  // namespace rounding::CAROM_VARIANT
