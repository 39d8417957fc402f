#pragma once
// The same arithmetic compiled twice: with carom's own options, and with contraction on.

namespace rounding {
namespace as_written {
double multiply_add(double a, double b, double c);
void add_product(double* sum, const double* x, const double* y, int n);
}  // namespace as_written
namespace contracted {
double multiply_add(double a, double b, double c);
void add_product(double* sum, const double* x, const double* y, int n);
}  // namespace contracted
}  // namespace rounding
